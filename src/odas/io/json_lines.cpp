// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "odas/io/hop_encoder.hpp"
#include "odas/io/text_buffer.hpp"

namespace odas {
namespace {

constexpr Wanted kPotentials{.potentials = true, .tracks = false, .separated = false, .postfiltered = false};
constexpr Wanted kTracks{.potentials = false, .tracks = true, .separated = false, .postfiltered = false};
constexpr Wanted kTracksWithEnergy{
    .potentials = true, .tracks = true, .separated = false, .postfiltered = false};
/// How far a potential may be from the track whose energy it tells: about the error of a small array in a
/// room.
constexpr float kNear = 15;  // degrees
constexpr std::size_t kFrameSize = 192;
constexpr std::size_t kRowSize =
    192 + 2 * TextBuffer::kIntegerSize + TextBuffer::quoted_size(63) + 9 * TextBuffer::kFixedSize;

/// `2025-01-31T12:00:00.125Z`: ISO 8601, universal time.
void put_instant(TextBuffer& text, std::chrono::system_clock::time_point instant) {
  using namespace std::chrono;
  const auto day = floor<days>(instant);
  const year_month_day date(day);
  const hh_mm_ss time(floor<milliseconds>(instant - day));
  const auto put = [&](auto value, unsigned digits) {
    const auto number = static_cast<unsigned>(value);
    if (digits == 4) text.put(static_cast<char>('0' + number / 1000 % 10));
    if (digits >= 3) text.put(static_cast<char>('0' + number / 100 % 10));
    text.put(static_cast<char>('0' + number / 10 % 10));
    text.put(static_cast<char>('0' + number % 10));
  };
  put(static_cast<int>(date.year()), 4);
  text.put('-');
  put(static_cast<unsigned>(date.month()), 2);
  text.put('-');
  put(static_cast<unsigned>(date.day()), 2);
  text.put('T');
  put(time.hours().count(), 2);
  text.put(':');
  put(time.minutes().count(), 2);
  text.put(':');
  put(time.seconds().count(), 2);
  text.put('.');
  put(time.subseconds().count(), 3);
  text.put('Z');
}

void put_head(TextBuffer& text, HopIndex time, const StreamClock& clock) {
  const double seconds = static_cast<double>(time - 1) * clock.hop_seconds;
  const std::chrono::duration<double> elapsed(seconds);
  text.clear();
  text.need(kFrameSize);
  text.put("{\"timeStamp\":");
  text.put_integer(time);
  text.put(",\"time\":");
  text.put_seconds(seconds);
  text.put(",\"utc\":\"");
  put_instant(text, clock.start + std::chrono::duration_cast<std::chrono::system_clock::duration>(elapsed));
  text.put("\",\"src\":[");
}

void put_direction(TextBuffer& text, Vec3 direction) {
  text.put(",\"x\":");
  text.put_fixed(direction.x);
  text.put(",\"y\":");
  text.put_fixed(direction.y);
  text.put(",\"z\":");
  text.put_fixed(direction.z);
  text.put(",\"azimuth\":");
  text.put_fixed(azimuth_deg(direction));
  text.put(",\"elevation\":");
  text.put_fixed(elevation_deg(direction));
}

void put_slot(TextBuffer& text, std::size_t slot, bool& first) {
  text.need(kRowSize);
  if (!first) text.put(',');
  first = false;
  text.put("{\"slot\":");
  text.put_integer(slot);
}

std::span<const char> finish(TextBuffer& text) {
  text.need(kFrameSize);
  text.put("]}\n");
  return text.text();
}

class JsonLinesPotentials : public HopEncoder {
 public:
  explicit JsonLinesPotentials(const StreamClock& clock) : clock_(clock) {}
  [[nodiscard]] Wanted wanted() const noexcept override { return kPotentials; }
  [[nodiscard]] std::span<const char> encode(const HopResult& hop) override {
    put_head(text_, hop.time, clock_);
    bool first = true;
    for (std::size_t slot = 0; slot < hop.potentials.size(); ++slot) {
      const Potential& potential = hop.potentials[slot];
      put_slot(text_, slot, first);
      put_direction(text_, potential.direction);
      text_.put(",\"E\":");
      text_.put_fixed(potential.energy);
      text_.put('}');
    }
    return finish(text_);
  }

 private:
  StreamClock clock_;
  TextBuffer text_{TextBuffer::kUsualSize};
};

/// The class, where somebody has asked for it.
void put_class(TextBuffer& text, Category category) {
  if (category == Category::undefined) return;
  text.put(",\"class\":\"");
  text.put(category == Category::speech ? "speech\"" : "nonspeech\"");
}

/// E of the strongest potential near a track, 0 where none is.
float energy_near(Vec3 direction, std::span<const Potential> potentials) {
  static const float cosine = std::cos(radians(kNear));
  float energy = 0;
  for (const Potential& potential : potentials) {
    if (dot(direction, potential.direction) >= cosine) energy = std::max(energy, potential.energy);
  }
  return energy;
}

/// Along azimuth and along elevation, where it is known.
void put_sigma(TextBuffer& text, const TangentCovariance& covariance) {
  if (!(covariance.east > 0)) return;
  text.put(",\"sigma_deg\":[");
  text.put_fixed(degrees(std::sqrt(covariance.east)));
  text.put(",");
  text.put_fixed(degrees(std::sqrt(covariance.north)));
  text.put("]");
}

void put_track(TextBuffer& text, const Track& track, std::span<const Potential> potentials) {
  text.put(",\"tag\":");
  text.put_quoted(track.tag.view());
  put_direction(text, track.direction);
  text.put(",\"activity\":");
  text.put_fixed(track.activity);
  text.put(",\"E\":");
  text.put_fixed(energy_near(track.direction, potentials));
  put_sigma(text, track.covariance);
  put_class(text, track.category);
}

void put_category(TextBuffer& text, const Track& track, std::span<const Potential>) {
  put_class(text, track.category);
}

/// A row for each track that lives: its slot and id, and what `put` adds.
class JsonLinesSlots : public HopEncoder {
 public:
  using Put = void (*)(TextBuffer&, const Track&, std::span<const Potential>);

  JsonLinesSlots(const StreamClock& clock, const Wanted& wanted, Put put)
      : clock_(clock), wanted_(wanted), put_(put) {}
  [[nodiscard]] Wanted wanted() const noexcept override { return wanted_; }
  [[nodiscard]] std::span<const char> encode(const HopResult& hop) override {
    put_head(text_, hop.time, clock_);
    bool first = true;
    for (std::size_t slot = 0; slot < hop.tracks.size(); ++slot) {
      const Track& track = hop.tracks[slot];
      if (track.id == 0) continue;
      put_slot(text_, slot, first);
      text_.put(",\"id\":");
      text_.put_integer(track.id);
      put_(text_, track, hop.potentials);
      text_.put('}');
    }
    return finish(text_);
  }

 private:
  StreamClock clock_;
  Wanted wanted_;
  Put put_;
  TextBuffer text_{TextBuffer::kUsualSize};
};

}  // namespace

std::unique_ptr<HopEncoder> make_json_lines_potentials(const StreamClock& clock) {
  return std::make_unique<JsonLinesPotentials>(clock);
}
std::unique_ptr<HopEncoder> make_json_lines_tracks(const StreamClock& clock) {
  return std::make_unique<JsonLinesSlots>(clock, kTracksWithEnergy, put_track);
}

std::unique_ptr<HopEncoder> make_json_lines_categories(const StreamClock& clock) {
  return std::make_unique<JsonLinesSlots>(clock, kTracks, put_category);
}

}  // namespace odas
