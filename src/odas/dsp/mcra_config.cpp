// SPDX-License-Identifier: MIT
#include "odas/dsp/mcra_config.hpp"

namespace odas {

Schema McraConfig::schema() {
  static const std::vector<Field> fields{
      field<&McraConfig::b>("b", "bins", {1, 1023}, "length of the smoothing window over frequency; odd"),
      field<&McraConfig::alpha_s>("alphaS", "", kUnit, "weight of the new value in the smoothing over time"),
      field<&McraConfig::l>("L", "hops", {1, 1000000}, "length of the minimum search"),
      field<&McraConfig::delta>("delta", "", kPositive,
                                "ratio of power to minimum from which speech is assumed"),
      field<&McraConfig::alpha_d>("alphaD", "", kUnit, "weight of the new value in the noise estimate"),
  };
  return fields;
}

}  // namespace odas
