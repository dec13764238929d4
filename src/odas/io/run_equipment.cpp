// SPDX-License-Identifier: MIT
#include "odas/io/run_equipment.hpp"

namespace odas {
namespace {

TargetList first_targets(const Configuration& config) {
  TargetList list;
  list.assign(targets_of(config.pipeline.sst));
  return list;
}

}  // namespace

RunEquipment::RunEquipment(const Configuration& config, const SinkOptions& options)
    : sinks_(make_sinks(config, options)),
      heartbeat_(ServiceHeartbeat::from_environment()),
      targets_(first_targets(config)) {
  if (const InterfaceConfig& at = config.control.interface; at.type != "blackhole") {
    target_server_.emplace(at, targets_, [say = options.say](const std::string& what) {
      if (say) say("targets: " + what);
    });
  }
}

std::vector<Sink*> RunEquipment::sinks() const {
  std::vector<Sink*> all;
  for (const auto& sink : sinks_) all.push_back(sink.get());
  if (heartbeat_) all.push_back(heartbeat_.get());
  return all;
}

}  // namespace odas
