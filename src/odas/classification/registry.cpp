// SPDX-License-Identifier: MIT
#include "odas/classification/registry.hpp"

#include "odas/base/error.hpp"
#include "odas/classification/pitch_classifier.hpp"

namespace odas {

std::unique_ptr<Classifier> make_classifier(const ClassifyConfig& config, std::size_t hop_size,
                                            std::size_t slots) {
  if (config.mode == "pitch") return std::make_unique<PitchClassifier>(config, hop_size, slots);
  throw ConfigError("classify.mode", "\"" + config.mode + "\" is no classifier; there is pitch");
}

}  // namespace odas
