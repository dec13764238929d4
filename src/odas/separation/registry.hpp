// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include "odas/array/config.hpp"
#include "odas/dsp/mcra_config.hpp"
#include "odas/separation/beamformer.hpp"
#include "odas/separation/config.hpp"
#include "odas/separation/post_filter.hpp"

namespace odas {

/// The beamformer that `sss.mode_sep` names. Throws ConfigError for a name that is not there.
[[nodiscard]] std::unique_ptr<Beamformer> make_beamformer(const SssConfig& config,
                                                          const GeneralConfig& general, std::size_t slots);

/// The post-filter that `sss.mode_pf` names; `sne` says how it follows the noise of a beam.
/// Throws ConfigError for a name that is not there.
[[nodiscard]] std::unique_ptr<PostFilter> make_post_filter(const SssConfig& config, const McraConfig& sne,
                                                           const GeneralConfig& general, std::size_t slots);

/// The names that can be made.
[[nodiscard]] std::vector<std::string_view> beamformer_names();
[[nodiscard]] std::vector<std::string_view> post_filter_names();

}  // namespace odas
