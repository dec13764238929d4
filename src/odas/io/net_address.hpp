// SPDX-License-Identifier: MIT
#pragma once

#include <future>
#include <optional>
#include <string>
#include <vector>

#include <sys/socket.h>

namespace odas {

/// An address with its port, of IPv4 or IPv6.
struct NetAddress {
  sockaddr_storage storage{};
  socklen_t length = 0;

  [[nodiscard]] int family() const noexcept { return storage.ss_family; }
  [[nodiscard]] const sockaddr* get() const noexcept { return reinterpret_cast<const sockaddr*>(&storage); }
  [[nodiscard]] int port() const noexcept;
  /// "192.168.0.7:9000", "[::1]:9000".
  [[nodiscard]] std::string text() const;
};

/// "host:port", with brackets around what has colons itself.
[[nodiscard]] std::string host_and_port(const std::string& host, int port);

/// The addresses of a name, in the order in which they should be tried, or why there are none.
struct NetAddresses {
  std::vector<NetAddress> all;
  std::string fault;  // "" if there are some
};

/// Looks a host up; waits as long as that takes, for a name perhaps seconds. `socket_type`: SOCK_STREAM or
/// SOCK_DGRAM. `host` may be a name or a number, IPv4 or IPv6.
[[nodiscard]] NetAddresses look_up(const std::string& host, int port, int socket_type = SOCK_STREAM);

/// The same without waiting: a number is known at once, a name is looked up by a thread of its own. An
/// answer that nobody waits for any more is thrown away.
class NameLookup {
 public:
  NameLookup(std::string host, int port, int socket_type = SOCK_STREAM);

  /// The answer, once, when it is there.
  [[nodiscard]] std::optional<NetAddresses> poll();

 private:
  std::future<NetAddresses> answer_;
};

}  // namespace odas
