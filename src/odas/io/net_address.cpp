// SPDX-License-Identifier: MIT
#include "odas/io/net_address.hpp"

#include <array>
#include <cstring>
#include <thread>
#include <utility>

#include <netdb.h>
#include <netinet/in.h>

namespace odas {
namespace {

NetAddresses ask(const std::string& host, int port, int socket_type, int flags) {
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = socket_type;
  hints.ai_flags = flags | AI_NUMERICSERV;
  addrinfo* found = nullptr;
  NetAddresses answer;
  const int code = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found);
  if (code != 0) {
    answer.fault = "\"" + host + "\" is not known as a host: " + ::gai_strerror(code);
    return answer;
  }
  for (const addrinfo* a = found; a != nullptr; a = a->ai_next) {
    NetAddress address;
    std::memcpy(&address.storage, a->ai_addr, a->ai_addrlen);
    address.length = a->ai_addrlen;
    answer.all.push_back(address);
  }
  ::freeaddrinfo(found);
  return answer;
}

}  // namespace

int NetAddress::port() const noexcept {
  if (family() == AF_INET6) return ntohs(reinterpret_cast<const sockaddr_in6&>(storage).sin6_port);
  return ntohs(reinterpret_cast<const sockaddr_in&>(storage).sin_port);
}

std::string NetAddress::text() const {
  std::array<char, NI_MAXHOST> host{};
  if (::getnameinfo(get(), length, host.data(), host.size(), nullptr, 0, NI_NUMERICHOST) != 0) return "?";
  return host_and_port(host.data(), port());
}

std::string host_and_port(const std::string& host, int port) {
  const bool brackets = host.find(':') != std::string::npos;
  return (brackets ? "[" + host + "]" : host) + ":" + std::to_string(port);
}

NetAddresses look_up(const std::string& host, int port, int socket_type) {
  return ask(host, port, socket_type, 0);
}

NameLookup::NameLookup(std::string host, int port, int socket_type) {
  std::promise<NetAddresses> promise;
  answer_ = promise.get_future();
  NetAddresses at_once = ask(host, port, socket_type, AI_NUMERICHOST);
  if (at_once.fault.empty()) {
    promise.set_value(std::move(at_once));
    return;
  }
  // Detached: a name server that does not answer must not hold up the end of the program.
  std::thread([promise = std::move(promise), host = std::move(host), port, socket_type]() mutable {
    promise.set_value(ask(host, port, socket_type, 0));
  }).detach();
}

std::optional<NetAddresses> NameLookup::poll() {
  if (!answer_.valid() || answer_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    return std::nullopt;
  }
  return answer_.get();
}

}  // namespace odas
