// SPDX-License-Identifier: MIT
// The ways into `odas live` and `odaslive`, as their users take them: a pipe, nc, a peer that comes late,
// garbage.
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <random>
#include <regex>
#include <thread>

#include "support/small_run.hpp"
#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "odas/io/file_descriptor.hpp"
#include "odas/io/tcp_listener.hpp"

namespace odas::test::sources_test {
namespace {

constexpr const char* kNetcat = "/bin/nc";

/// A port that was free a moment ago.
int free_port() { return TcpListener("", 0).port(); }

/// Dials until somebody listens there.
FileDescriptor dial(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  for (int i = 0; i < 2000; ++i) {
    FileDescriptor socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    if (::connect(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0)
      return socket;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ADD_FAILURE() << "nobody listens at " << port;
  return {};
}

void send_all(const FileDescriptor& to, const std::string& bytes, std::size_t step = 100000) {
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t n = ::send(to.get(), bytes.data() + at, std::min(step, bytes.size() - at), MSG_NOSIGNAL);
    if (n <= 0) return;
    at += static_cast<std::size_t>(n);
    step = step % 9973 + 1;
  }
}

/// What the outputs are when the same sound comes from a file.
struct Reference {
  explicit Reference(SmallRun& run) : sound(SmallRun::sound(20000)) {
    run.record_raw(sound);
    EXPECT_EQ(run.odaslive().exit_code, 0);
    tracks = run.text("tracks.json");
    voices = run.text("separated.raw");
    bytes = run.text("mics.raw");
    EXPECT_GT(tracks.size(), 10000U);
  }
  void expect_same(const SmallRun& run) const {
    EXPECT_EQ(run.text("tracks.json"), tracks);
    EXPECT_EQ(run.text("separated.raw"), voices);
  }
  Grid<float> sound;
  std::string tracks, voices, bytes;
};

std::string socket_at(int port) {
  return "type = \"socket\"; ip = \"127.0.0.1\"; port = " + std::to_string(port) + ";";
}
std::string listen_at(int port, const std::string& more = "") {
  return "type = \"socket_listen\"; port = " + std::to_string(port) + "; " + more;
}

TEST(Sources, standard_input_gives_what_a_file_gives) {
  SmallRun run;
  const Reference reference(run);
  run.source = R"(type = "stdin";)";
  const ProgramRun raw = run.odaslive({}, {.input = run.file("mics.raw")});
  EXPECT_EQ(raw.exit_code, 0) << raw.err;
  reference.expect_same(run);
  run.record_wav(reference.sound);
  const ProgramRun wav = run.odaslive({}, {.input = run.file("mics.wav")});
  EXPECT_EQ(wav.exit_code, 0) << wav.err;
  reference.expect_same(run);
}

TEST(Sources, a_peer_that_odaslive_dials_gives_what_a_file_gives_and_ends_the_run_by_closing) {
  SmallRun run;
  const Reference reference(run);
  TcpListener listener("", 0);
  run.source = socket_at(listener.port());
  std::thread peer([&] {
    std::optional<TcpClient> client;
    while (!client) client = listener.accept();
    ::fcntl(client->socket.get(), F_SETFL, 0);
    send_all(client->socket, reference.bytes);
  });
  const ProgramRun live = run.odaslive();
  peer.join();
  EXPECT_EQ(live.exit_code, 0) << live.err;
  reference.expect_same(run);
}

TEST(Sources, a_peer_that_comes_late_is_waited_for) {
  SmallRun run;
  const Reference reference(run);
  const int port = free_port();
  run.source = socket_at(port);
  std::thread peer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    TcpListener listener("", port);
    std::optional<TcpClient> client;
    while (!client) client = listener.accept();
    ::fcntl(client->socket.get(), F_SETFL, 0);
    send_all(client->socket, reference.bytes);
  });
  const ProgramRun live = run.odaslive();
  peer.join();
  EXPECT_EQ(live.exit_code, 0) << live.err;
  EXPECT_TRUE(has(live.err, "cannot reach 127.0.0.1:" + std::to_string(port) + " yet: Connection refused"))
      << live.err;
  EXPECT_TRUE(has(live.err, "connected to")) << live.err;
  reference.expect_same(run);
}

TEST(Sources, a_peer_that_never_comes_does_not_keep_the_program_from_ending) {
  SmallRun run;
  run.source = socket_at(free_port());
  const auto run_briefly = [&](bool odaslive, const std::vector<std::string>& more) {
    std::filesystem::remove(run.file("tracks.json"));
    std::optional<std::chrono::steady_clock::time_point> begun;  // once it has opened its outputs, it listens
    const auto later = [&] {
      const auto now = std::chrono::steady_clock::now();
      if (!begun && std::filesystem::exists(run.file("tracks.json"))) begun = now;
      return begun && now - *begun > std::chrono::milliseconds(300);
    };
    return odaslive ? run.odaslive(more, {.interrupt_when = later})
                    : run.odas_live(more, {.interrupt_when = later});
  };
  for (const auto& program : {run_briefly(true, {}), run_briefly(true, {"-s"}), run_briefly(false, {})}) {
    EXPECT_EQ(program.exit_code, 0) << program.err;
    EXPECT_TRUE(has(program.err, "it is dialled until it answers")) << program.err;
  }
}

TEST(Sources, nc_can_send_to_a_listening_odas) {
  if (::access(kNetcat, X_OK) != 0) GTEST_SKIP() << "no nc (netcat-openbsd) here";
  SmallRun run;
  const Reference reference(run);
  const int port = free_port();
  run.source = listen_at(port);
  std::thread sender([&] {
    // -N: closes when its input ends, as nc's of other families do by themselves.
    for (int i = 0; i < 500; ++i) {
      const ProgramRun nc = run_program({kNetcat, "-N", "127.0.0.1", std::to_string(port)},
                                        {.input = run.file("mics.raw"), .seconds = 30});
      if (nc.exit_code == 0) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    ADD_FAILURE() << "nobody listens";
  });
  const ProgramRun live = run.odaslive();
  sender.join();
  EXPECT_EQ(live.exit_code, 0) << live.err;
  EXPECT_TRUE(has(live.err, "receiving from 127.0.0.1:")) << live.err;
  reference.expect_same(run);
}

TEST(Sources, senders_may_come_and_go_and_send_garbage) {
  SmallRun run;
  const int port = free_port();
  run.source = listen_at(port, "reconnect = true; token = \"secret\";");
  std::atomic<bool> over{false};
  std::thread peers([&] {
    send_all(dial(port), "GET / HTTP/1.0\r\n\r\n");
    const std::string garbage = [] {
      std::mt19937 random(3);
      std::string bytes(200001, ' ');
      for (char& byte : bytes) byte = static_cast<char>(random());
      return bytes;
    }();
    for (int turn = 0; turn < 5; ++turn) {
      const FileDescriptor sender = dial(port);
      send_all(sender, "secret\n");
      send_all(sender, garbage, 777);
      // Half of them die: a close with a reset.
      const linger now{turn % 2, 0};
      ::setsockopt(sender.get(), SOL_SOCKET, SO_LINGER, &now, sizeof now);
      std::this_thread::sleep_for(std::chrono::milliseconds(150));
    }
    over = true;
  });
  const ProgramRun live = run.odas_live({"-v"}, {.interrupt_when = [&] { return over.load(); }});
  peers.join();
  EXPECT_EQ(live.exit_code, 0) << live.err;
  EXPECT_TRUE(has(live.err, "was turned away: it did not begin with the token")) << live.err;
  EXPECT_TRUE(has(live.err, "it is waited for")) << live.err;
  // Noise of full scale, and all of it in step: whole hops of the right shape came out.
  EXPECT_EQ(run.text("separated.raw").size() % (4 * 2 * 128), 0U);
  EXPECT_GT(run.text("tracks.json").size(), 10000U);
}

TEST(Sources, a_port_that_is_taken_is_said) {
  SmallRun run;
  const TcpListener taken("", 0);
  run.source = listen_at(taken.port());
  const ProgramRun live = run.odas_live();
  EXPECT_EQ(live.exit_code, 1);
  EXPECT_TRUE(has(live.err, "cannot listen at 127.0.0.1:" + std::to_string(taken.port()))) << live.err;
}

TEST(Sources, a_paced_recording_takes_its_time_and_gives_the_same) {
  SmallRun run;
  const Reference reference(run);
  run.source = R"(type = "file"; path = "mics.raw"; paced = true;)";
  const auto start = std::chrono::steady_clock::now();
  const ProgramRun live = run.odaslive();
  EXPECT_EQ(live.exit_code, 0) << live.err;
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(1240)) << "it has 1.25 s";
  reference.expect_same(run);
}

TEST(Sources, the_microphones_can_be_kept_while_a_run_goes_on) {
  SmallRun run;
  const Reference reference(run);
  run.source += " }; record: { interface: { type = \"file\"; path = \"kept.raw\"; };";
  EXPECT_EQ(run.odaslive().exit_code, 0);
  EXPECT_EQ(run.text("kept.raw"), reference.bytes);
  EXPECT_EQ(run.odaslive({"-s"}).exit_code, 0);
  EXPECT_EQ(run.text("kept.raw"), reference.bytes);
}

TEST(Sources, a_sound_card_that_is_not_there_is_named) {
  SmallRun run;
  run.source = R"(type = "soundcard"; card = 31; device = 0;)";
  for (const auto& program : {run.odaslive(), run.odas_live()}) {
    EXPECT_EQ(program.exit_code, 1);
    EXPECT_TRUE(has(program.err, "hw:31,0")) << program.err;
    EXPECT_EQ(program.out, "");
  }
}

/// ODAS's own sixteen, unchanged: on a machine without their devices they say which one is missing.
TEST(Sources, every_file_of_odas_starts_or_names_what_is_missing) {
  const char* shared = std::getenv("ODAS_SHARED");
  const std::filesystem::path folder =
      (shared != nullptr ? std::filesystem::path(shared)
                         : std::filesystem::path(ODAS_SOURCE_DIR) / "../shared") /
      "odas-configs";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "no " << folder;
  const std::regex named(
      R"(cannot open (the sound card (hw:\d+,\d+|\w+)|the source \S+ of PulseAudio|\w+\.raw))");
  int files = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() != ".cfg") continue;
    ++files;
    for (const char* program : {"odaslive", "odas"}) {
      const Scratch scratch;
      std::vector<std::string> command{program_path(program), "-c", file.path().string()};
      if (std::string(program) == "odas") command.insert(command.begin() + 1, "live");
      const auto start = std::chrono::steady_clock::now();
      const ProgramRun run = run_program(
          command, {.working_directory = scratch.folder(), .interrupt_when = [&] {
                      return std::chrono::steady_clock::now() - start > std::chrono::milliseconds(500);
                    }});
      EXPECT_TRUE(run.exit_code == 0 || std::regex_search(run.err, named))
          << program << ' ' << file.path().filename() << ": " << run.exit_code << ' ' << run.err;
    }
  }
  EXPECT_EQ(files, 16);
}

}  // namespace
}  // namespace odas::test::sources_test
