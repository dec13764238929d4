// SPDX-License-Identifier: MIT
#include "support/goldens.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>

namespace odas::test {
namespace {

std::string gunzip(const std::filesystem::path& file) {
  const std::string command = "gzip -dc '" + file.string() + "'";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  if (!pipe) throw std::runtime_error("cannot run gzip");
  std::string text;
  std::array<char, 65536> block{};
  while (const std::size_t n = std::fread(block.data(), 1, block.size(), pipe.get())) {
    text.append(block.data(), n);
  }
  return text;
}

/// The number after `key` in a row, 0 where the row has no such key.
double number_after(const std::string& row, const char* key) {
  const std::size_t at = row.find(key);
  return at == std::string::npos ? 0 : std::strtod(row.c_str() + at + std::string(key).size(), nullptr);
}

}  // namespace

std::optional<std::filesystem::path> shared_folder() {
  const char* set = std::getenv("ODAS_SHARED");
  const std::filesystem::path folder = set != nullptr ? set : std::string(ODAS_SOURCE_DIR) + "/../shared";
  if (!std::filesystem::exists(folder / "scenes")) return std::nullopt;
  return folder;
}

std::vector<GoldenHop> read_goldens(const std::filesystem::path& file) {
  const std::string text = gunzip(file);
  std::vector<GoldenHop> hops;
  std::size_t begin = 0;
  while (begin < text.size()) {  // one key or row a line
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    if (line.find("timeStamp") != std::string::npos) {
      hops.push_back({static_cast<std::uint64_t>(number_after(line, "\"timeStamp\": ")), {}});
    } else if (line.find("\"x\": ") != std::string::npos) {
      GoldenRow row;
      row.id = static_cast<std::uint64_t>(number_after(line, "\"id\": "));
      row.x = static_cast<float>(number_after(line, "\"x\": "));
      row.y = static_cast<float>(number_after(line, "\"y\": "));
      row.z = static_cast<float>(number_after(line, "\"z\": "));
      row.value = static_cast<float>(number_after(line, "\"E\": ") + number_after(line, "\"activity\": "));
      hops.back().rows.push_back(row);
    }
  }
  return hops;
}

long thousandths(float value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%1.3f", static_cast<double>(value));
  return std::lround(1000 * std::strtod(text.data(), nullptr));
}

}  // namespace odas::test
