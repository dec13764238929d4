// SPDX-License-Identifier: MIT
#include "odas/localization/registry.hpp"

#include "odas/base/error.hpp"
#include "odas/localization/srp_clean.hpp"
#include "odas/localization/srp_phat.hpp"

namespace odas {

std::unique_ptr<Localizer> make_localizer(const GeneralConfig& general, const SslConfig& ssl) {
  if (ssl.mode == "srp_phat") return std::make_unique<SrpPhat>(general, ssl);
  if (ssl.mode == "srp_clean") return std::make_unique<SrpClean>(general, ssl);
  throw ConfigError("ssl.mode", "\"" + ssl.mode + "\" is no localizer; there are srp_phat and srp_clean");
}

}  // namespace odas
