// SPDX-License-Identifier: MIT
// odas studio: the page that shows, records and configures.
#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "studio_run.hpp"
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "odas/base/error.hpp"
#include "odas/config/edit.hpp"
#include "odas/studio/config_edit.hpp"
#include "odas/studio/own_file.hpp"
#include "odas/studio/session_shelf.hpp"

namespace odas {
namespace {

struct StudioArguments {
  std::string what, address, token, recordings, play;
  bool loop = false, no_qr = false, any_port = false, odas = false;
};

/// The configuration's own section `studio`, as far as it can be read.
StudioConfig section_of(const Document& document) {
  return read_configuration_text(document.text, document.source_name()).config.studio;
}

/// A session's file, or the name of one among the recordings: the page finds it there.
void open_session(StudioOptions& studio, const std::string& what) {
  namespace fs = std::filesystem;
  const fs::path folder = recordings_folder(studio.config.recordings);
  const fs::path file = fs::exists(what) ? fs::path(what) : folder / what;
  if (!fs::exists(file)) throw ConfigError(what, "there is no such session, here or in " + folder.string());
  const fs::path real = fs::canonical(file);
  studio.session = real.filename().string();
  if (!SessionShelf(real.parent_path()).find(studio.session)) {
    throw ConfigError(what, "is no session that a Studio has recorded");
  }
  studio.config.recordings = real.parent_path().string();
}

int serve(const StudioArguments& arguments) {
  StudioRun run;
  StudioConfig& config = run.studio.config;
  const bool session = arguments.what.ends_with(".mcap") && !arguments.odas;
  if (arguments.odas) {
    run.studio.odas.emplace();
    if (!arguments.what.empty()) {
      const Document document = read_document(arguments.what);
      const Configuration sender = read_configuration_text(document.text, document.source_name()).config;
      run.studio.odas = odas_sender(sender, document.name);
      config = sender.studio;
    }
  } else if (!arguments.what.empty() && !session) {
    run.studio.open = read_document(arguments.what);
    config = section_of(*run.studio.open);
  }
  if (!arguments.play.empty()) {
    if (!run.studio.open) throw ConfigError("--play", "wants the array that the recording was made with");
    const auto file = std::filesystem::absolute(arguments.play).string();
    run.studio.open->text = with_source(*run.studio.open, nlohmann::json{{"type", "file"}, {"path", file}});
  }
  if (!arguments.address.empty()) set_address(config, arguments.address);
  if (!arguments.token.empty()) config.token = arguments.token;
  if (!arguments.recordings.empty()) config.recordings = arguments.recordings;
  if (session) open_session(run.studio, arguments.what);
  run.studio.loop = arguments.loop;
  run.qr = !arguments.no_qr;
  run.any_port = arguments.any_port;
  return serve_studio(std::move(run));
}

}  // namespace

void add_studio(CLI::App& app) {
  CLI::App* command = app.add_subcommand("studio", "Serve a page that shows, records and configures");
  auto arguments = std::make_shared<StudioArguments>();
  command
      ->add_option("ARRAY", arguments->what,
                   "Configuration to run: a file, or the name of an array; or a session (.mcap) to look at")
      ->type_name("");
  command
      ->add_option("-l,--listen", arguments->address,
                   "Where to listen; without it 127.0.0.1:8080. Any but this machine's own wants a token")
      ->type_name("ADDRESS:PORT");
  command
      ->add_option("--token", arguments->token,
                   "What a browser must say; away from this machine one is made where none is given")
      ->type_name("TOKEN");
  command->add_option("--recordings", arguments->recordings, "Folder of recordings and sessions")
      ->type_name("FOLDER");
  command
      ->add_option("--play", arguments->play,
                   "Hear this recording, as fast as it was made, in place of raw.interface")
      ->type_name("FILE");
  command->add_flag("--loop", arguments->loop, "Begin a recording anew when it ends");
  CLI::Option* odas =
      command->add_flag("--odas", arguments->odas,
                        "Show a running odaslive of ODAS: listen where it dials. ARRAY is then "
                        "its configuration");
  odas->excludes("--play")->excludes("--loop");
  command->add_flag("--no-qr", arguments->no_qr, "Show no QR code of the link");
  command->add_flag("--any-port", arguments->any_port, "Take another port where this one is taken");
  command->footer(
      "Prints the address for a browser and serves until Ctrl-C. Without ARRAY the page chooses device or\n"
      "file, and array. Of the outputs of the configuration only those of the network are written to: for\n"
      "files and the terminal run 'odas live ARRAY --studio'.\n\n"
      "Examples:\n"
      "  odas studio\n"
      "  odas studio respeaker_usb_4_mic\n"
      "  odas studio sample --play samples/sample_4mic.flac --loop\n"
      "  odas studio --odas odaslive.cfg    (then: odaslive -c odaslive.cfg)\n"
      "  odas studio --listen 0.0.0.0:8080\n");
  command->callback([arguments] {
    if (const int code = serve(*arguments); code != 0) throw ExitCode{code};
  });
}

}  // namespace odas
