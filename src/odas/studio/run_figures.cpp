// SPDX-License-Identifier: MIT
#include "odas/studio/run_figures.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <unistd.h>

namespace odas {
namespace {

constexpr std::size_t kLooks = 10;

double us(std::chrono::nanoseconds time) { return static_cast<double>(time.count()) / 1000; }

/// Of the sound that was processed since `before`.
double share_since(const Metrics& before, const Metrics& now) {
  const double sound = now.sound_seconds - before.sound_seconds;
  const std::chrono::duration<double> busy = now.hop_time.total() - before.hop_time.total();
  return sound > 0 ? busy.count() / sound : 0;
}

/// `[["localization",us],...]`: the mean of the hops since `before`. Stages that are not there cost no more
/// than a look at the clock, and are left out.
nlohmann::json stages_since(const Metrics& before, const Metrics& now) {
  constexpr double kLook = 0.1;  // us
  nlohmann::json stages = nlohmann::json::array();
  const auto hops = static_cast<double>(now.hops - before.hops);
  for (std::size_t s = 0; s < kStages && hops > 0; ++s) {
    const auto ns = static_cast<double>(now.stage_times[s] - before.stage_times[s]);
    const double mean = std::round(ns / hops / 100) / 10;
    if (mean > kLook) stages.push_back({name_of(static_cast<Stage>(s)), mean});
  }
  return stages;
}

}  // namespace

void HealthFigures::begin(std::shared_ptr<RunFigures> run) {
  const std::lock_guard lock(mutex_);
  run_ = std::move(run);
  looks_.clear();
}

nlohmann::json HealthFigures::read() {
  const std::lock_guard lock(mutex_);
  nlohmann::json figures{{"cpu", cpu_share()}, {"rss_bytes", resident_bytes()}, {"temperature", nullptr}};
  if (const double hot = temperature(); std::isfinite(hot)) figures["temperature"] = hot;
  const Metrics now = run_ ? run_->engine.read() : Metrics();
  // Those who ask more often than once a second must not shorten the window.
  const Clock::time_point instant = Clock::now();
  if (looks_.empty() || instant - looks_.back().at >= std::chrono::milliseconds(900)) {
    looks_.push_back({instant, now});
    if (looks_.size() > kLooks) looks_.pop_front();
  }
  const Metrics& before = looks_.front().metrics;
  const bool is_first = before.hops == now.hops;
  const TimeHistogram recent = is_first ? now.hop_time : now.hop_time.since(before.hop_time);
  figures.update({{"hops", now.hops},
                  {"hop_p50_us", us(recent.quantile(0.5))},
                  {"hop_p99_us", us(recent.quantile(0.99))},
                  {"hop_max_us", us(now.hop_time.max())},
                  {"real_time_share", is_first ? now.real_time_share() : share_since(before, now)},
                  {"dropped_hops", now.dropped_hops},
                  {"lost_records", run_ ? run_->lost_records.load() : 0},
                  {"overruns", now.overruns},
                  {"lost_frames", now.lost_frames},
                  {"clipped_samples", run_ ? run_->clipped_samples.load() : 0},
                  {"stages", stages_since(is_first ? Metrics() : before, now)}});
  return figures;
}

double HealthFigures::cpu_share() {
  const Clock::time_point now = Clock::now();
  const std::chrono::duration<double> passed = now - cpu_at_;
  if (passed.count() < 0.5) return cpu_share_;
  const double seconds = process_cpu_seconds();
  cpu_share_ = std::max(0.0, (seconds - cpu_seconds_) / passed.count());
  cpu_seconds_ = seconds;
  cpu_at_ = now;
  return cpu_share_;
}

double process_cpu_seconds() {
  rusage usage{};
  if (::getrusage(RUSAGE_SELF, &usage) != 0) return 0;
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::uint64_t resident_bytes() {
  std::ifstream file("/proc/self/statm");
  std::uint64_t all = 0, resident = 0;
  if (!(file >> all >> resident)) return 0;
  return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

double temperature() {
  double hottest = std::numeric_limits<double>::quiet_NaN();
  std::error_code error;
  for (const auto& zone : std::filesystem::directory_iterator("/sys/class/thermal", error)) {
    std::ifstream file(zone.path() / "temp");
    if (double millidegrees = 0; file >> millidegrees) { hottest = std::fmax(hottest, millidegrees / 1000); }
  }
  return hottest;
}

}  // namespace odas
