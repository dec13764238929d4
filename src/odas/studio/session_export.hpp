// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

#include "odas/studio/session_reader.hpp"

namespace odas {

/// Formats that other programs read; docs/protocol.md has their columns.
enum class ExportFormat { csv, jsonl, rttm };
[[nodiscard]] std::optional<ExportFormat> export_format(std::string_view name) noexcept;

/// Writes the tracks of a session. `name`: of the recording, in RTTM. "", or how far the session went, where
/// it was cut off or damaged: what stands before that is written.
std::string export_session(const SessionReader& session, ExportFormat format, const std::string& name,
                           std::ostream& out);

}  // namespace odas
