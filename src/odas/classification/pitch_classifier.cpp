// SPDX-License-Identifier: MIT
#include "odas/classification/pitch_classifier.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "odas/base/contract.hpp"
#include "odas/base/error.hpp"

namespace odas {
namespace {

std::size_t checked_frame(const ClassifyConfig& config, std::size_t hop_size) {
  const std::size_t least = std::max(hop_size, 4 * static_cast<std::size_t>(config.win_size));
  const auto frame = static_cast<std::size_t>(config.frame_size);
  if (frame % 2 != 0 || frame < least) {
    throw ConfigError("classify.frameSize", "is " + std::to_string(config.frame_size) +
                                                ", must be even and at least " + std::to_string(least) +
                                                " (the hop, and 4 winSize)");
  }
  return frame;
}

}  // namespace

PitchClassifier::PitchClassifier(const ClassifyConfig& config, std::size_t hop_size, std::size_t slots)
    : config_(config),
      hop_size_(hop_size),
      detector_(checked_frame(config, hop_size), static_cast<std::size_t>(config.win_size),
                config.voicing_min),
      slots_(slots) {
  for (Slot& slot : slots_) slot.frame.resize(static_cast<std::size_t>(config.frame_size));
}

void PitchClassifier::classify(GridView<const float> separated, std::span<Track> tracks) noexcept {
  ODAS_EXPECT(separated.rows() == slots_.size() && separated.cols() == hop_size_);
  ODAS_EXPECT(tracks.size() == slots_.size());
  for (std::size_t s = 0; s < slots_.size(); ++s) {
    Slot& slot = slots_[s];
    if (slot.id != tracks[s].id) {
      forget(slot);
      slot.id = tracks[s].id;
    }
    if (slot.id == 0) {
      tracks[s].category = Category::undefined;
      continue;
    }
    listen(slot, separated[s]);
    // In a frame that is not full yet, the pitch seems to move.
    follow_pitch(slot, slot.heard >= slot.frame.size() ? detector_.period(slot.frame) : 0);
    tracks[s].category = slot.voiced_share > config_.r0 ? Category::speech : Category::nonspeech;
  }
}

void PitchClassifier::forget(Slot& slot) noexcept {
  std::fill(slot.frame.begin(), slot.frame.end(), 0.F);
  slot.heard = 0;
  slot.period = slot.step = slot.slope = slot.voiced_share = 0;
}

void PitchClassifier::listen(Slot& slot, std::span<const float> hop) noexcept {
  const auto kept = std::move(slot.frame.begin() + static_cast<std::ptrdiff_t>(hop.size()), slot.frame.end(),
                              slot.frame.begin());
  slot.heard = std::min(slot.heard + hop.size(), slot.frame.size());
  std::transform(hop.begin(), hop.end(), kept, [](float x) { return std::isfinite(x) ? x : 0; });
}

void PitchClassifier::follow_pitch(Slot& slot, float period) const noexcept {
  const float step = period - slot.period;
  const bool near = std::abs(step) < config_.delta_tau_max;
  const bool was_near = std::abs(slot.step) < config_.delta_tau_max;
  if (!near) {
    slot.slope = 0;
  } else if (was_near) {
    slot.slope += config_.alpha * (step - slot.slope);
  } else {
    slot.slope = step;
  }
  slot.period = period;
  slot.step = step;

  const bool in_range = config_.tau_min <= period && period <= config_.tau_max;
  const bool voiced = in_range && std::abs(slot.slope) > config_.phi_min;
  slot.voiced_share += config_.gamma * ((voiced ? 1.F : 0.F) - slot.voiced_share);
}

void PitchClassifier::reset() noexcept {
  for (Slot& slot : slots_) {
    forget(slot);
    slot.id = 0;
  }
}

}  // namespace odas
