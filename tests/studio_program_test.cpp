// SPDX-License-Identifier: MIT
// The Studio as a user starts it: what it says, who may come in, what it tells whom, and the examples of the
// docs.
#include <atomic>
#include <thread>

#include "support/scratch.hpp"
#include "support/studio_daemon.hpp"
#include "support/web_client.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sndfile.hh>

namespace odas::test::studio_program_test {
namespace {

using nlohmann::json;

std::string in_tree(const std::string& path) { return std::string(ODAS_SOURCE_DIR) + "/" + path; }

/// The sample recording, over and over at its real pace: what `make demo` serves.
std::vector<std::string> demo(const Scratch& scratch, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{
      "studio",       in_tree("configs/sample.cfg"), "--play", in_tree("samples/sample_4mic.flac"), "--loop",
      "--recordings", scratch.folder().string()};
  if (std::find(more.begin(), more.end(), "--listen") == more.end()) {
    arguments.insert(arguments.end(), {"--listen", "127.0.0.1:0"});
  }
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// The page is there before the first hop is.
bool hears(const StudioDaemon& daemon) {
  return eventually([&] { return metric(http_get(daemon.port(), "/metrics").body, "odas_hops_total") > 20; });
}

/// What the method called last gave back.
json result(WebClient& client) {
  const json reply = next(client, "reply");
  if (!reply.contains("result")) ADD_FAILURE() << reply;
  return reply.value("result", json::object());
}

TEST(StudioProgram, shows_the_first_track_of_the_demonstration_within_two_seconds_of_its_sound) {
  const Scratch scratch;
  StudioDaemon daemon(demo(scratch));
  ASSERT_NE(daemon.port(), 0) << daemon.said();
  const auto ready = std::chrono::steady_clock::now();
  WebClient client(daemon.port());
  client.send(R"({"type":"subscribe","topics":{"hops":60}})");
  for (;;) {
    const json hops = next(client, "hops");
    ASSERT_TRUE(hops.is_object());
    for (const json& hop : hops.at("hops")) {
      if (hop.at("tracks").empty()) continue;
      const double sound = hop.at("t").get<double>() * 128 / 16000;
      EXPECT_LT(sound, 2);
      const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - ready;
      fmt::print("first track after {:.2f} s of sound, {:.2f} s after the daemon was ready\n", sound,
                 waited.count());
      EXPECT_EQ(daemon.stop().exit_code, 0);
      return;
    }
  }
}

TEST(StudioProgram, tells_health_and_metrics_and_how_it_ends) {
  const Scratch scratch;
  StudioDaemon daemon(demo(scratch));
  ASSERT_NE(daemon.port(), 0) << daemon.said();
  EXPECT_EQ(http_get(daemon.port(), "/healthz").status, 200);
  ASSERT_TRUE(hears(daemon)) << daemon.said();
  const std::string metrics = http_get(daemon.port(), "/metrics").body;
  for (const char* name : {"odas_hop_seconds_p99", "odas_real_time_share", "odas_resident_memory_bytes"}) {
    EXPECT_GT(metric(metrics, name), 0) << name;
  }
  EXPECT_EQ(metric(metrics, "odas_dropped_hops_total"), 0);
  EXPECT_EQ(json::parse(http_get(daemon.port(), "/api/v1/info").body).at("run").at("name"), "sample");
  EXPECT_EQ(daemon.stop().exit_code, 0) << "Ctrl-C is no failure";
}

TEST(StudioProgram, gives_a_network_a_link_with_a_token_and_a_terminal_a_code_to_photograph) {
  const Scratch scratch;
  ProgramOptions terminal;
  terminal.terminal = true;
  StudioDaemon daemon(demo(scratch, {"--listen", "0.0.0.0:0"}), terminal);
  ASSERT_NE(daemon.port(), 0) << daemon.said();
  const std::size_t token = daemon.url().find("/?token=");
  ASSERT_NE(token, std::string::npos) << daemon.url();
  EXPECT_EQ(http_get(daemon.port(), "/").status, 401);
  EXPECT_EQ(http_get(daemon.port(), daemon.url().substr(token)).status, 303);
  EXPECT_EQ(daemon.url().find("0.0.0.0"), std::string::npos) << "an address that others can go to";
#ifdef ODAS_WITH_QRENCODE
  EXPECT_TRUE(eventually([&] { return daemon.said().find("\u2580") != std::string::npos; })) << daemon.said();
#endif
}

TEST(StudioProgram, shows_no_code_where_nobody_needs_one) {
  const Scratch scratch;
  ProgramOptions terminal;
  terminal.terminal = true;
  StudioDaemon daemon(demo(scratch), terminal);
  ASSERT_NE(daemon.port(), 0);
  EXPECT_EQ(daemon.stop().err.find("\u2580"), std::string::npos);
}

TEST(StudioProgram, shows_a_session_wherever_its_file_lies) {
  const Scratch scratch;
  std::string name;
  {
    StudioDaemon daemon(demo(scratch));
    ASSERT_NE(daemon.port(), 0) << daemon.said();
    ASSERT_TRUE(hears(daemon)) << daemon.said();
    WebClient client(daemon.port());
    client.send(R"({"id":1,"method":"record.start","params":{"what":"session"}})");
    name = result(client).value("name", "");
    client.send(R"({"id":2,"method":"record.stop","params":{"all":true}})");
    EXPECT_EQ(result(client).value("names", json()), json::array({name}));
  }
  StudioDaemon daemon({"studio", (scratch / name).string(), "--listen", "127.0.0.1:0"});
  ASSERT_NE(daemon.port(), 0) << daemon.said();
  EXPECT_EQ(json::parse(http_get(daemon.port(), "/api/v1/info").body).at("open_session"), name);
  EXPECT_EQ(http_get(daemon.port(), "/api/v1/sessions/" + name).status, 200);
}

TEST(StudioProgram, says_what_is_no_session) {
  const Scratch scratch;
  write_file(scratch / "words.mcap", "words");
  for (const auto& [file, why] :
       {std::pair("words.mcap", "is no session"), {"none.mcap", "there is no such"}}) {
    const ProgramRun run = run_program({program_path("odas"), "studio", (scratch / file).string()});
    EXPECT_EQ(run.exit_code, 2) << file;
    EXPECT_NE(run.err.find(why), std::string::npos) << run.err;
  }
}

TEST(StudioProgram, says_that_it_waits_for_a_choice_where_it_was_given_nothing) {
  StudioDaemon daemon({"studio", "--listen", "127.0.0.1:0"});
  ASSERT_NE(daemon.port(), 0) << daemon.said();
  EXPECT_TRUE(eventually([&] { return daemon.said().find("choose a device") != std::string::npos; }));
}

TEST(StudioProgram, speaks_tls_with_the_files_that_it_is_given) {
  const Scratch scratch;
  const std::string key = (scratch / "key.pem").string(), certificate = (scratch / "cert.pem").string();
  const ProgramRun made =
      run_program({"/usr/bin/openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-keyout", key,
                   "-out", certificate, "-days", "1", "-subj", "/CN=localhost"});
  if (made.exit_code == 127) GTEST_SKIP() << "no openssl here";
  ASSERT_EQ(made.exit_code, 0) << made.err;
  write_file(scratch / "tls.cfg",
             content(in_tree("configs/sample.cfg")) +
                 fmt::format("\nstudio: {{ certificate = \"{}\"; key = \"{}\"; }};\n", certificate, key));
  std::filesystem::copy(in_tree("configs/common"), scratch / "common");
  StudioDaemon daemon({"studio", (scratch / "tls.cfg").string(), "--play",
                       in_tree("samples/sample_4mic.flac"), "--listen", "127.0.0.1:0", "--recordings",
                       scratch.folder().string()});
  ASSERT_NE(daemon.port(), 0) << daemon.said();
  EXPECT_TRUE(daemon.url().starts_with("https://")) << daemon.url();
  write_file(scratch / "request", fmt::format("GET /healthz HTTP/1.1\r\nHost: localhost:{}\r\n"
                                              "Connection: close\r\n\r\n",
                                              daemon.port()));
  ProgramOptions input;
  input.input = scratch / "request";
  const ProgramRun answer =
      run_program({"/usr/bin/openssl", "s_client", "-quiet", "-verify_return_error", "-CAfile", certificate,
                   "-connect", fmt::format("127.0.0.1:{}", daemon.port())},
                  input);
  EXPECT_NE(answer.out.find("HTTP/1.1 200 OK"), std::string::npos) << answer.out << answer.err;
  EXPECT_EQ(http_get(daemon.port(), "/").status, 0) << "who does not speak TLS gets nothing";
}

TEST(StudioProgram, tells_an_address_of_the_users_who_comes_and_has_a_program_write_down_what_is_said) {
  const Scratch scratch;
  const NetListener web;
  write_file(
      scratch / "told.cfg",
      content(in_tree("configs/sample.cfg")) +
          fmt::format(
              "\nstudio: {{ events: {{ url = \"http://127.0.0.1:{}/told\"; }};\n"
              "  speech: {{ command = \"head -c 16000 >/dev/null; echo "
              "'{{\\\"text\\\":\\\"good morning\\\",\\\"final\\\":true}}'; cat >/dev/null\"; }}; }};\n",
              web.port()));
  std::filesystem::copy(in_tree("configs/common"), scratch / "common");
  StudioDaemon daemon({"studio", (scratch / "told.cfg").string(), "--play",
                       in_tree("samples/sample_4mic.flac"), "--listen", "127.0.0.1:0", "--recordings",
                       scratch.folder().string()});
  ASSERT_NE(daemon.port(), 0) << daemon.said();
  WebClient client(daemon.port());
  const json hello = next(client, "hello");
  const json& capabilities = hello.at("capabilities");
  EXPECT_NE(std::find(capabilities.begin(), capabilities.end(), "transcripts"), capabilities.end());
  client.send(R"({"type":"subscribe","topics":{"transcripts":1}})");
  const NetPeer told = web.accept();
  ASSERT_TRUE(told.open()) << "nobody was told of the first source";
  std::string post;
  while (post.find("\"appear\"") == std::string::npos) {
    const std::string piece = told.receive();
    ASSERT_FALSE(piece.empty()) << post;
    post += piece;
  }
  EXPECT_TRUE(post.starts_with("POST /told HTTP/1.1\r\n")) << post;
  told.send("HTTP/1.1 204 No Content\r\n\r\n");
  EXPECT_EQ(next(client, "transcript").at("text"), "good morning");
}

TEST(StudioProgram, shows_a_running_odaslive_of_odas) {
  const Scratch scratch;
  std::vector<int> ports;
  for (int i = 0; i < 4; ++i) ports.push_back(free_port());
  const auto place = [&](std::size_t i) {
    return fmt::format("interface: {{ type = \"socket\"; ip = \"127.0.0.1\"; port = {}; }};", ports[i]);
  };
  write_file(
      scratch / "odas.cfg",
      fmt::format("raw: {{ fS = 16000; hopSize = 128; nBits = 16; nChannels = 4;\n"
                  "  interface: {{ type = \"file\"; path = \"sample.wav\"; paced = true; }}; }};\n"
                  "general: {{ mics = ( {{ mu = (-0.032, 0.0, 0.0); }}, {{ mu = (0.0, -0.032, 0.0); }},\n"
                  "  {{ mu = (0.032, 0.0, 0.0); }}, {{ mu = (0.0, 0.032, 0.0); }} ); }};\n"
                  "ssl: {{ potential: {{ format = \"json\"; {} }}; }};\n"
                  "sst: {{ tracked: {{ format = \"json\"; {} }}; }};\n"
                  "sss: {{ separated: {{ {} }}; postfiltered: {{ {} }}; }};\n",
                  place(1), place(0), place(2), place(3)));
  SndfileHandle sample(in_tree("samples/sample_4mic.flac"));
  std::vector<std::int16_t> sound(16000U * 4U * 4U);
  sample.readf(sound.data(), 64000);
  {
    SndfileHandle wav((scratch / "sample.wav").string(), SFM_WRITE, SF_FORMAT_WAV | SF_FORMAT_PCM_16, 4,
                      16000);
    wav.writef(sound.data(), 64000);
  }
  StudioDaemon daemon({"studio", "--odas", (scratch / "odas.cfg").string(), "--listen", "127.0.0.1:0",
                       "--recordings", scratch.folder().string()});
  ASSERT_NE(daemon.port(), 0) << daemon.said();
  WebClient client(daemon.port());
  client.send(R"({"type":"subscribe","topics":{"hops":60}})");
  EXPECT_EQ(next(client, "engine").at("state"), "waiting");
  ProgramOptions there;
  there.working_directory = scratch.folder();
  const ProgramRun odas = run_program({program_path("odaslive"), "-c", "odas.cfg"}, there);
  EXPECT_EQ(odas.exit_code, 0) << odas.err;
  const json run = next(client, "hello").at("run");
  EXPECT_EQ(run.at("kind"), "odas");
  EXPECT_EQ(run.at("mics").size(), 4U) << "of its configuration";
  // The first hops may go before a dialled connection stands: who dials waits for nobody.
  EXPECT_LE(next(client, "hops").at("hops").at(0).at("t"), 10);
}

/// Runs a client for a few seconds in a folder of its own; what it says and keeps.
void expect_it_hears(const std::vector<std::string>& command, const Scratch& scratch) {
  ProgramOptions there;
  there.working_directory = scratch.folder();
  const ProgramRun client = run_program(command, there);
  if (client.exit_code == 127) GTEST_SKIP() << command[1] << " is not here";
  if (client.err.find("bad option") != std::string::npos ||
      client.err.find("WebSocket is not defined") != std::string::npos) {
    GTEST_SKIP() << "this Node has no WebSocket";
  }
  EXPECT_EQ(client.exit_code, 0) << client.err;
  const std::size_t at = client.out.find("source ");
  ASSERT_NE(at, std::string::npos) << client.out << client.err;
  const std::string id = client.out.substr(at + 7, client.out.find(' ', at + 7) - at - 7);
  SndfileHandle voice((scratch / ("voice_" + id + ".wav")).string());
  EXPECT_EQ(voice.samplerate(), 16000);
  EXPECT_GT(voice.frames(), 8000) << client.out;
}

TEST(StudioExamples, the_client_in_python_hears) {
  const Scratch scratch, kept;
  StudioDaemon daemon(demo(scratch));
  expect_it_hears({"/usr/bin/env", "python3", in_tree("docs/examples/studio_client.py"), daemon.url(), "5"},
                  kept);
}

TEST(StudioExamples, the_client_in_javascript_hears) {
  const Scratch scratch, kept;
  StudioDaemon daemon(demo(scratch));
  expect_it_hears({"/usr/bin/env", "node", "--experimental-websocket",
                   in_tree("docs/examples/studio_client.mjs"), daemon.url(), "5"},
                  kept);
}

TEST(StudioExamples, are_of_sixty_lines) {
  for (const char* file : {"docs/examples/studio_client.py", "docs/examples/studio_client.mjs"}) {
    const std::string text = content(in_tree(file));
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 60) << file;
  }
}

}  // namespace
}  // namespace odas::test::studio_program_test
