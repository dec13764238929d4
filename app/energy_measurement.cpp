// SPDX-License-Identifier: MIT
#include "energy_measurement.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "first_seconds.hpp"

#include "odas/base/error.hpp"
#include "odas/engine/live.hpp"
#include "odas/engine/offline.hpp"

namespace odas {
namespace {

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
