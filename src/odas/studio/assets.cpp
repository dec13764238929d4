// SPDX-License-Identifier: MIT
#include "odas/studio/assets.hpp"

#include <algorithm>

namespace odas {

const Asset* find_asset(std::string_view path) noexcept {
  if (path == "/") path = "/index.html";
  const auto all = assets();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Asset& asset) { return asset.path == path; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace odas
