// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <set>

#include "odas/base/vec3.hpp"
#include "odas/config/checks.hpp"
#include "odas/config/phrases.hpp"

namespace odas {

namespace {

constexpr std::size_t kMaxMics = 128;  // pairs grow with the square: 8128 here

Vec3 vec(const std::array<float, 3>& a) { return {a[0], a[1], a[2]}; }

std::string item(const std::string& list, std::size_t i) { return list + "[" + std::to_string(i) + "]"; }

std::string mics_text(std::size_t n) { return std::to_string(n) + (n == 1 ? " microphone" : " microphones"); }

void check_bits(const std::string& path, int bits, CheckReport& report) {
  if (bits != 8 && bits != 16 && bits != 24 && bits != 32 && report.sound(path)) {
    report.error(path, "is " + std::to_string(bits) + ", must be 8, 16, 24 or 32");
  }
}

void check_rates(const Configuration& config, CheckReport& report) {
  const int raw = config.raw.fs;
  const int rate = config.pipeline.general.samplerate.mu;
  if (raw < rate && report.sound("raw.fS") && report.sound("general.samplerate.mu")) {
    report.error("raw.fS", "is " + std::to_string(raw) +
                               " Hz, must be at least general.samplerate.mu, which is " +
                               std::to_string(rate) + " Hz");
  }
  check_bits("raw.nBits", config.raw.n_bits, report);
  check_bits("sss.separated.nBits", config.separated.n_bits, report);
  check_bits("sss.postfiltered.nBits", config.postfiltered.n_bits, report);
}

void check_mapping(const Configuration& config, CheckReport& report) {
  const std::size_t mics = config.pipeline.general.mics.size();
  const std::vector<int>& map = config.mapping.map;
  const int channels = config.raw.n_channels;
  const bool channels_known = report.sound("raw.nChannels");
  const bool mics_known = report.sound("general.mics");
  if (map.empty()) {
    if (channels_known && mics_known && mics > static_cast<std::size_t>(channels)) {
      report.error("raw.nChannels", "is " + std::to_string(channels) + ", fewer than the " + mics_text(mics) +
                                        " of general.mics");
    }
    return;
  }
  if (!report.sound("mapping.map")) return;
  if (mics_known && map.size() != mics) {
    report.error("mapping.map", "has " + std::to_string(map.size()) + " entries for the " + mics_text(mics) +
                                    " of general.mics; must have one for each");
  }
  std::set<int> seen;
  for (std::size_t i = 0; i < map.size(); ++i) {
    const std::string path = item("mapping.map", i);
    if (channels_known && map[i] > channels) {
      report.error(path, "is channel " + std::to_string(map[i]) + ", but raw.nChannels is " +
                             std::to_string(channels));
    } else if (map[i] > 0 && !seen.insert(map[i]).second) {
      report.warning(path, "channel " + std::to_string(map[i]) + " stands for another microphone already");
    }
  }
  if (mics_known && mics >= 2 && std::count(map.begin(), map.end(), 0) + 1 >= std::ssize(map)) {
    report.error("mapping.map", "fewer than two microphones are left that are not silent (0)");
  }
}

void check_reference(const Configuration& config, CheckReport& report) {
  const MappingConfig& mapping = config.mapping;
  if (mapping.reference.empty()) {
    if (report.written("mapping.echoLength")) {
      report.warning("mapping.echoLength", "has no effect without mapping.reference");
    }
    return;
  }
  if (!report.sound("mapping.reference")) return;
  const auto mics = static_cast<int>(config.pipeline.general.mics.size());
  std::set<int> seen;
  for (std::size_t i = 0; i < mapping.reference.size(); ++i) {
    const std::string path = item("mapping.reference", i);
    const int channel = mapping.reference[i];
    const std::string name = "channel " + std::to_string(channel);
    const bool is_mic = mapping.map.empty() ? channel <= mics
                                            : std::count(mapping.map.begin(), mapping.map.end(), channel) > 0;
    if (report.sound("raw.nChannels") && channel > config.raw.n_channels) {
      report.error(path, "is " + name + ", but raw.nChannels is " + std::to_string(config.raw.n_channels));
    } else if (is_mic) {
      report.warning(path, name + " is a microphone, too: it will hear nothing");
    } else if (!seen.insert(channel).second) {
      report.warning(path, name + " is a reference already");
    }
  }
}

void check_size(const GeneralConfig& general, CheckReport& report) {
  const auto [hop, frame] = general.size;
  if (!report.sound("general.size")) return;
  const int even = frame - frame % 2;
  if (hop > even) {
    report.error(
        "general.size.hopSize",
        "is " + std::to_string(hop) + ", must be at most frameSize, which is " + std::to_string(frame));
  } else if (2 * hop > even) {
    report.warning("general.size.hopSize",
                   "is more than half of frameSize: separated voices lose what lies between two windows");
  }
  if (frame != even) {
    report.warning("general.size.frameSize",
                   "is odd; becomes " + std::to_string(even) + ", as ODAS silently has it");
  }
}

void check_beam(const std::string& path, const std::array<float, 3>& direction,
                const std::array<float, 2>& angle, CheckReport& report) {
  if (report.sound(path + ".direction") && !(norm(vec(direction)) > 0)) {
    report.error(path + ".direction", "is (0, 0, 0), must point somewhere");
  }
  if (report.sound(path + ".angle") && angle[0] > angle[1]) {
    report.error(path + ".angle", "is (" + number_text(angle[0]) + ", " + number_text(angle[1]) +
                                      "): the first must not be larger than the second");
  }
}

/// A covariance matrix: no direction in which the variance is negative (Sylvester's criterion).
bool is_covariance(const std::array<float, 9>& s) {
  const double xy = 0.5 * (static_cast<double>(s[1]) + s[3]);
  const double xz = 0.5 * (static_cast<double>(s[2]) + s[6]);
  const double yz = 0.5 * (static_cast<double>(s[5]) + s[7]);
  const double xx = s[0], yy = s[4], zz = s[8];
  const double largest = std::max({xx, yy, zz});
  const double slack = 1e-6 * largest;  // of rounding
  const double det = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  return xx >= 0 && yy >= 0 && zz >= 0 && xx * yy - xy * xy >= -slack * largest &&
         xx * zz - xz * xz >= -slack * largest && yy * zz - yz * yz >= -slack * largest &&
         det >= -slack * largest * largest;
}

/// How far apart the two microphones are that are farthest apart, m. Names those that share a place.
float widest(const std::vector<MicConfig>& mics, CheckReport& report) {
  constexpr float kSamePlace = 1e-5F;  // m
  float aperture = 0;
  for (std::size_t j = 0; j < mics.size(); ++j) {
    bool alone = true;
    for (std::size_t i = 0; i < j; ++i) {
      const float distance = norm(vec(mics[i].mu) - vec(mics[j].mu));
      aperture = std::max(aperture, distance);
      if (distance < kSamePlace && alone) {
        alone = false;
        report.warning(item("general.mics", j) + ".mu",
                       "is the place of general.mics[" + std::to_string(i) +
                           "] too: their pair tells nothing of the direction");
      }
    }
  }
  return aperture;
}

void check_aperture(const Configuration& config, CheckReport& report) {
  const GeneralConfig& general = config.pipeline.general;
  const float aperture = widest(general.mics, report);
  if (!(aperture > 0)) return report.error("general.mics", "all microphones are at the same place");
  if (!report.sound("general.size") || !report.sound("general.samplerate") ||
      !report.sound("general.speedofsound")) {
    return;
  }
  const float samples = aperture * static_cast<float>(general.samplerate.mu) / general.speedofsound.mu;
  const auto frame = static_cast<float>(general.size.frame_size);
  const std::string apart = "the microphones are up to " + number_text(std::round(aperture * 1e4F) / 1e4F) +
                            " m apart, " + number_text(std::round(samples * 100) / 100) +
                            " samples on the way of sound";
  if (samples > frame / 2) {
    report.warning("general.mics", apart + ", more than half of general.size.frameSize (" +
                                       number_text(frame) + "): are the positions in metres?");
  } else if (report.sound("ssl") && samples * static_cast<float>(config.pipeline.ssl.interp_rate) < 1) {
    report.warning("general.mics",
                   apart + ": too close to tell directions apart; are the positions in metres?");
  }
}

void check_mics(const Configuration& config, CheckReport& report) {
  const std::vector<MicConfig>& mics = config.pipeline.general.mics;
  if (!report.sound("general.mics")) {
    // Their number or places are not known; what is known of each is still checked below.
  } else if (mics.size() < 2) {
    report.error("general.mics",
                 "has " + mics_text(mics.size()) + ", must have at least 2 to tell a direction");
  } else if (mics.size() > kMaxMics) {
    report.error("general.mics", "has " + mics_text(mics.size()) + ", can have at most 128");
  } else {
    check_aperture(config, report);
  }
  for (std::size_t i = 0; i < std::min(mics.size(), kMaxMics); ++i) {
    const std::string path = item("general.mics", i);
    check_beam(path, mics[i].direction, mics[i].angle, report);
    if (report.sound(path + ".sigma2") && !is_covariance(mics[i].sigma2)) {
      report.error(path + ".sigma2", "is no covariance: in some direction the variance is negative");
    }
  }
}

}  // namespace

void check_array(const Configuration& config, CheckReport& report) {
  const GeneralConfig& general = config.pipeline.general;
  check_rates(config, report);
  check_size(general, report);
  check_mapping(config, report);
  check_reference(config, report);
  check_mics(config, report);
  if (!general.spatialfilters) return;
  for (std::size_t i = 0; i < std::min<std::size_t>(general.spatialfilters->size(), kMaxMics); ++i) {
    const SpatialFilterConfig& filter = (*general.spatialfilters)[i];
    check_beam(item("general.spatialfilters", i), filter.direction, filter.angle, report);
  }
}

}  // namespace odas
