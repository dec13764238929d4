// SPDX-License-Identifier: MIT
#include <fstream>
#include <set>

#include "support/fake_io.hpp"
#include "support/scratch.hpp"
#include "support/web_client.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "odas/base/error.hpp"
#include "odas/studio/server.hpp"

namespace odas {
namespace {

using nlohmann::json;
using test::http_exchange;
using test::http_get;
using test::HttpAnswer;
using test::WebClient;

constexpr std::size_t kSlots = 4, kHop = 128;

/// A run of silence with one source, number 7, in slot 1.
class FakeRun {
 public:
  FakeRun() {
    info.run = 1;
    info.name = "test array";
    info.slots = kSlots;
    info.hop_size = kHop;
    info.mics.resize(2);
    info.start = std::chrono::system_clock::now();
    hop.potentials.resize(2);
    hop.tracks.resize(kSlots);
    hop.tracks[1] = {.id = 7, .tag = "dynamic", .direction = {0, 1, 0}, .activity = 0.5F};
    hop.separated = hop.postfiltered = Grid<float>(kSlots, kHop);
    mics = Grid<float>(2, kHop);
  }
  HopResult next() {
    HopResult result = hop.result(++time);
    result.mics = mics;
    result.power = power;
    return result;
  }
  StreamInfo info;
  test::HopOfHand hop;
  Grid<float> mics;
  std::vector<float> power{0.5F, 0.25F};
  HopIndex time = 0;
};

/// Knows one file and one text.
class FakeFiles final : public FileProvider {
 public:
  explicit FakeFiles(std::filesystem::path file) : file_(std::move(file)) {}
  std::optional<Served> find(std::string_view path, const Query& query) override {
    if (path == "/api/v1/recordings/a b.wav") return Served{file_, false, "", "audio/wav", "a b.wav"};
    if (path == "/api/v1/export/csv") return Served{{}, false, query.find("session")->second, "text/csv", ""};
    return std::nullopt;
  }

 private:
  std::filesystem::path file_;
};

class ServerTest : public testing::Test {
 protected:
  static StudioConfig any_port() {
    StudioConfig config;
    config.port = 0;
    return config;
  }
  StudioServer& serve(const StudioConfig& config = any_port()) {
    ServerHooks hooks;
    hooks.say = [this](const std::string& what) { said.insert(what); };
    hooks.failure = [this] { return failure; };
    server = std::make_unique<StudioServer>(config, rpc, std::vector<FileProvider*>{&files}, hooks);
    return *server;
  }
  /// The next message of this type, others are passed over.
  static json next(WebClient& client, const std::string& type) {
    while (const auto message = client.next()) {
      if (message->opcode != 1) continue;
      json parsed = json::parse(message->payload);
      if (parsed.at("type") == type) return parsed;
    }
    ADD_FAILURE() << "no message '" << type << "' came";
    return {};
  }

  test::Scratch scratch;
  RpcRegistry rpc;
  FakeFiles files{scratch / "a.wav"};
  std::multiset<std::string> said;
  std::string failure;
  std::unique_ptr<StudioServer> server;
};

TEST_F(ServerTest, gives_the_page_compressed_where_that_is_understood) {
  const int port = serve().port();
  const HttpAnswer plain = http_get(port, "/");
  EXPECT_EQ(plain.status, 200);
  EXPECT_EQ(plain.header("content-type"), "text/html; charset=utf-8");
  EXPECT_NE(plain.body.find("<html"), std::string::npos);
  const HttpAnswer packed = http_get(port, "/", "Accept-Encoding: gzip\r\n");
  EXPECT_EQ(packed.header("content-encoding"), "gzip");
  EXPECT_EQ(packed.body.substr(0, 2), "\x1F\x8B");
  EXPECT_EQ(http_get(port, "/", "If-None-Match: " + plain.header("etag") + "\r\n").status, 304);
  EXPECT_EQ(http_get(port, "/favicon.svg").status, 200);
}

TEST_F(ServerTest, lets_a_page_do_nothing_that_it_need_not) {
  const HttpAnswer page = http_get(serve().port(), "/");
  EXPECT_TRUE(page.header("content-security-policy").starts_with("default-src 'none'; script-src 'self';"));
  EXPECT_EQ(page.header("x-content-type-options"), "nosniff");
  EXPECT_EQ(page.header("referrer-policy"), "no-referrer");
}

TEST_F(ServerTest, has_no_path_out_of_the_page) {
  const int port = serve().port();
  for (const char* path :
       {"/../../etc/passwd", "/..%2f..%2fetc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "//etc/passwd",
        "/index.html/../../x", "/api/v1/recordings/..%2f..%2fetc%2fpasswd", "/%00", "/%zz"}) {
    EXPECT_EQ(http_get(port, path).status, 404) << path;
  }
}

TEST_F(ServerTest, refuses_names_and_pages_of_others) {
  const int port = serve().port();
  const std::string at = std::to_string(port);
  EXPECT_EQ(http_get(port, "/", "Host: evil.example:" + at + "\r\n").status, 403);
  EXPECT_EQ(http_get(port, "/", "Origin: http://evil.example\r\n").status, 403);
  EXPECT_EQ(http_get(port, "/", "Origin: null\r\n").status, 403);
  EXPECT_EQ(http_get(port, "/", "Origin: http://127.0.0.1:" + at + "\r\n").status, 200);
  EXPECT_EQ(http_get(port, "/", "Host: localhost:" + at + "\r\n").status, 200);
  EXPECT_FALSE(WebClient(port, "/api/v1/live", "Origin: http://evil.example\r\n").open());
  EXPECT_FALSE(WebClient(port, "/api/v1/live", "Host: evil.example\r\n").open());
  EXPECT_EQ(said.size(), 2U) << "each kind of refusal is said once";
}

TEST_F(ServerTest, asks_for_the_token_and_knows_who_may_only_look_on) {
  StudioConfig config = any_port();
  config.token = "operate";
  config.viewer_token = "look";
  const int port = serve(config).port();
  rpc.add("act", Role::operator_, "acts", [](const json&) { return json("done"); });
  EXPECT_EQ(http_get(port, "/").status, 401);
  EXPECT_EQ(http_get(port, "/metrics").status, 401);
  EXPECT_EQ(http_get(port, "/", "Authorization: Bearer operat\r\n").status, 401);
  EXPECT_EQ(http_get(port, "/", "Authorization: Bearer operate\r\n").status, 200);
  const HttpAnswer link = http_get(port, "/?token=operate");
  EXPECT_EQ(link.status, 303);
  EXPECT_EQ(link.header("location"), "/");
  EXPECT_NE(link.header("set-cookie").find("odas_token=operate; Path=/; HttpOnly; SameSite=Strict"),
            std::string::npos);
  EXPECT_EQ(http_get(port, "/", "Cookie: x=1; odas_token=look\r\n").status, 200);
  EXPECT_FALSE(WebClient(port).open());
  EXPECT_FALSE(WebClient(port, "/api/v1/live?token=wrong").open());

  WebClient viewer(port, "/api/v1/live?token=look");
  EXPECT_EQ(next(viewer, "hello").at("role"), "viewer");
  viewer.send(R"({"id":1,"method":"act"})");
  EXPECT_EQ(next(viewer, "reply").at("error").at("code"), "forbidden");
  WebClient one(port, "/api/v1/live?token=operate");
  EXPECT_EQ(next(one, "hello").at("role"), "operator");
  one.send(R"({"id":2,"method":"act"})");
  EXPECT_EQ(next(one, "reply"), (json{{"type", "reply"}, {"id", 2}, {"result", "done"}}));
}

TEST_F(ServerTest, makes_a_token_where_a_network_can_come) {
  StudioConfig config = any_port();
  config.ip = "0.0.0.0";
  const StudioServer& open = serve(config);
  EXPECT_NE(open.url().find("?token="), std::string::npos);
  EXPECT_EQ(open.url().find("0.0.0.0"), std::string::npos) << "a link leads to an address";
  EXPECT_EQ(http_get(open.port(), "/").status, 401);
}

TEST_F(ServerTest, gives_files_whole_and_in_part) {
  test::write_file(scratch / "a.wav", "0123456789");
  const int port = serve().port();
  const HttpAnswer whole = http_get(port, "/api/v1/recordings/a%20b.wav");
  EXPECT_EQ(whole.status, 200);
  EXPECT_EQ(whole.body, "0123456789");
  EXPECT_EQ(whole.header("content-disposition"), "attachment; filename=\"a b.wav\"");
  const HttpAnswer part = http_get(port, "/api/v1/recordings/a%20b.wav", "Range: bytes=2-4\r\n");
  EXPECT_EQ(part.status, 206);
  EXPECT_EQ(part.body, "234");
  EXPECT_EQ(part.header("content-range"), "bytes 2-4/10");
  EXPECT_EQ(http_get(port, "/api/v1/recordings/a%20b.wav", "Range: bytes=10-\r\n").status, 416);
  EXPECT_EQ(http_get(port, "/api/v1/recordings/other.wav").status, 404);
  EXPECT_EQ(http_get(port, "/api/v1/export/csv?session=x%2By").body, "x+y");
  const std::string head =
      "HEAD /api/v1/recordings/a%20b.wav HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n";
  EXPECT_EQ(http_exchange(port, head).header("content-length"), "10");
  EXPECT_EQ(http_exchange(port, head).body, "");
}

TEST_F(ServerTest, tells_whether_all_is_well) {
  const int port = serve().port();
  EXPECT_EQ(http_get(port, "/healthz").status, 200);
  failure = "the microphones are gone";
  EXPECT_EQ(http_get(port, "/healthz").status, 503);
  EXPECT_EQ(http_get(port, "/healthz").body, "the microphones are gone\n");
  EXPECT_NE(http_get(port, "/metrics").body.find("odas_studio_clients 0\n"), std::string::npos);
  EXPECT_EQ(json::parse(http_get(port, "/api/v1/info").body).at("run"), nullptr);
}

TEST_F(ServerTest, outlives_what_is_no_request) {
  const int port = serve().port();
  EXPECT_EQ(http_exchange(port, "\x16\x03\x01 hello TLS\r\n\r\n").status, 400);
  EXPECT_EQ(
      http_exchange(port,
                    "POST / HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\nContent-Length: 2\r\n\r\nhi")
          .status,
      405);
  EXPECT_EQ(
      http_exchange(port, "GET / HTTP/1.1\r\nHost: localhost\r\nX: " + std::string(100000, 'x') + "\r\n\r\n")
          .status,
      431);
  WebClient broken(port);
  ASSERT_TRUE(broken.open());
  broken.send_frame(0xF3, "a frame of no kind");
  while (const auto message = broken.next(2000)) {
    if (message->opcode == 8) break;
  }
  WebClient huge(port);
  huge.send(std::string(3 << 20, 'x'));
  while (const auto message = huge.next(2000)) {
    if (message->opcode == 8) break;
  }
  WebClient well(port);
  well.send("no JSON");
  EXPECT_EQ(next(well, "reply").at("error").at("code"), "bad_request");
  well.send(R"({"type":"ping","at":5})");
  EXPECT_EQ(next(well, "pong").at("at"), 5);
}

TEST_F(ServerTest, sends_every_hop_once_and_in_order) {
  StudioServer& s = serve();
  FakeRun run;
  s.begin(run.info);
  WebClient client(s.port());
  EXPECT_EQ(next(client, "hello").at("run").at("name"), "test array");
  client.send(R"({"type":"subscribe","topics":{"hops":60,"meters":10,"health":60}})");
  EXPECT_EQ(next(client, "health").at("clients"), 1) << "from here on he is heard";
  HopIndex expected = 0;
  std::size_t meters = 0;
  for (int i = 0; i < 500; ++i) s.hop(run.next());
  while (expected < 500 || meters == 0) {
    const auto message = client.next();
    ASSERT_TRUE(message);
    const json parsed = json::parse(message->payload);
    if (parsed.at("type") == "meters") meters = parsed.at("mics").size();
    if (parsed.at("type") != "hops") continue;
    for (const json& hop : parsed.at("hops")) {
      EXPECT_EQ(hop.at("t"), ++expected);
      EXPECT_EQ(hop.at("tracks").at(0).at(1), 7);
    }
  }
  EXPECT_EQ(meters, 2U);
}

TEST_F(ServerTest, tells_a_new_run_to_those_who_are_there) {
  StudioServer& s = serve();
  WebClient client(s.port());
  EXPECT_EQ(next(client, "hello").at("run"), nullptr);
  FakeRun run;
  s.begin(run.info);
  EXPECT_EQ(next(client, "hello").at("run").at("id"), 1);
  run.info.run = 2;
  s.begin(run.info);
  EXPECT_EQ(next(client, "hello").at("run").at("id"), 2);
}

TEST_F(ServerTest, says_what_has_happened_to_those_who_asked_and_to_newcomers) {
  StudioServer& s = serve();
  s.announce("", {{"type", "engine"}, {"state", "running"}});
  s.announce("log", {{"type", "log"}, {"lines", {{{"text", "first"}}}}});
  WebClient client(s.port());
  EXPECT_EQ(next(client, "engine").at("state"), "running");
  client.send(R"({"type":"subscribe","topics":{"log":1}})");
  EXPECT_EQ(next(client, "log").at("lines").at(0).at("text"), "first");
  s.announce("events", {{"type", "event"}});
  s.announce("log", {{"type", "log"}, {"lines", {{{"text", "second"}}}}});
  const auto message = client.next();
  ASSERT_TRUE(message);
  EXPECT_EQ(json::parse(message->payload).at("lines").at(0).at("text"), "second")
      << "he did not ask for events";
}

TEST_F(ServerTest, sends_sound_under_the_id_of_its_track) {
  StudioServer& s = serve();
  FakeRun run;
  run.hop.separated[1][0] = 0.5F;
  s.begin(run.info);
  WebClient client(s.port());
  client.send(
      R"({"type":"subscribe","topics":{"health":60},"audio":[{"stream":"separated","track":7},{"stream":"separated","track":8}]})");
  next(client, "health");
  for (int i = 0; i < 3; ++i) s.hop(run.next());
  std::uint64_t samples = 0;
  while (samples < 3 * kHop) {
    const auto message = client.next();
    ASSERT_TRUE(message);
    if (message->opcode != 2) continue;
    const std::string& bytes = message->payload;
    ASSERT_GE(bytes.size(), 24U);
    EXPECT_EQ(bytes[4], 7);
    EXPECT_EQ(static_cast<unsigned char>(bytes[25]), 0x40) << "half of full scale";
    samples += (bytes.size() - 24) / 2;
  }
}

TEST(StudioServer, says_why_it_cannot_listen) {
  RpcRegistry rpc;
  StudioConfig config;
  config.port = 0;
  const StudioServer first(config, rpc, {}, {});
  config.port = first.port();
  try {
    const StudioServer second(config, rpc, {}, {});
    ADD_FAILURE() << "two at one port";
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find("another program is there"), std::string::npos) << error.what();
  }
  config.port = 0;
  config.certificate = config.key = "/nowhere.pem";
  EXPECT_THROW(StudioServer(config, rpc, {}, {}), ConfigError);
}

}  // namespace
}  // namespace odas
