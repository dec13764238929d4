// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "odas/studio/document.hpp"
#include "odas/studio/hop_listener.hpp"

namespace odas {

/// What a document is as a run, but for its number, its kind, its start and the grid of its power map.
[[nodiscard]] StreamInfo stream_info(const CheckedDocument& checked);

/// Where the microphones come from, in short: "hw:CARD=Array", "meeting.wav", "127.0.0.1:9000".
[[nodiscard]] std::string source_text(const RawConfig& raw);

}  // namespace odas
