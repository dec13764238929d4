// SPDX-License-Identifier: MIT
// Small configurations and questions about the faults in them.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "odas/config/reader.hpp"

namespace odas::test {

/// The least that a configuration must say: two microphones.
inline constexpr std::string_view kLeast = R"(raw: { fS = 16000; nChannels = 2; };
general: {
  mics = (
    { mu = (0.05, 0.0, 0.0); },
    { mu = (-0.05, 0.0, 0.0); }
  );
};
)";

/// `kLeast`, and more sections.
inline LoadedConfiguration read_with(std::string_view more) {
  return read_configuration_text(std::string(kLeast) + std::string(more), "test.cfg");
}

/// `kLeast` with one piece of it written otherwise.
inline LoadedConfiguration read_changed(std::string_view from, std::string_view to) {
  std::string text(kLeast);
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  return read_configuration_text(text, "test.cfg");
}

inline std::string all_of(const std::vector<Fault>& faults) {
  std::string text;
  for (const Fault& fault : faults) text += to_string(fault) + "\n";
  return text;
}

inline ::testing::AssertionResult says(const LoadedConfiguration& loaded, Fault::Severity severity,
                                       std::string_view path, std::string_view piece) {
  const bool found = std::any_of(loaded.faults.begin(), loaded.faults.end(), [&](const Fault& fault) {
    return fault.severity == severity && fault.path == path && fault.what.find(piece) != std::string::npos;
  });
  if (found) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "no such fault among:\n" << all_of(loaded.faults);
}

/// An error at this path that says this piece of text.
inline ::testing::AssertionResult errs(const LoadedConfiguration& loaded, std::string_view path,
                                       std::string_view piece) {
  return says(loaded, Fault::Severity::error, path, piece);
}

inline ::testing::AssertionResult warns(const LoadedConfiguration& loaded, std::string_view path,
                                        std::string_view piece) {
  return says(loaded, Fault::Severity::warning, path, piece);
}

inline ::testing::AssertionResult clean(const LoadedConfiguration& loaded) {
  if (loaded.faults.empty()) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << all_of(loaded.faults);
}

}  // namespace odas::test
