// SPDX-License-Identifier: MIT
#include "odas/studio/webhook.hpp"

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include "support/net_peer.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::webhook_test {
namespace {

using namespace std::chrono_literals;
using test::eventually;

/// A receiver on the web: takes requests and gives the next of its answers, the last one for ever.
class Receiver {
 public:
  explicit Receiver(std::vector<std::string> answers) : answers_(std::move(answers)) {
    thread_ = std::thread([this] { run(); });
  }
  ~Receiver() {
    ending_ = true;
    thread_.join();
  }
  [[nodiscard]] std::string url() const {
    return "http://127.0.0.1:" + std::to_string(listener_.port()) + "/hook";
  }
  [[nodiscard]] std::vector<std::string> requests() const {
    const std::scoped_lock lock(mutex_);
    return requests_;
  }

 private:
  void run() {
    std::size_t next = 0;
    while (!ending_) {
      const test::NetPeer peer = listener_.accept(20);
      if (!peer.open()) continue;
      std::string request;
      while (request.find("\r\n\r\n") == std::string::npos || !request.ends_with("}")) {
        const std::string piece = peer.receive(65536, 2000);
        if (piece.empty()) break;
        request += piece;
      }
      {
        const std::scoped_lock lock(mutex_);
        requests_.push_back(request);
      }
      const std::string& answer = answers_[std::min(next++, answers_.size() - 1)];
      if (!answer.empty()) {
        peer.send("HTTP/1.1 " + answer + "\r\nContent-Length: 0\r\nConnection: close\r\n\r\n");
      } else {
        while (!ending_ && !silent_is_left(peer)) {}  // says nothing until the other one goes
      }
    }
  }
  static bool silent_is_left(const test::NetPeer& peer) {
    char byte = 0;
    std::this_thread::sleep_for(5ms);
    return ::recv(peer.descriptor(), &byte, 1, MSG_DONTWAIT | MSG_PEEK) == 0;
  }

  test::NetListener listener_;
  std::vector<std::string> answers_;
  mutable std::mutex mutex_;
  std::vector<std::string> requests_;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

struct Said {
  std::mutex mutex;
  std::vector<std::string> texts;
  std::size_t count() {
    const std::scoped_lock lock(mutex);
    return texts.size();
  }
};

Webhook::Options options(const std::string& url, Said& said) {
  Webhook::Options made;
  made.url = url;
  made.timeout = 300ms;
  made.first_pause = 5ms;
  made.farewell = 300ms;
  made.say = [&said](const std::string&, const std::string& text) {
    const std::scoped_lock lock(said.mutex);
    said.texts.push_back(text);
  };
  return made;
}

class WebhookTest : public testing::Test {
 protected:
  void SetUp() override {
    try {
      const Webhook probe(options("http://127.0.0.1:1/", said));
    } catch (const ConfigError& error) { GTEST_SKIP() << error.what(); }
  }
  Said said;
};

TEST_F(WebhookTest, posts_each_event_in_order) {
  const Receiver receiver({"204 No Content"});
  Webhook hook(options(receiver.url(), said));
  hook.post(R"({"event":"appear"})");
  hook.post(R"({"event":"disappear"})");
  ASSERT_TRUE(eventually([&] { return hook.sent() == 2; }));
  const auto requests = receiver.requests();
  ASSERT_EQ(requests.size(), 2U);
  EXPECT_TRUE(requests[0].starts_with("POST /hook HTTP/1.1\r\n")) << requests[0];
  EXPECT_NE(requests[0].find("Content-Type: application/json"), std::string::npos);
  EXPECT_TRUE(requests[0].ends_with("\r\n\r\n{\"event\":\"appear\"}"));
  EXPECT_TRUE(requests[1].ends_with("{\"event\":\"disappear\"}"));
  EXPECT_EQ(said.count(), 0U);
}

TEST_F(WebhookTest, tries_again_where_the_receiver_is_in_trouble) {
  const Receiver receiver({"503 Busy", "500 Broken", "429 Slowly", "200 OK"});
  Webhook hook(options(receiver.url(), said));
  hook.post("{}");
  ASSERT_TRUE(eventually([&] { return hook.sent() == 1; }));
  EXPECT_EQ(receiver.requests().size(), 4U);
  EXPECT_EQ(hook.lost(), 0U);
}

TEST_F(WebhookTest, does_not_try_again_where_it_is_refused_and_says_so_once) {
  const Receiver receiver({"403 Forbidden"});
  Webhook hook(options(receiver.url(), said));
  hook.post("{}");
  hook.post("{}");
  ASSERT_TRUE(eventually([&] { return hook.lost() == 2; }));
  EXPECT_EQ(receiver.requests().size(), 2U);
  ASSERT_EQ(said.count(), 1U);
  EXPECT_NE(said.texts[0].find("it answers 403"), std::string::npos) << said.texts[0];
}

TEST_F(WebhookTest, never_follows_a_redirect) {
  const Receiver other({"200 OK"});
  const Receiver receiver({"307 Elsewhere\r\nLocation: " + other.url()});
  Webhook hook(options(receiver.url(), said));
  hook.post("{}");
  ASSERT_TRUE(eventually([&] { return hook.lost() == 1; }));
  EXPECT_TRUE(other.requests().empty());
}

TEST_F(WebhookTest, gives_up_on_a_dead_receiver_after_some_tries) {
  Webhook hook(options("http://127.0.0.1:" + std::to_string(test::free_port()) + "/", said));
  hook.post("{}");
  ASSERT_TRUE(eventually([&] { return hook.lost() == 1; }));
  EXPECT_EQ(said.count(), 1U);
}

TEST_F(WebhookTest, drops_what_finds_no_room_behind_a_slow_receiver_and_never_waits) {
  const Receiver receiver({""});
  Webhook hook(options(receiver.url(), said));
  for (std::size_t i = 0; i < Webhook::kQueue + 100; ++i) hook.post("{}");
  EXPECT_GE(hook.lost(), 99U) << "one may be on its way";
  EXPECT_EQ(said.count(), 1U);
}

TEST_F(WebhookTest, says_goodbye_to_what_is_left_and_no_longer) {
  const Receiver receiver({"200 OK"});
  {
    Webhook hook(options(receiver.url(), said));
    hook.post("{}");
  }
  EXPECT_EQ(receiver.requests().size(), 1U) << "the last event is sent, though the program ends";
}

TEST(WebhookAddress, must_be_one_of_the_web) {
  Said said;
  EXPECT_THROW(Webhook(options("", said)), ConfigError);
  EXPECT_THROW(Webhook(options("file:///etc/passwd", said)), ConfigError);
  EXPECT_THROW(Webhook(options("ftp://example.org/", said)), ConfigError);
}

}  // namespace
}  // namespace odas::webhook_test
