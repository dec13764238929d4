// SPDX-License-Identifier: MIT
#pragma once

#include "odas/studio/engine_host.hpp"
#include "odas/studio/rpc.hpp"

namespace odas {

/// The commands `engine.*`, `config.get`, `config.apply`, `config.revert`, `config.save` and `targets.set`:
/// those that need the engine.
void add_engine_methods(RpcRegistry& rpc, EngineHost& host, Announcer& to);

/// As `targets` of `hello.run` and of the message `targets`.
[[nodiscard]] nlohmann::json targets_json(const TargetInbox::Orders& orders);

/// Faults as `data.faults` of an `invalid`.
[[nodiscard]] nlohmann::json faults_json(const std::vector<Fault>& faults);
[[nodiscard]] RpcError invalid(const ConfigError& error);

}  // namespace odas
