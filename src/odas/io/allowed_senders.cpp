// SPDX-License-Identifier: MIT
#include "odas/io/allowed_senders.hpp"

#include <algorithm>
#include <cstring>

#include <netinet/in.h>

#include "odas/base/error.hpp"

namespace odas {
namespace {

constexpr std::array<std::uint8_t, 12> kMapped{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF};

}  // namespace

AllowedSenders::AllowedSenders(const std::vector<std::string>& hosts) {
  for (const std::string& host : hosts) {
    const NetAddresses addresses = look_up(host, 0);
    if (!addresses.fault.empty()) throw IoError("who is " + host + "? " + addresses.fault);
    for (const NetAddress& address : addresses.all) numbers_.push_back(number_of(address));
  }
}

AllowedSenders::Number AllowedSenders::number_of(const NetAddress& address) noexcept {
  Number number{};
  if (address.family() == AF_INET6) {
    const auto& six = reinterpret_cast<const sockaddr_in6&>(address.storage);
    std::memcpy(number.data(), &six.sin6_addr, number.size());
  } else {
    const auto& four = reinterpret_cast<const sockaddr_in&>(address.storage);
    std::memcpy(number.data(), kMapped.data(), kMapped.size());
    std::memcpy(number.data() + kMapped.size(), &four.sin_addr, sizeof four.sin_addr);
  }
  return number;
}

bool AllowedSenders::allows(const NetAddress& sender) const noexcept {
  const Number number = number_of(sender);
  const bool is_mapped = std::equal(kMapped.begin(), kMapped.end(), number.begin());
  if (is_mapped && number[12] == 127) return true;
  Number loopback{};
  loopback[15] = 1;
  return number == loopback || std::find(numbers_.begin(), numbers_.end(), number) != numbers_.end();
}

}  // namespace odas
