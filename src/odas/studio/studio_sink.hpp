// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "odas/engine/sink.hpp"
#include "odas/studio/hop_listener.hpp"
#include "odas/studio/run_figures.hpp"

namespace odas {

/// Hands every hop of a run to the Studio's listeners, and adds up what the other sinks have counted: it is
/// called in the same thread as they.
class StudioSink : public Sink {
 public:
  StudioSink(const std::vector<HopListener*>& listeners, std::vector<Sink*> others,
             std::shared_ptr<RunFigures> figures)
      : listeners_(listeners), others_(std::move(others)), figures_(std::move(figures)) {}

  [[nodiscard]] std::string name() const override { return "studio"; }
  [[nodiscard]] Wanted wanted() const noexcept override;
  IoStatus write(const HopResult& hop) override;
  IoStatus flush() override;

  /// Any thread: listeners are told before the next hop that the run goes on otherwise.
  void change(StreamInfo info);

 private:
  const std::vector<HopListener*>& listeners_;
  std::vector<Sink*> others_;
  std::shared_ptr<RunFigures> figures_;
  std::mutex mutex_;
  std::optional<StreamInfo> changed_;  // guarded by mutex_
  std::atomic<bool> has_changed_{false};
};

}  // namespace odas
