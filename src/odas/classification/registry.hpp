// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>

#include "odas/classification/classifier.hpp"
#include "odas/classification/config.hpp"

namespace odas {

/// The classifier that `classify.mode` names. Throws ConfigError for a name that is not there.
[[nodiscard]] std::unique_ptr<Classifier> make_classifier(const ClassifyConfig& config, std::size_t hop_size,
                                                          std::size_t slots);

}  // namespace odas
