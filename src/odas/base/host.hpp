// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace odas {

/// Whether a server that listens at `host` hears this machine only: 127.0.0.1 and its like, ::1, localhost,
/// or nothing at all, which means 127.0.0.1. Everything else is open to a network and wants a token.
[[nodiscard]] bool is_loopback_host(std::string_view host) noexcept;

}  // namespace odas
