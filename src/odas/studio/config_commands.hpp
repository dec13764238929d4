// SPDX-License-Identifier: MIT
#pragma once

#include "odas/studio/engine_host.hpp"
#include "odas/studio/rpc.hpp"

namespace odas {

/// The commands that only look: `config.check`, `arrays.list` and `arrays.get`. `host`: what runs, to compare
/// with.
void add_config_methods(RpcRegistry& rpc, EngineHost& host);

}  // namespace odas
