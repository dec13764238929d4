// SPDX-License-Identifier: MIT
#include "odas/base/host.hpp"

#include <algorithm>

namespace odas {

bool is_loopback_host(std::string_view host) noexcept {
  if (host.empty() || host == "localhost" || host == "::1") return true;
  // A name may begin with "127." too, and lead anywhere.
  const bool numeric = host.find_first_not_of("0123456789.") == std::string_view::npos;
  return numeric && host.starts_with("127.") && std::count(host.begin(), host.end(), '.') == 3;
}

}  // namespace odas
