// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <set>

#include "odas/base/vec3.hpp"
#include "odas/config/checks.hpp"
#include "odas/config/phrases.hpp"

namespace odas {

namespace {

constexpr std::size_t kMaxSlots = 64;
constexpr std::size_t kMaxTag = 63;                // bytes; what a track holds in place
constexpr long long kMaxCorrelation = 1LL << 18U;  // lags of a cross-correlation, used or not

std::string of_list(const std::string& list, std::size_t i) { return list + "[" + std::to_string(i) + "]"; }

long long grid_points(int level) { return 10 * (1LL << (2 * level)) + 2; }

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t more = lead < 0x80                   ? 0
                             : lead >= 0xC2 && lead < 0xE0 ? 1
                             : lead >= 0xE0 && lead < 0xF0 ? 2
                             : lead >= 0xF0 && lead < 0xF5 ? 3
                                                           : 4;
    if (more == 4 || i + more >= text.size()) return false;
    for (std::size_t k = 1; k <= more; ++k) {
      if ((static_cast<unsigned char>(text[i + k]) & 0xC0U) != 0x80U) return false;
    }
    i += more + 1;
  }
  return true;
}

void check_ssl(const Configuration& config, CheckReport& report) {
  const SslConfig& ssl = config.pipeline.ssl;
  const int frame = config.pipeline.general.size.frame_size;
  if (!report.sound("ssl.scans")) return;
  if (ssl.scans.empty()) return report.error("ssl.scans", "is empty, must have at least one level");
  for (std::size_t i = 1; i < ssl.scans.size(); ++i) {
    if (ssl.scans[i].level <= ssl.scans[i - 1].level) {
      report.error(of_list("ssl.scans", i) + ".level",
                   "is " + std::to_string(ssl.scans[i].level) + " after " +
                       std::to_string(ssl.scans[i - 1].level) + ": levels must rise, from coarse to fine");
    }
  }
  if (report.sound("ssl.nPots") && ssl.n_pots > grid_points(ssl.scans.back().level)) {
    report.error("ssl.nPots", "is " + std::to_string(ssl.n_pots) + ", more than the " +
                                  std::to_string(grid_points(ssl.scans.back().level)) +
                                  " directions of the finest scan");
  }
  if (report.sound("ssl.nMatches") && ssl.scans.size() > 1 &&
      ssl.n_matches > grid_points(ssl.scans.front().level)) {
    report.warning("ssl.nMatches", "is " + std::to_string(ssl.n_matches) + ", more than the " +
                                       std::to_string(grid_points(ssl.scans.front().level)) +
                                       " directions of the coarsest scan: all of them are taken");
  }
  if (!report.sound("ssl.interpRate") || !report.sound("general.size")) return;
  const long long lags = static_cast<long long>(ssl.interp_rate) * frame;
  if (lags > kMaxCorrelation) {
    return report.error("ssl.interpRate", "times general.size.frameSize is " + std::to_string(lags) +
                                              ", must be at most " + std::to_string(kMaxCorrelation));
  }
  for (std::size_t i = 0; i < ssl.scans.size(); ++i) {
    if (ssl.scans[i].delta > lags / 2) {
      report.error(of_list("ssl.scans", i) + ".delta", "is " + std::to_string(ssl.scans[i].delta) +
                                                           ", more than half of the correlation (" +
                                                           std::to_string(lags / 2) + ")");
    }
  }
}

void check_mixture(const std::string& path, const std::vector<GaussianConfig>& mixture, CheckReport& report) {
  if (!report.sound(path)) return;
  float sum = 0;
  for (const GaussianConfig& gaussian : mixture) sum += gaussian.weight;
  if (mixture.empty()) {
    report.error(path, "is empty, must have at least one Gaussian");
  } else if (!(sum > 0)) {
    report.error(path, "has weights that are all 0");
  }
}

void check_targets(const SstConfig& sst, CheckReport& report) {
  std::set<std::string> tags;
  for (std::size_t i = 0; i < sst.target.size(); ++i) {
    const TargetConfig& target = sst.target[i];
    const std::string path = of_list("sst.target", i);
    if (!report.sound(path)) continue;
    if (target.tag.empty()) {
      report.error(path + ".tag", "is empty: every target needs a name");
    } else if (target.tag == "dynamic") {
      report.error(path + ".tag", "is \"dynamic\", the name of the tracks that come and go; take another");
    } else if (target.tag.size() > kMaxTag) {
      report.error(path + ".tag", "has " + std::to_string(target.tag.size()) + " bytes, can have at most 63");
    } else if (!is_utf8(target.tag)) {
      report.error(path + ".tag", "is no UTF-8 text");
    } else if (!tags.insert(target.tag).second) {
      report.error(path + ".tag", "\"" + target.tag + "\" is the name of another target");
    }
    if (target.x == 0 && target.y == 0 && target.z == 0) {
      report.error(path, "points nowhere: x, y and z are all 0");
    }
  }
  if (report.sound("sst.N_inactive") && sst.target.size() > sst.slots()) {
    report.warning("sst.target", "has " + std::to_string(sst.target.size()) + " targets for the " +
                                     std::to_string(sst.slots()) + " tracks of " +
                                     (sst.n_tracks > 0 ? "sst.nTracks" : "sst.N_inactive") +
                                     ": the last ones are not followed");
  }
  if (sst.add == "static" && sst.target.empty() && report.sound("sst")) {
    report.warning("sst.add", "is \"static\", and sst.target is empty: nothing will be followed");
  }
}

void check_sst(const SstConfig& sst, CheckReport& report) {
  check_mixture("sst.active", sst.active, report);
  check_mixture("sst.inactive", sst.inactive, report);
  const std::size_t patiences = sst.n_inactive.size();
  if (report.sound("sst.N_inactive") && (patiences == 0 || patiences > kMaxSlots)) {
    report.error("sst.N_inactive",
                 "has " + std::to_string(patiences) + " numbers, must have one for each track: 1 to 64");
  }
  if (report.sound("sst.Pfalse") && report.sound("sst.Pnew") && report.sound("sst.Ptrack") &&
      !(sst.p_false + sst.p_new + sst.p_track > 0)) {
    report.error("sst.Pfalse", "is 0, and so are Pnew and Ptrack: one of them must not be");
  }
  const ParticleConfig& p = sst.particle;
  const float ratios = p.st_ratio + p.ve_ratio + p.ac_ratio;
  if (sst.mode == "particle" && report.sound("sst.particle") && std::abs(ratios - 1) > 0.001F) {
    report.warning("sst.particle",
                   "st_ratio, ve_ratio and ac_ratio add up to " + number_text(ratios) + ", not 1");
  }
  check_targets(sst, report);
}

void check_windows(const Configuration& config, CheckReport& report) {
  if (!report.sound("general.size") || !report.sound("sss.frameSize")) return;
  const auto frame = static_cast<int>(separation_frame(config.pipeline));
  if (frame < config.pipeline.general.size.hop_size && frame != config.pipeline.general.size.frame_size) {
    report.error("sss.frameSize", "is " + std::to_string(config.pipeline.sss.frame_size) +
                                      ", must be at least general.size.hopSize, which is " +
                                      std::to_string(config.pipeline.general.size.hop_size));
  }
  const int heard = config.pipeline.general.size.frame_size;
  const std::string whose = frame == heard ? "general.size.frameSize" : "sss.frameSize";
  const MultiSourceFilterConfig& ms = config.pipeline.sss.ms;
  const auto check = [&](const char* path, int size) {
    if (size <= frame || !report.sound(path)) return;
    const std::string what =
        "is " + std::to_string(size) + ", must be at most " + whose + ", which is " + std::to_string(frame);
    // Many files carry the settings of a post-filter that they do not use.
    if (config.pipeline.sss.mode_pf == "ms") {
      report.error(path, what);
    } else {
      report.warning(path, what + "; unused with mode_pf = \"" + config.pipeline.sss.mode_pf + "\"");
    }
  };
  check("sss.ms.winSizeLocal", ms.win_size_local);
  check("sss.ms.winSizeGlobal", ms.win_size_global);
  check("sss.ms.winSizeFrame", ms.win_size_frame);
  if (report.sound("sne.b") && config.pipeline.sne.b > std::min(frame, heard) / 2 + 1) {
    report.error("sne.b", "is " + std::to_string(config.pipeline.sne.b) + ", more than the " +
                              std::to_string(std::min(frame, heard) / 2 + 1) + " bins of a frame");
  }
}

/// Of a track that dies before its last sound has passed the look-back, that much is lost.
void check_lookback(const PipelineConfig& config, CheckReport& report) {
  if (!report.sound("sss.lookback") || !report.sound("sst.N_inactive") || !report.sound("general")) return;
  const std::size_t hops = lookback_hops(config);
  const int patience = *std::min_element(config.sst.n_inactive.begin(), config.sst.n_inactive.end());
  if (static_cast<std::size_t>(patience) >= hops) return;
  report.warning("sss.lookback", "is " + std::to_string(hops) +
                                     " hops, longer than a track outlives its talker (sst.N_inactive is " +
                                     std::to_string(patience) + "): the ends of voices may be lost");
}

void check_classify(const ClassifyConfig& classify, CheckReport& report) {
  if (!report.sound("classify")) return;
  if (classify.tau_min >= classify.tau_max) {
    report.error("classify.tauMin", "is " + number_text(classify.tau_min) +
                                        ", must be less than tauMax, which is " +
                                        number_text(classify.tau_max));
  }
  if (classify.tau_max >= static_cast<float>(classify.frame_size)) {
    report.error("classify.tauMax", "is " + number_text(classify.tau_max) +
                                        ", must be less than frameSize, which is " +
                                        std::to_string(classify.frame_size));
  }
}

}  // namespace

void check_stages(const Configuration& config, CheckReport& report) {
  check_ssl(config, report);
  check_sst(config.pipeline.sst, report);
  check_windows(config, report);
  check_lookback(config.pipeline, report);
  check_classify(config.pipeline.classify, report);
}

}  // namespace odas
