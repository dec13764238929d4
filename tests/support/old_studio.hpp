// SPDX-License-Identifier: MIT
// A model of what ODAS Studio does with the four streams that it listens for, faults and all, written from a
// description of its behaviour.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace odas::test {

/// The text is parted at `}` LF `{`, and the braces are put back. The last object is held until the next
/// begins.
inline std::vector<nlohmann::json> parse_like_odas_web(const std::string& stream, std::size_t chunk) {
  std::vector<nlohmann::json> objects;
  std::string buffer;
  const auto add = [&](std::string text) {
    if (!text.starts_with("{")) text = "{" + text;
    if (text.find("\n}") == std::string::npos) text += "}";
    objects.push_back(nlohmann::json::parse(text, nullptr, false));
  };
  for (std::size_t at = 0; at < stream.size(); at += chunk) {
    buffer += stream.substr(at, chunk);
    for (std::size_t cut = 0; (cut = buffer.find("}\n{")) != std::string::npos; buffer.erase(0, cut + 2)) {
      add(buffer.substr(0, cut));
    }
  }
  return objects;
}

/// Each chunk is cut into pieces of two bytes, round robin over four channels, always from channel 0 on.
inline std::vector<std::string> record_like_odas_web(const std::vector<std::string>& chunks) {
  std::vector<std::string> channels(4);
  for (const std::string& chunk : chunks) {
    for (std::size_t at = 0; at + 1 < chunk.size(); at += 2) channels[at / 2 % 4] += chunk.substr(at, 2);
  }
  return channels;
}

/// Gives each new id the lowest slot that is free of its own four, whatever the row, and takes the channel of
/// that number for its voice.
class OldStudioSlots {
 public:
  /// The ids of an object of tracks; a fifth throws, as there.
  void hear(const nlohmann::json& tracks) {
    std::array<bool, 4> alive{};
    for (const nlohmann::json& source : tracks.at("src")) {
      const auto id = source.at("id").get<std::uint64_t>();
      if (id == 0) continue;
      std::size_t slot = 0;
      while (slot < 4 && ids_[slot] != id) ++slot;
      if (slot == 4) {
        for (slot = 0; ids_.at(slot) != 0;) ++slot;
        ids_[slot] = id;
      }
      alive[slot] = true;
    }
    for (std::size_t slot = 0; slot < 4; ++slot) {
      if (!alive[slot]) ids_[slot] = 0;
    }
  }
  /// [slot], 0: nobody.
  [[nodiscard]] const std::array<std::uint64_t, 4>& ids() const noexcept { return ids_; }

 private:
  std::array<std::uint64_t, 4> ids_{};
};

}  // namespace odas::test
