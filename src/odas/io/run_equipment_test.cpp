// SPDX-License-Identifier: MIT
#include "odas/io/run_equipment.hpp"

#include "support/fake_io.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/base/error.hpp"

namespace odas::run_equipment_test {
namespace {

TEST(RunEquipment, opens_what_the_configuration_names) {
  const test::Scratch scratch;
  Configuration config = test::small_configuration();
  config.tracked.format = "json";
  config.tracked.interface.type = "file";
  config.tracked.interface.path = (scratch / "tracks.json").string();
  config.pipeline.sst.target = {{"door", 1, 0, 0}};
  const RunEquipment equipment(config, {});
  ASSERT_EQ(equipment.sinks().size(), 1U);
  EXPECT_TRUE(std::filesystem::exists(scratch / "tracks.json"));
  EXPECT_FALSE(equipment.takes_targets());
}

TEST(RunEquipment, begins_with_the_targets_of_the_configuration_and_listens_for_more) {
  Configuration config = test::small_configuration();
  config.pipeline.sst.target = {{"door", 1, 0, 0}};
  config.control.interface.type = "socket_listen";
  RunEquipment equipment(config, {});
  EXPECT_TRUE(equipment.takes_targets());
  const TargetList targets = equipment.targets().orders().targets;
  ASSERT_EQ(targets.view().size(), 1U);
  EXPECT_EQ(targets.view()[0].tag.view(), "door");
}

TEST(RunEquipment, says_what_cannot_be_opened) {
  Configuration config = test::small_configuration();
  config.tracked.format = "json";
  config.tracked.interface.type = "file";
  config.tracked.interface.path = "/nowhere/at/all.json";
  EXPECT_THROW(RunEquipment(config, {}), IoError);
}

}  // namespace
}  // namespace odas::run_equipment_test
