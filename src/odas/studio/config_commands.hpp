// SPDX-License-Identifier: MIT
#pragma once

#include "odas/studio/engine_host.hpp"
#include "odas/studio/rpc.hpp"

namespace odas {

/// The commands that only look: `config.form`, `config.check`, `config.edit`, `arrays.*`, `array.check` and
/// `devices.list`. `host`: what runs, to compare with.
void add_config_methods(RpcRegistry& rpc, EngineHost& host);

}  // namespace odas
