// SPDX-License-Identifier: MIT
// Every interface and format, end to end, against peers that are written from ODAS's protocol as its clients
// have it: the parser of odas_web, the reader of odas_ros, nc. What a socket gets is what a file of the same
// run has.
#include <atomic>
#include <future>
#include <map>
#include <thread>

#include "support/net_peer.hpp"
#include "support/old_studio.hpp"
#include "support/small_run.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/ioctl.h>

namespace odas::test::clients_test {
namespace {

using nlohmann::json;

constexpr const char* kNetcat = "/bin/nc";
constexpr std::size_t kFrames = std::size_t{128} * 120;

std::string at(const std::string& type, int port, const std::string& more = "") {
  return fmt::format("type = \"{}\"; ip = \"127.0.0.1\"; port = {}; {}", type, port, more);
}
std::string file(const std::string& name, const std::string& more = "") {
  return fmt::format("type = \"file\"; path = \"{}\"; {}", name, more);
}
/// `interface` and `interfaces` of a stream.
std::string places(const std::vector<std::string>& all) {
  std::string text = "interface: { " + all.at(0) + " }; interfaces = (";
  for (std::size_t i = 1; i < all.size(); ++i) text += (i > 1 ? ", { " : " { ") + all[i] + " }";
  return text + " );";
}

std::string read_for_a_while(const NetPeer& peer) { return peer.receive_all(); }

/// Peers that listen, each in a thread of its own, as ODAS's clients do: they are there before ODAS is.
class Listening {
 public:
  explicit Listening(const std::function<std::string(const NetPeer&)>& read = read_for_a_while)
      : got_(std::async(std::launch::async, [this, read] { return read(listener_.accept()); })) {}
  [[nodiscard]] int port() const noexcept { return listener_.port(); }
  std::string got() { return got_.get(); }

 private:
  NetListener listener_;
  std::future<std::string> got_;
};

class Datagrams {
 public:
  Datagrams() : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    const int room = 1 << 22;
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &room, sizeof room);
    sockaddr_in here{};
    here.sin_family = AF_INET;
    here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof here;
    static_cast<void>(::bind(socket_, reinterpret_cast<const sockaddr*>(&here), size));
    ::getsockname(socket_, reinterpret_cast<sockaddr*>(&here), &size);
    port_ = ntohs(here.sin_port);
  }
  ~Datagrams() { ::close(socket_); }
  Datagrams(const Datagrams&) = delete;
  Datagrams& operator=(const Datagrams&) = delete;
  [[nodiscard]] int port() const noexcept { return port_; }
  /// All that have come.
  [[nodiscard]] std::vector<std::string> got() const {
    std::vector<std::string> all;
    std::string bytes(70000, '\0');
    for (ssize_t n = 0; (n = ::recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT)) > 0;) {
      all.emplace_back(bytes, 0, static_cast<std::size_t>(n));
    }
    return all;
  }

 private:
  int socket_;
  int port_ = 0;
};

/// What comes once is a part of what the file has, from a boundary of records on.
void expect_the_end_of(const std::string& whole, const std::string& part, std::size_t record) {
  ASSERT_FALSE(part.empty());
  ASSERT_TRUE(whole.ends_with(part));
  EXPECT_EQ(part.size() % record, 0U);
}

TEST(Clients, every_interface_and_format_of_text_has_the_bytes_of_the_file) {
  SmallRun run;
  run.record_raw(SmallRun::sound(kFrames));
  Listening tracks, tracks_lines, potentials, binary;
  const Datagrams datagrams;
  run.tracked = "format = \"json\"; " +
                places({file("tracks.json"), at("socket", tracks.port()),
                        at("socket", tracks_lines.port(), "format = \"jsonl\";"),
                        file("tracks.jsonl", "format = \"jsonl\";"), at("udp", datagrams.port()),
                        "type = \"terminal\";", "type = \"blackhole\";"});
  run.potential = "format = \"json\"; " + places({at("socket", potentials.port()), file("pots.json"),
                                                  at("socket", binary.port(), "format = \"binary\";"),
                                                  file("pots.bin", "format = \"binary\";")});
  const ProgramRun live = run.odaslive();
  EXPECT_EQ(live.exit_code, 0) << live.err;
  const std::string json_bytes = run.text("tracks.json");
  EXPECT_GT(json_bytes.size(), 10000U);
  EXPECT_EQ(tracks.got(), json_bytes);
  EXPECT_EQ(live.out, json_bytes);
  EXPECT_EQ(tracks_lines.got(), run.text("tracks.jsonl"));
  EXPECT_EQ(potentials.got(), run.text("pots.json"));
  EXPECT_EQ(binary.got(), run.text("pots.bin"));
  EXPECT_EQ(run.text("pots.bin").size() % 16U, 0U);
  std::string joined;
  for (const std::string& datagram : datagrams.got()) {
    EXPECT_TRUE(datagram.starts_with("{\n    \"timeStamp\": ") && datagram.ends_with("}\n"))
        << "one record each";
    joined += datagram;
  }
  EXPECT_EQ(joined, json_bytes);
}

TEST(Clients, every_interface_of_sound_has_the_bytes_of_the_file) {
  for (const int bits : {8, 16, 24, 32}) {
    SmallRun run;
    run.record_raw(SmallRun::sound(kFrames));
    Listening first, second;
    run.separated = fmt::format("nBits = {}; ", bits) +
                    places({at("socket", first.port()), file("separated.raw"), at("socket", second.port()),
                            "type = \"stdout\";", file("separated.wav")});
    const ProgramRun live = run.odaslive();
    EXPECT_EQ(live.exit_code, 0) << live.err;
    const std::string bytes = run.text("separated.raw");
    EXPECT_EQ(bytes.size(), std::size_t{121} * 128 * 4 * static_cast<std::size_t>(bits) / 8);
    EXPECT_EQ(first.got(), bytes);
    EXPECT_EQ(second.got(), bytes);
    EXPECT_EQ(live.out, bytes);
    EXPECT_EQ(wav_samples(run.file("separated.wav")).size(), bytes.size());
  }
}

/// A run whose sound comes from a socket, so that it lasts as long as a test wants.
class HeldRun {
 public:
  explicit HeldRun(SmallRun& run) : bytes_(run.text("mics.raw")) {
    run.source = fmt::format("type = \"socket\"; ip = \"127.0.0.1\"; port = {};", sound_.port());
    program_ = std::async(std::launch::async, [&run] { return run.odas_live(); });
    to_ = sound_.accept();
  }
  /// The next `hops` of the sound.
  void play(std::size_t hops) {
    const std::size_t count = std::min(hops * 128 * 3 * 2, bytes_.size() - at_);
    EXPECT_TRUE(to_.send(std::string_view(bytes_).substr(at_, count)));
    at_ += count;
  }
  ProgramRun end() {
    to_.close();
    return program_.get();
  }

 private:
  NetListener sound_;
  std::string bytes_;
  std::size_t at_ = 0;
  std::future<ProgramRun> program_;
  NetPeer to_;
};

/// Dials until somebody listens.
NetPeer dial(int port) {
  for (int i = 0; i < 2000; ++i) {
    NetPeer peer = NetPeer::dial(port);
    if (peer.open()) return peer;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return {};
}

/// Reads until so many records of JSON are there.
void read_records(const NetPeer& peer, std::size_t records, std::string& got) {
  const auto count = [&] {
    std::size_t n = 0;
    for (std::size_t i = got.find("\n}\n"); i != std::string::npos; i = got.find("\n}\n", i + 1)) ++n;
    return n;
  };
  while (count() < records) {
    const std::string piece = peer.receive();
    if (piece.empty()) return;
    got += piece;
  }
}

TEST(Clients, many_may_listen_to_a_listening_output_and_come_late) {
  SmallRun run;
  run.record_raw(SmallRun::sound(kFrames));
  const int tracked = free_port(), separated = free_port();
  run.tracked = "format = \"json\"; " + places({file("tracks.json"), at("socket_listen", tracked)});
  run.separated = places({file("separated.raw"), at("socket_listen", separated, "token = \"secret\";")});
  HeldRun held(run);
  std::vector<NetPeer> peers;
  for (int i = 0; i < 3; ++i) peers.push_back(dial(tracked));
  const NetPeer sound = dial(separated), stranger = dial(separated);
  EXPECT_TRUE(sound.send("secret\n"));
  EXPECT_TRUE(stranger.send("sesame\n"));
  std::vector<std::string> got(4);
  held.play(30);
  for (std::size_t i = 0; i < 3; ++i) read_records(peers[i], 29, got[i]);
  peers.push_back(dial(tracked));
  held.play(30);
  for (std::size_t i = 0; i < 3; ++i) read_records(peers[i], 59, got[i]);
  const ProgramRun live = held.end();
  EXPECT_EQ(live.exit_code, 0) << live.err;
  for (std::size_t i = 0; i < 4; ++i) got[i] += peers[i].receive_all();
  const std::string whole = run.text("tracks.json");
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(got[i], whole) << "who was there before the first hop has all";
  expect_the_end_of(whole, got[3], 1);
  EXPECT_TRUE(got[3].starts_with("{\n    \"timeStamp\": "));
  EXPECT_LT(got[3].size(), whole.size());
  expect_the_end_of(run.text("separated.raw"), sound.receive_all(), std::size_t{128} * 4 * 2);
  EXPECT_EQ(stranger.receive_all(), "");
}

/// odas_ros: braces are counted; numbers of a source must be floats to Python.
std::vector<json> parse_like_odas_ros(const std::string& stream) {
  std::vector<json> objects;
  int depth = 0;
  std::string text;
  for (const char c : stream) {
    text += c;
    depth += c == '{' ? 1 : c == '}' ? -1 : 0;
    if (depth != 0 || c != '}') continue;
    objects.push_back(json::parse(text, nullptr, false));
    text.clear();
  }
  return objects;
}

TEST(Clients, odas_web_and_odas_ros_read_each_hop_once) {
  SmallRun run;
  run.record_raw(SmallRun::sound(kFrames));
  Listening tracks, potentials;
  run.tracked = "format = \"json\"; interface: { " + at("socket", tracks.port()) + " };";
  run.potential = "format = \"json\"; interface: { " + at("socket", potentials.port()) + " };";
  const ProgramRun live = run.odaslive();
  EXPECT_EQ(live.exit_code, 0) << live.err;
  const std::map<std::string, std::vector<std::string>> streams{{tracks.got(), {"x", "y", "z", "activity"}},
                                                                {potentials.got(), {"x", "y", "z", "E"}}};
  for (const auto& [stream, keys] : streams) {
    for (const std::size_t chunk : {1U, 7U, 1448U, 65536U}) {
      const std::vector<json> web = parse_like_odas_web(stream, chunk);
      ASSERT_EQ(web.size(), 120U);
      for (std::size_t i = 0; i < web.size(); ++i) {
        ASSERT_FALSE(web[i].is_discarded()) << i;
        EXPECT_EQ(web[i]["timeStamp"], i + 1) << "or it warns of a skipped frame";
        EXPECT_EQ(web[i]["src"].size(), 4U);
      }
    }
    const std::vector<json> ros = parse_like_odas_ros(stream);
    ASSERT_EQ(ros.size(), 121U);
    for (const json& object : ros) {
      ASSERT_FALSE(object.is_discarded());
      for (const json& source : object["src"]) {
        for (const std::string& key : keys) EXPECT_TRUE(source[key].is_number_float()) << key;
      }
    }
  }
}

TEST(Clients, odas_web_and_odas_ros_never_mix_the_channels_up) {
  SmallRun run;
  run.record_raw(SmallRun::sound(kFrames));
  constexpr std::size_t kBlock = std::size_t{128} * 4 * 2;
  std::vector<std::string> chunks;
  int short_reads = 0;
  // odas_web takes what comes; odas_ros asks for just one block, and throws away what is shorter.
  Listening web([&](const NetPeer& peer) {
    for (std::string piece; !(piece = peer.receive(65536)).empty();) chunks.push_back(piece);
    return std::string();
  });
  Listening ros([&](const NetPeer& peer) {
    std::string all;
    for (std::string piece; !(piece = peer.receive(kBlock)).empty();) {
      if (piece.size() == kBlock) {
        all += piece;
      } else {
        ++short_reads;
      }
    }
    return all;
  });
  run.separated = places({file("separated.raw"), at("socket", web.port()), at("socket", ros.port())});
  const ProgramRun live = run.odaslive();
  EXPECT_EQ(live.exit_code, 0) << live.err;
  const std::string bytes = run.text("separated.raw");
  EXPECT_EQ(ros.got(), bytes);
  EXPECT_EQ(short_reads, 0);
  static_cast<void>(web.got());
  const std::vector<std::string> channels = record_like_odas_web(chunks),
                                 expected = record_like_odas_web({bytes});
  for (std::size_t slot = 0; slot < 4; ++slot) EXPECT_EQ(channels[slot], expected[slot]) << slot;
}

bool somebody_listens(int port) {
  const std::string sockets = content("/proc/net/tcp");
  return sockets.find(fmt::format("0100007F:{:04X} 00000000:0000 0A", port)) != std::string::npos;
}

TEST(Clients, nc_is_enough_of_a_server) {
  if (::access(kNetcat, X_OK) != 0) GTEST_SKIP() << "no nc (netcat-openbsd) here";
  SmallRun run;
  run.record_raw(SmallRun::sound(kFrames));
  const int port = free_port();
  auto netcat = std::async(std::launch::async, [port] {
    return run_program({kNetcat, "-d", "-l", "127.0.0.1", std::to_string(port)}, {});
  });
  for (int i = 0; i < 2000 && !somebody_listens(port); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  run.tracked = "format = \"json\"; " + places({file("tracks.json"), at("socket", port)});
  const ProgramRun live = run.odaslive();
  EXPECT_EQ(live.exit_code, 0) << live.err;
  EXPECT_EQ(netcat.get().out, run.text("tracks.json"));
}

TEST(Clients, peers_that_stall_or_vanish_change_nothing_for_the_file_and_the_exit_code) {
  SmallRun run;
  run.record_raw(SmallRun::sound(48000));
  ASSERT_EQ(run.odaslive().exit_code, 0);
  const std::string tracks = run.text("tracks.json"), sound = run.text("separated.raw");
  Listening vanishes([](const NetPeer& peer) { return peer.receive(100); });
  const NetListener sleeps;
  run.tracked = "format = \"json\"; " +
                places({file("tracks.json"), at("socket", vanishes.port()), at("socket", free_port())});
  run.separated = places({file("separated.raw"), at("socket", sleeps.port())});
  const ProgramRun live = run.odaslive();
  EXPECT_EQ(live.exit_code, 0) << live.err;
  EXPECT_EQ(run.text("tracks.json"), tracks);
  EXPECT_EQ(run.text("separated.raw"), sound);
  EXPECT_TRUE(has(live.err, "has gone; dialling again")) << live.err;
  EXPECT_TRUE(has(live.err, "nobody answers at 127.0.0.1:")) << live.err;
  static_cast<void>(vanishes.got());
}

TEST(Clients, a_port_that_is_in_use_is_said_at_the_start) {
  SmallRun run;
  run.record_raw(SmallRun::sound(1280));
  const NetListener other;
  run.tracked = "format = \"json\"; interface: { " + at("socket_listen", other.port()) + " };";
  const ProgramRun taken = run.odas_live();
  EXPECT_EQ(taken.exit_code, 1);
  EXPECT_TRUE(has(taken.err, "another program listens there")) << taken.err;
}

TEST(Clients, a_port_that_needs_privileges_is_said_at_the_start) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may listen at any port";
  SmallRun run;
  run.record_raw(SmallRun::sound(1280));
  run.tracked = "format = \"json\"; interface: { " + at("socket_listen", 80) + " };";
  const ProgramRun privileged = run.odas_live();
  EXPECT_EQ(privileged.exit_code, 1);
  EXPECT_TRUE(has(privileged.err, "need privileges")) << privileged.err;
}

}  // namespace
}  // namespace odas::test::clients_test
