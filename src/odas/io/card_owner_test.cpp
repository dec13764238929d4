// SPDX-License-Identifier: MIT
#include "odas/io/card_owner.hpp"

#include "support/scratch.hpp"
#include <gtest/gtest.h>

namespace odas::card_owner_test {
namespace {

TEST(CardOwner, is_the_program_that_captures) {
  const test::Scratch proc;
  std::filesystem::create_directories(proc / "asound/card1/pcm0c/sub0");
  std::filesystem::create_directories(proc / "1234");
  std::filesystem::create_directory_symlink("card1", proc / "asound/Array");
  test::write_file(proc / "asound/card1/pcm0c/sub0/status",
                   "state: RUNNING\nowner_pid   : 1234\ntrigger_time: 1\n");
  test::write_file(proc / "1234/comm", "arecord\n");
  for (const char* pcm :
       {"hw:1,0", "hw:1", "plughw:1,0", "hw:CARD=1,DEV=0", "hw:CARD=Array,DEV=0", "hw:Array"}) {
    EXPECT_EQ(owner_of_card(pcm, proc.folder()), "arecord (process 1234)") << pcm;
  }
}

TEST(CardOwner, is_nobody_where_it_cannot_be_told) {
  const test::Scratch proc;
  std::filesystem::create_directories(proc / "asound/card1/pcm0c/sub0");
  test::write_file(proc / "asound/card1/pcm0c/sub0/status", "closed\n");
  for (const char* pcm : {"hw:1,0", "hw:2,0", "default", "hw:", "hw:../../etc,0"}) {
    EXPECT_EQ(owner_of_card(pcm, proc.folder()), "") << pcm;
  }
}

}  // namespace
}  // namespace odas::card_owner_test
