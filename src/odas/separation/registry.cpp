// SPDX-License-Identifier: MIT
#include "odas/separation/registry.hpp"

#include <array>
#include <string>

#include "odas/base/error.hpp"
#include "odas/separation/adaptive_beamformer.hpp"
#include "odas/separation/delay_and_sum.hpp"
#include "odas/separation/gss.hpp"
#include "odas/separation/mask_filter.hpp"
#include "odas/separation/multi_source_filter.hpp"
#include "odas/separation/single_source_filter.hpp"

namespace odas {
namespace {

struct BeamformerRow {
  std::string_view name;
  std::unique_ptr<Beamformer> (*make)(const SssConfig&, const GeneralConfig&, std::size_t slots);
};

struct PostFilterRow {
  std::string_view name;
  std::unique_ptr<PostFilter> (*make)(const SssConfig&, const McraConfig&, const GeneralConfig&,
                                      std::size_t slots);
};

template <class T>
using Ptr = std::unique_ptr<T>;

constexpr std::array kBeamformers{
    BeamformerRow{"dds",
                  [](const SssConfig&, const GeneralConfig& general, std::size_t slots) -> Ptr<Beamformer> {
                    return std::make_unique<DelayAndSum>(general, slots);
                  }},
    BeamformerRow{
        "dgss",
        [](const SssConfig& config, const GeneralConfig& general, std::size_t slots) -> Ptr<Beamformer> {
          return std::make_unique<GeometricSeparation>(config.dgss, general, slots);
        }},
    BeamformerRow{
        "dmvdr",
        [](const SssConfig& config, const GeneralConfig& general, std::size_t slots) -> Ptr<Beamformer> {
          return std::make_unique<AdaptiveBeamformer>(AdaptiveBeamformer::Criterion::mvdr, config.dmvdr,
                                                      general, slots);
        }},
    BeamformerRow{
        "dgev",
        [](const SssConfig& config, const GeneralConfig& general, std::size_t slots) -> Ptr<Beamformer> {
          return std::make_unique<AdaptiveBeamformer>(AdaptiveBeamformer::Criterion::gev, config.dgev,
                                                      general, slots);
        }},
};

constexpr std::array kPostFilters{
    PostFilterRow{"ms",
                  [](const SssConfig& config, const McraConfig& sne, const GeneralConfig& general,
                     std::size_t slots) -> Ptr<PostFilter> {
                    return std::make_unique<MultiSourceFilter>(config.ms, sne, general, slots);
                  }},
    PostFilterRow{"ss",
                  [](const SssConfig& config, const McraConfig&, const GeneralConfig& general,
                     std::size_t) -> Ptr<PostFilter> {
                    return std::make_unique<SingleSourceFilter>(config.ss, general);
                  }},
    PostFilterRow{"mask",
                  [](const SssConfig& config, const McraConfig&, const GeneralConfig& general,
                     std::size_t slots) -> Ptr<PostFilter> {
                    return std::make_unique<MaskFilter>(config.mask, general, slots);
                  }},
};

template <class Rows>
const auto& find(const Rows& rows, const std::string& name, const char* path) {
  std::string names;
  for (const auto& row : rows) {
    if (row.name == name) return row;
    names += (names.empty() ? "" : ", ") + std::string(row.name);
  }
  throw ConfigError(path, "\"" + name + "\" is not there; allowed: " + names);
}

template <class Rows>
std::vector<std::string_view> names_of(const Rows& rows) {
  std::vector<std::string_view> names;
  for (const auto& row : rows) names.push_back(row.name);
  return names;
}

}  // namespace

std::unique_ptr<Beamformer> make_beamformer(const SssConfig& config, const GeneralConfig& general,
                                            std::size_t slots) {
  return find(kBeamformers, config.mode_sep, "sss.mode_sep").make(config, general, slots);
}

std::unique_ptr<PostFilter> make_post_filter(const SssConfig& config, const McraConfig& sne,
                                             const GeneralConfig& general, std::size_t slots) {
  return find(kPostFilters, config.mode_pf, "sss.mode_pf").make(config, sne, general, slots);
}

std::vector<std::string_view> beamformer_names() { return names_of(kBeamformers); }
std::vector<std::string_view> post_filter_names() { return names_of(kPostFilters); }

}  // namespace odas
