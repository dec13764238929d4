// SPDX-License-Identifier: MIT
#include "odas/studio/session_shelf.hpp"

#include "support/hop_maker.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/studio/rpc.hpp"
#include "odas/studio/session_recorder.hpp"

namespace odas::session_shelf_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string make_session(const test::Scratch& scratch, bool close = true) {
  test::HopMaker hops;
  SessionRecorder session(scratch.folder(), {true, false, true});
  EXPECT_TRUE(session.begin(hops.info()).ok());
  for (int i = 0; i < 125; ++i) EXPECT_TRUE(session.hop(hops.next({1, 0})).ok());
  EXPECT_TRUE((close ? session.close() : session.flush()).ok());
  return session.name();
}

TEST(SessionShelf, lists_sessions_of_a_studio_also_those_that_were_cut) {
  const test::Scratch scratch;
  const std::string whole = make_session(scratch), cut = make_session(scratch, false);
  test::write_file(scratch / "foreign.mcap", "nothing of ours");
  test::write_file(scratch / "notes.txt", "mine");
  SessionShelf shelf(scratch.folder());
  const json list = shelf.list("");
  ASSERT_EQ(list.size(), 2U);
  for (const json& entry : list) {
    EXPECT_NEAR(entry["seconds"].get<double>(), 1, 0.02);
    EXPECT_EQ(entry["start"], "2026-01-31T12:00:00.000Z");
    EXPECT_EQ(entry["audio"], (json{"separated", "raw"}));
    EXPECT_EQ(entry["fault"] == "", entry["name"] == whole);
  }
  EXPECT_EQ(shelf.list(cut).size(), 1U) << "one that is being recorded is left out";
}

TEST(SessionShelf, labels_and_deletes_its_own_and_nothing_else) {
  const test::Scratch scratch;
  const std::string name = make_session(scratch);
  test::write_file(scratch / "foreign.mcap", "nothing of ours");
  SessionShelf shelf(scratch.folder());
  shelf.rename(name, "monday");
  EXPECT_EQ(shelf.list("")[0]["label"], "monday");
  for (const char* bad : {"foreign.mcap",
                          "../"
                          "x.mcap",
                          "", "none.mcap"}) {
    EXPECT_THROW(shelf.remove(bad), RpcError) << bad;
    EXPECT_THROW(shelf.rename(bad, "x"), RpcError) << bad;
  }
  shelf.remove(name);
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.folder()), {}), 1) << "the label went, too";
  EXPECT_TRUE(fs::exists(scratch / "foreign.mcap"));
}

TEST(SessionShelf, never_touches_the_file_of_somebody_else_where_a_label_would_go) {
  const test::Scratch scratch;
  const std::string name = make_session(scratch);
  const fs::path file = (scratch / name).replace_extension(".json");
  test::write_file(file, "mine");
  SessionShelf shelf(scratch.folder());
  EXPECT_THROW(shelf.rename(name, "x"), RpcError);
  shelf.remove(name);
  EXPECT_EQ(test::content(file), "mine");
}

}  // namespace
}  // namespace odas::session_shelf_test
