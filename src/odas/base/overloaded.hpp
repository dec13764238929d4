// SPDX-License-Identifier: MIT
#pragma once

namespace odas {

/// Functions under one name, for std::visit: each alternative takes the one that fits.
template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

}  // namespace odas
