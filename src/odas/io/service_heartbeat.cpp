// SPDX-License-Identifier: MIT
#include "odas/io/service_heartbeat.hpp"

#include <cstddef>
#include <cstdlib>
#include <cstring>

#include <sys/socket.h>
#include <sys/un.h>

namespace odas {
namespace {

/// A socket that is connected to `path`; none where that cannot be.
FileDescriptor connect_to(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.empty() || path.size() >= sizeof address.sun_path) return {};
  std::memcpy(address.sun_path, path.data(), path.size());
  if (path.front() == '@') address.sun_path[0] = '\0';
  FileDescriptor socket(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + path.size());
  if (::connect(socket.get(), reinterpret_cast<const sockaddr*>(&address), length) != 0) return {};
  return socket;
}

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

std::unique_ptr<ServiceHeartbeat> ServiceHeartbeat::from_environment() {
  const std::string socket = variable("NOTIFY_SOCKET");
  if (socket.empty()) return nullptr;
  const std::string pid = variable("WATCHDOG_PID");
  const bool is_ours = pid.empty() || pid == std::to_string(::getpid());
  const long long period = is_ours ? std::atoll(variable("WATCHDOG_USEC").c_str()) : 0;
  return std::make_unique<ServiceHeartbeat>(socket, std::chrono::microseconds(period));
}

ServiceHeartbeat::ServiceHeartbeat(const std::string& socket, std::chrono::microseconds watchdog)
    : socket_(connect_to(socket)), period_(watchdog / 2) {}

Wanted ServiceHeartbeat::wanted() const noexcept {
  Wanted nothing;
  nothing.potentials = nothing.tracks = nothing.separated = nothing.postfiltered = nothing.categories = false;
  return nothing;
}

IoStatus ServiceHeartbeat::write(const HopResult&) { return flush(); }

IoStatus ServiceHeartbeat::flush() {
  beat(Clock::now());
  return {};
}

void ServiceHeartbeat::beat(Clock::time_point now) {
  if (!ready_) {
    tell("READY=1");
  } else if (period_.count() == 0 || now - last_ < period_) {
    return;
  }
  ready_ = true;
  last_ = now;
  if (period_.count() > 0) tell("WATCHDOG=1");
}

IoStatus ServiceHeartbeat::close() {
  tell("STOPPING=1");
  return {};
}

void ServiceHeartbeat::tell(const char* state) const {
  [[maybe_unused]] const auto sent = ::send(socket_.get(), state, std::strlen(state), MSG_NOSIGNAL);
}

}  // namespace odas
