// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <stdexcept>
#include <vector>

#include <sndfile.h>

#include "odas/base/grid.hpp"

namespace odas::test {

/// [channel][sample] of a sound file. Throws where it cannot be read.
inline Grid<float> read_sound(const std::filesystem::path& file) {
  SF_INFO info{};
  SNDFILE* sound = sf_open(file.c_str(), SFM_READ, &info);
  if (sound == nullptr) throw std::runtime_error("cannot read " + file.string());
  const auto channels = static_cast<std::size_t>(info.channels);
  std::vector<float> interleaved(static_cast<std::size_t>(info.frames) * channels);
  const sf_count_t frames = sf_readf_float(sound, interleaved.data(), info.frames);
  sf_close(sound);
  Grid<float> samples(channels, static_cast<std::size_t>(frames));
  for (std::size_t n = 0; n < samples.cols(); ++n) {
    for (std::size_t c = 0; c < channels; ++c) samples[c][n] = interleaved[n * channels + c];
  }
  return samples;
}

}  // namespace odas::test
