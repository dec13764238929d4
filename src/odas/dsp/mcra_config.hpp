// SPDX-License-Identifier: MIT
#pragma once

#include "odas/base/field.hpp"

namespace odas {

/// The noise estimate (MCRA): section `sne`.
struct McraConfig {
  int b = 3;
  float alpha_s = 0.1F;
  int l = 150;
  float delta = 3;
  float alpha_d = 0.1F;
  static Schema schema();
  friend bool operator==(const McraConfig&, const McraConfig&) = default;
};

}  // namespace odas
