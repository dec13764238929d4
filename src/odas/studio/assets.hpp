// SPDX-License-Identifier: MIT
// The page: web/dist, put into the program by CMake.
#pragma once

#include <span>
#include <string_view>

namespace odas {

struct Asset {
  std::string_view path;  // "/index.html"
  std::string_view type;  // "text/html; charset=utf-8"
  std::string_view etag;  // of its bytes
  std::string_view bytes;
  std::string_view gzip;  // the same, compressed
};

/// All of them, sorted by path. Made by cmake/OdasAssets.cmake.
[[nodiscard]] std::span<const Asset> assets() noexcept;
/// The asset of a path: "/" is the page itself. Null: there is none.
[[nodiscard]] const Asset* find_asset(std::string_view path) noexcept;

}  // namespace odas
