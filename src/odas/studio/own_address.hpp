// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace odas {

/// The address of IPv4 at which others in the network find this machine, of several that of the first card;
/// "" where there is none but loopback. An address, for names of a machine are not known to every phone.
[[nodiscard]] std::string own_address();

}  // namespace odas
