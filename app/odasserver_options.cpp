// SPDX-License-Identifier: MIT
#include "odasserver_options.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <optional>
#include <vector>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <getopt.h>

#include "odas/base/error.hpp"
#include "odas/base/host.hpp"
#include "odas/config/array_library.hpp"
#include "odas/config/reader.hpp"

namespace odas {

const char* const kServerHelp =
    "Usage: odasserver [OPTIONS]\n"
    "\n"
    "Receives what ODAS or odas sends by sockets (interface type \"socket\"), and keeps it: sound as WAV, "
    "tracks\n"
    "and potentials as JSON lines, one folder a run. Shows who is there. Ctrl-C ends it, and finishes all "
    "files.\n"
    "\n"
    "Options:\n"
    "  -o,--out FOLDER         Folder for this run, empty or not there yet; odasserver_DATE_TIME if not "
    "given\n"
    "  -c,--config FILE        Take ports, rate, channels and bits from the configuration of the sender\n"
    "  --tracked PORT          9000 if not given; \"off\": do not listen; 0: any port that is free\n"
    "  --potential PORT        9001\n"
    "  --category PORT         9002\n"
    "  --separated PORT        10000\n"
    "  --postfiltered PORT     10010\n"
    "  --rate HZ               Rate of the sound: 44100 if not given\n"
    "  --channels N            Its channels: 4\n"
    "  --bits N                Its bits: 8, 16, 24 or 32; 16 if not given\n"
    "  --listen ADDRESS        127.0.0.1 if not given; any other wants --allow\n"
    "  --allow ADDRESS         Who may send from another machine; may be given several times\n"
    "  -q,--quiet              Do not show who is there\n"
    "  -h,--help               This help\n"
    "  --version               Version\n"
    "\n"
    "ODAS's streams have no place for a token: whoever has an address that is allowed may send.\n"
    "\n"
    "Examples:\n"
    "  odasserver\n"
    "  odasserver -c respeaker.cfg -o meeting\n"
    "  odasserver --listen 0.0.0.0 --allow robot.local --rate 16000\n"
    "\n"
    "Exit codes: 0 Ctrl-C; 1 something failed; 2 wrong usage or configuration.\n";

namespace {

constexpr std::array<int, kStreams> kUsualPorts{9000, 9001, 9002, 10000, 10010};
constexpr int kHighestRate = 768000, kMostChannels = 1024;
enum : int { kTracked = 256, kRate = kTracked + kStreams, kChannels, kBits, kListen, kAllow, kVersion };

constexpr std::array kLong{option{"out", required_argument, nullptr, 'o'},
                           option{"config", required_argument, nullptr, 'c'},
                           option{"tracked", required_argument, nullptr, kTracked},
                           option{"potential", required_argument, nullptr, kTracked + 1},
                           option{"category", required_argument, nullptr, kTracked + 2},
                           option{"separated", required_argument, nullptr, kTracked + 3},
                           option{"postfiltered", required_argument, nullptr, kTracked + 4},
                           option{"rate", required_argument, nullptr, kRate},
                           option{"channels", required_argument, nullptr, kChannels},
                           option{"bits", required_argument, nullptr, kBits},
                           option{"listen", required_argument, nullptr, kListen},
                           option{"allow", required_argument, nullptr, kAllow},
                           option{"quiet", no_argument, nullptr, 'q'},
                           option{"help", no_argument, nullptr, 'h'},
                           option{"version", no_argument, nullptr, kVersion},
                           option{nullptr, 0, nullptr, 0}};

/// What the words say; what they leave open comes from the configuration, or is usual.
struct Words {
  std::string config;
  std::array<std::optional<std::optional<int>>, kStreams> ports;  // said at all; a number or "off"
  std::optional<int> rate, channels, bits;
};

class Faults {
 public:
  void add(const std::string& where, const std::string& what) {
    all_.push_back({Fault::Severity::error, "", where + " " + what, "", 0});
  }
  /// A whole number of the range, or a fault.
  std::optional<int> number(const std::string& name, std::string_view text, int lowest, int highest) {
    int value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error == std::errc() && stop == end && value >= lowest && value <= highest) return value;
    add("--" + name, fmt::format("is \"{}\"; {} to {} is right", text, lowest, highest));
    return std::nullopt;
  }
  void raise() {
    if (!all_.empty()) throw ConfigError(std::move(all_));
  }

 private:
  std::vector<Fault> all_;
};

void take_word(int name, const char* value, ServerOptions& options, Words& words, Faults& faults) {
  if (name == 'o') options.folder = value;
  if (name == 'c') words.config = value;
  if (name == 'q') options.quiet = true;
  if (name == 'h') options.help = true;
  if (name == kVersion) options.version = true;
  if (name == kListen) options.server.listen = value;
  if (name == kAllow) options.server.allow.emplace_back(value);
  if (name == kRate) words.rate = faults.number("rate", value, 1, kHighestRate);
  if (name == kChannels) words.channels = faults.number("channels", value, 1, kMostChannels);
  if (name == kBits) {
    words.bits = faults.number("bits", value, 8, 32);
    if (words.bits && *words.bits % 8 != 0) faults.add("--bits", "is 8, 16, 24 or 32");
  }
  if (name >= kTracked && name < kRate) {
    const auto stream = static_cast<std::size_t>(name - kTracked);
    words.ports[stream] = std::string_view(value) == "off"
                              ? std::nullopt
                              : faults.number(kStreamNames[stream], value, 0, 65535);
  }
}

/// The first port that the sender dials for a stream, if it does.
template <class Output>
std::optional<int> dialled(const Output& output, const char* name) {
  for (const Place& place : places_of(name, output)) {
    if (place.interface->type == "socket") return place.interface->port;
  }
  for (const Place& place : places_of(name, output)) {
    if (place.interface->type != "socket_listen") continue;
    std::fprintf(stderr, "odasserver: %s listens itself (socket_listen): nothing of it comes here\n",
                 place.path.c_str());
  }
  return std::nullopt;
}

void take_configuration(const Configuration& config, ServerOptions& options) {
  StreamServerConfig& server = options.server;
  server.ports = {dialled(config.tracked, "sst.tracked"), dialled(config.potential, "ssl.potential"),
                  dialled(config.category, "classify.category"), dialled(config.separated, "sss.separated"),
                  dialled(config.postfiltered, "sss.postfiltered")};
  const std::size_t channels = config.pipeline.sst.slots();
  server.separated = {config.separated.fs, channels, config.separated.n_bits};
  server.postfiltered = {config.postfiltered.fs, channels, config.postfiltered.n_bits};
  const GeneralConfig& general = config.pipeline.general;
  options.hop_seconds = static_cast<double>(general.size.hop_size) / general.samplerate.mu;
}

std::string folder_of_now() {
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("odasserver_{:%Y-%m-%d_%H-%M-%S}", fmt::localtime(now));
}

}  // namespace

ServerOptions parse_server_options(int argc, char** argv) {
  ServerOptions options;
  Words words;
  Faults faults;
  opterr = 0;
  for (int name = 0; (name = getopt_long(argc, argv, "o:c:qh", kLong.data(), nullptr)) != -1;) {
    if (name == '?') {
      const std::string word = argv[optind - 1];
      faults.add(word, optopt != 0 && optopt != '?' ? "is not known, or wants a value" : "is not known");
    } else {
      take_word(name, optarg, options, words, faults);
    }
  }
  for (int i = optind; i < argc; ++i) faults.add(argv[i], "is no option: odasserver takes options alone");
  if (options.help || options.version) return options;
  if (!is_loopback_host(options.server.listen) && options.server.allow.empty()) {
    faults.add("--listen",
               "is open to a network: say by --allow ADDRESS who may send, for ODAS's streams "
               "have no place for a token");
  }
  faults.raise();

  StreamServerConfig& server = options.server;
  for (std::size_t s = 0; s < kStreams; ++s) server.ports[s] = kUsualPorts[s];
  if (!words.config.empty()) {
    const LoadedConfiguration loaded = load_configuration(find_configuration(words.config));
    for (const Fault& fault : loaded.faults) std::fprintf(stderr, "%s\n", to_string(fault).c_str());
    take_configuration(loaded.config, options);
  }
  for (std::size_t s = 0; s < kStreams; ++s) {
    if (words.ports[s]) server.ports[s] = *words.ports[s];
  }
  for (WavWriter::Format* format : {&server.separated, &server.postfiltered}) {
    if (words.rate) format->sample_rate = *words.rate;
    if (words.channels) format->channels = static_cast<std::size_t>(*words.channels);
    if (words.bits) format->bits = *words.bits;
  }
  const auto is_off = [](const std::optional<int>& port) { return !port; };
  if (std::all_of(server.ports.begin(), server.ports.end(), is_off)) {
    faults.add(words.config.empty() ? "odasserver" : words.config,
               "sends nothing by \"socket\": there is no port to listen at");
    faults.raise();
  }
  if (options.folder.empty()) options.folder = folder_of_now();
  return options;
}

}  // namespace odas
