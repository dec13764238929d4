// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "odas/io/net_address.hpp"

namespace odas {

/// Who may connect where there is no place for a token: ODAS's own streams have none. This machine always
/// may.
class AllowedSenders {
 public:
  /// `hosts`: names or numbers, looked up here and once. Throws IoError where one has no address.
  explicit AllowedSenders(const std::vector<std::string>& hosts);

  [[nodiscard]] bool allows(const NetAddress& sender) const noexcept;

 private:
  using Number = std::array<std::uint8_t, 16>;  // IPv6, or IPv4 as IPv6 maps it
  static Number number_of(const NetAddress& address) noexcept;

  std::vector<Number> numbers_;
};

}  // namespace odas
