// SPDX-License-Identifier: MIT
#include "odas/studio/http_session.hpp"

#include "support/server_test.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace odas::http_session_test {
namespace {

using nlohmann::json;
using test::http_exchange;
using test::http_get;
using test::HttpAnswer;
using test::ServerTest;
using test::WebClient;

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

}  // namespace
}  // namespace odas::http_session_test
