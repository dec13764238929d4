// SPDX-License-Identifier: MIT
// The page of the report: readable files in io/report/, put into the program by odas_embed_text (CMake).
#pragma once

#include <string_view>

namespace odas {

extern const std::string_view kReportHtml;
extern const std::string_view kReportCss;
extern const std::string_view kDataJs;
extern const std::string_view kTimelineJs;
extern const std::string_view kSphereJs;
extern const std::string_view kPlayerJs;
extern const std::string_view kPageJs;

}  // namespace odas
