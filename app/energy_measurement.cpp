// SPDX-License-Identifier: MIT
#include "energy_measurement.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "odas/base/error.hpp"
#include "odas/engine/live.hpp"
#include "odas/engine/offline.hpp"

namespace odas {
namespace {

/// The beginning of another source.
class FirstSeconds : public AudioSource {
 public:
  FirstSeconds(AudioSource& source, double seconds)
      : source_(source), left_(static_cast<std::uint64_t>(std::lround(seconds * source.sample_rate()))) {
    total_ = source.total_frames() ? std::min(*source.total_frames(), left_) : left_;
  }

  [[nodiscard]] std::size_t channels() const noexcept override { return source_.channels(); }
  [[nodiscard]] int sample_rate() const noexcept override { return source_.sample_rate(); }
  [[nodiscard]] bool live() const noexcept override { return source_.live(); }
  [[nodiscard]] std::optional<std::uint64_t> total_frames() const noexcept override { return total_; }
  [[nodiscard]] std::string warning() const override { return source_.warning(); }

  [[nodiscard]] ReadResult read(GridView<float> block) override {
    ReadResult result = source_.read(block);
    result.frames = static_cast<std::size_t>(std::min<std::uint64_t>(result.frames, left_));
    left_ -= result.frames;
    if (left_ == 0) result.end = true;
    return result;
  }

 private:
  AudioSource& source_;
  std::uint64_t left_;
  std::uint64_t total_ = 0;
};

class EnergySink : public Sink {
 public:
  explicit EnergySink(const GeneralConfig& general)
      : hop_seconds_(static_cast<double>(general.size.hop_size) / general.samplerate.mu) {}

  [[nodiscard]] std::string name() const override { return "energies"; }
  [[nodiscard]] Wanted wanted() const noexcept override { return {true, false, false, false}; }
  IoStatus write(const HopResult& hop) override {
    constexpr double kSettling = 1;  // s
    heard_ += hop_seconds_;
    if (heard_ <= kSettling || hop.potentials.empty()) return {};
    energies.seconds += hop_seconds_;
    energies.strongest.add(static_cast<double>(hop.potentials.front().energy));
    for (const Potential& potential : hop.potentials.subspan(1)) {
      energies.others.add(static_cast<double>(potential.energy));
    }
    return {};
  }

  Energies energies;

 private:
  double hop_seconds_;
  double heard_ = 0;
};

}  // namespace

Energies measure_energies(AudioSource& source, const Configuration& config, Pipeline& pipeline,
                          double seconds, const RunOptions& options) {
  constexpr double kEndless = 1e7;
  FirstSeconds part(source, seconds > 0 ? seconds : kEndless);
  EnergySink sink(config.pipeline.general);
  const std::array<Sink*, 1> sinks{&sink};
  const auto run = source.live() ? run_live : run_offline;
  const RunSummary summary = run(part, config, pipeline, sinks, options);
  if (summary.exit_code() != 0) throw IoError(summary.fault);
  return sink.energies;
}

}  // namespace odas
