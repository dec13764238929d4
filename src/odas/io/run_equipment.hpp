// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "odas/engine/config.hpp"
#include "odas/engine/sink.hpp"
#include "odas/engine/target_inbox.hpp"
#include "odas/io/registry.hpp"
#include "odas/io/service_heartbeat.hpp"
#include "odas/io/target_server.hpp"

namespace odas {

/// What a run of a configuration has beside its source and its pipeline: the sinks that it names, the
/// heartbeat of a service, and fixed directions that come and go.
class RunEquipment {
 public:
  /// Opens all of it. `config` and what `options` names outlive it; `options.say` is called in several
  /// threads. Throws ConfigError and IoError.
  RunEquipment(const Configuration& config, const SinkOptions& options);

  [[nodiscard]] std::vector<Sink*> sinks() const;
  [[nodiscard]] TargetInbox& targets() noexcept { return targets_; }
  /// Somebody may send targets: `sst.control`.
  [[nodiscard]] bool takes_targets() const noexcept { return target_server_.has_value(); }

 private:
  std::vector<std::unique_ptr<Sink>> sinks_;
  std::unique_ptr<ServiceHeartbeat> heartbeat_;
  TargetInbox targets_;
  std::optional<TargetServer> target_server_;
};

}  // namespace odas
