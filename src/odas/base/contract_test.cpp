// SPDX-License-Identifier: MIT
#include "odas/base/contract.hpp"

#include <gtest/gtest.h>

namespace odas::contract_test {
namespace {

TEST(Contract, Says_where_and_what_when_it_is_broken) {
  EXPECT_DEATH(contract_broken("x > 0", "file.cpp", 7), "file.cpp:7: broken contract: x > 0");
}

}  // namespace
}  // namespace odas::contract_test
