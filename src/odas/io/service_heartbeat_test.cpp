// SPDX-License-Identifier: MIT
#include "odas/io/service_heartbeat.hpp"

#include <array>
#include <cstdlib>
#include <thread>
#include <vector>

#include "support/scratch.hpp"
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>

namespace odas::service_heartbeat_test {
namespace {

using namespace std::chrono_literals;

/// What a service manager hears.
class Manager {
 public:
  Manager() : socket_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path().copy(address.sun_path, sizeof address.sun_path - 1);
    EXPECT_EQ(::bind(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }
  [[nodiscard]] std::string path() const { return (scratch_ / "notify").string(); }
  [[nodiscard]] std::vector<std::string> heard() const {
    std::vector<std::string> all;
    std::array<char, 64> text{};
    for (ssize_t n = 0; (n = ::recv(socket_.get(), text.data(), text.size(), 0)) > 0;) {
      all.emplace_back(text.data(), static_cast<std::size_t>(n));
    }
    return all;
  }

 private:
  test::Scratch scratch_;
  FileDescriptor socket_;
};

using Said = std::vector<std::string>;

TEST(ServiceHeartbeat, tells_that_it_is_ready_lives_and_stops) {
  const Manager manager;
  ServiceHeartbeat heart(manager.path(), 20ms);
  EXPECT_EQ(manager.heard(), Said{}) << "not ready before anything flows";
  EXPECT_TRUE(heart.write({}).ok());
  EXPECT_EQ(manager.heard(), (Said{"READY=1", "WATCHDOG=1"}));
  std::this_thread::sleep_for(12ms);
  EXPECT_TRUE(heart.flush().ok());
  EXPECT_EQ(manager.heard(), Said{"WATCHDOG=1"}) << "also while a device is waited for";
  EXPECT_TRUE(heart.close().ok());
  EXPECT_EQ(manager.heard(), Said{"STOPPING=1"});
}

TEST(ServiceHeartbeat, does_not_beat_for_each_hop) {
  const Manager manager;
  ServiceHeartbeat heart(manager.path(), 1h);
  for (int hop = 0; hop < 100; ++hop) EXPECT_TRUE(heart.write({}).ok());
  EXPECT_EQ(manager.heard(), (Said{"READY=1", "WATCHDOG=1"}));
}

TEST(ServiceHeartbeat, without_a_watchdog_it_is_ready_once) {
  const Manager manager;
  ServiceHeartbeat heart(manager.path(), 0us);
  for (int hop = 0; hop < 3; ++hop) EXPECT_TRUE(heart.write({}).ok());
  EXPECT_EQ(manager.heard(), Said{"READY=1"});
}

TEST(ServiceHeartbeat, goes_on_where_nobody_listens) {
  for (const std::string& path : {std::string("/no/such/socket"), std::string(), std::string(500, 'x')}) {
    ServiceHeartbeat heart(path, 1s);
    EXPECT_TRUE(heart.write({}).ok());
    EXPECT_TRUE(heart.close().ok());
  }
}

TEST(ServiceHeartbeat, is_not_there_unless_the_environment_asks) {
  ::unsetenv("NOTIFY_SOCKET");
  EXPECT_EQ(ServiceHeartbeat::from_environment(), nullptr);
  const Manager manager;
  ::setenv("NOTIFY_SOCKET", manager.path().c_str(), 1);
  ::setenv("WATCHDOG_USEC", "1000000", 1);
  ::setenv("WATCHDOG_PID", "1", 1);  // meant for another process
  const auto heart = ServiceHeartbeat::from_environment();
  ::unsetenv("NOTIFY_SOCKET");
  ::unsetenv("WATCHDOG_USEC");
  ::unsetenv("WATCHDOG_PID");
  ASSERT_NE(heart, nullptr);
  EXPECT_TRUE(heart->write({}).ok());
  EXPECT_EQ(manager.heard(), Said{"READY=1"});
}

}  // namespace
}  // namespace odas::service_heartbeat_test
