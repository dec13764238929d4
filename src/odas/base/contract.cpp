// SPDX-License-Identifier: MIT
#include "odas/base/contract.hpp"

#include <cstdio>
#include <cstdlib>

namespace odas {

void contract_broken(const char* condition, const char* file, int line) noexcept {
  std::fprintf(stderr, "%s:%d: broken contract: %s\n", file, line, condition);
  std::abort();
}

}  // namespace odas
