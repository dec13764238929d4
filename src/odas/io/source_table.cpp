// SPDX-License-Identifier: MIT
#include "odas/io/source_table.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace odas {
namespace {

constexpr int kBar = 10;

const char* class_of(const Track& track) {
  switch (track.category) {
    case Category::speech:
      return "speech";
    case Category::nonspeech:
      return "nonspeech";
    case Category::undefined:
      break;
  }
  return "-";
}

}  // namespace

std::string harmless(std::string_view text) {
  std::string shown;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    // U+0080 .. U+009F, which some terminals take for the beginning of a command.
    const bool is_c1 = byte == 0xC2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0;
    if (is_c1) ++i;
    shown += byte < 0x20 || byte == 0x7F || is_c1 ? '?' : text[i];
  }
  return shown;
}

std::vector<std::string> source_table(std::span<const Track> tracks) {
  std::vector<std::string> lines{"      id   azimuth  elevation  activity         class      tag"};
  for (const Track& track : tracks) {
    if (track.id == 0) continue;
    const float activity = std::clamp(track.activity, 0.F, 1.F);
    const auto length = static_cast<std::size_t>(activity * kBar + 0.5F);
    lines.push_back(fmt::format("{:8} {:8.1f}° {:9.1f}°  {:<{}} {:4.2f}  {:<9}  {}", track.id,
                                azimuth_deg(track.direction), elevation_deg(track.direction),
                                std::string(length, '#'), kBar, activity, class_of(track),
                                harmless(track.tag.view())));
  }
  if (lines.size() == 1) lines.emplace_back("       - nobody");
  return lines;
}

std::string source_line(const Track& track) {
  std::string line =
      fmt::format("id {}, azimuth {:.1f}, elevation {:.1f}, activity {:.2f}", track.id,
                  azimuth_deg(track.direction), elevation_deg(track.direction), track.activity);
  if (track.category != Category::undefined) line += fmt::format(", {}", class_of(track));
  if (!track.tag.empty()) line += fmt::format(", \"{}\"", harmless(track.tag.view()));
  return line;
}

}  // namespace odas
