// SPDX-License-Identifier: MIT
// Of Records: what can be downloaded.
#include "support/hop_maker.hpp"
#include "support/kept_messages.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "odas/studio/records.hpp"

namespace odas::records_commands_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Downloads : public testing::Test {
 protected:
  Downloads() {
    records.add_methods(rpc);
    records.begin(hops.info());
    hops.play(records, {1, 2});
    call("record.start", {{"what", "all"}});
    call("record.start", {{"what", "session"}});
    for (int i = 0; i < 50; ++i) hops.play(records, {1, 2});
    call("record.stop", {{"all", true}});
    for (const json& entry : call("recordings.list")) names.push_back(entry["name"]);
    session = call("sessions.list").at(0)["name"];
  }
  json call(const std::string& method, const json& params = json::object()) {
    return rpc.call(method, params, Role::operator_);
  }
  static RecordsOptions options(const fs::path& folder) {
    RecordsOptions made;
    made.folder = folder;
    made.least_free = 0;
    return made;
  }

  test::Scratch scratch;
  test::KeptMessages messages;
  test::HopMaker hops;
  RpcRegistry rpc;
  Records records{options(scratch.folder()), messages};
  std::vector<std::string> names;
  std::string session;
};

TEST_F(Downloads, give_recordings_and_sessions_as_they_lie) {
  ASSERT_EQ(names.size(), 2U);
  const auto wav = records.find("/api/v1/recordings/" + names[0], {});
  ASSERT_TRUE(wav.has_value());
  EXPECT_EQ(wav->file, scratch / names[0]);
  EXPECT_EQ(wav->type, "audio/wav");
  EXPECT_FALSE(wav->remove_file);
  const std::string sidecar = fs::path(names[0]).replace_extension(".json").string();
  EXPECT_EQ(records.find("/api/v1/recordings/" + sidecar, {})->type, "application/json");
  EXPECT_EQ(records.find("/api/v1/sessions/" + session, {})->file, scratch / session);
}

TEST_F(Downloads, give_nothing_else) {
  test::write_file(scratch / "secret.wav", "x");
  for (const char* path :
       {"/api/v1/recordings/secret.wav", "/api/v1/recordings/../secret.wav", "/api/v1/recordings//etc/passwd",
        "/api/v1/recordings/", "/api/v1/sessions/secret.wav", "/api/v1/export/xls", "/api/v1/export/csv",
        "/api/v1/nothing", "/", ""}) {
    EXPECT_FALSE(records.find(path, {}).has_value()) << path;
  }
  EXPECT_FALSE(records.find("/api/v1/export/csv", {{"session", "../" + session}}).has_value());
  EXPECT_FALSE(records.find("/api/v1/recordings.zip", {{"name", "secret.wav"}}).has_value());
}

TEST_F(Downloads, pack_several_recordings_with_what_is_known_of_them) {
  const auto zip = records.find("/api/v1/recordings.zip", {});
  ASSERT_TRUE(zip.has_value());
  EXPECT_TRUE(zip->remove_file);
  EXPECT_EQ(zip->download_name, "recordings.zip");
  EXPECT_EQ(call("recordings.list").size(), 2U);
  const test::ProgramRun run = test::run_program(
      {"/usr/bin/env", "python3", "-c",
       "import sys, zipfile; z = zipfile.ZipFile(sys.argv[1]); print(z.testzip(), len(z.namelist()))",
       zip->file.string()},
      {});
  if (run.exit_code != 127) { EXPECT_EQ(run.out, "None 4\n") << run.err; }
  fs::remove(zip->file);
  const auto one = records.find("/api/v1/recordings.zip", {{"name", names[1]}});
  EXPECT_LT(fs::file_size(one->file), fs::file_size(scratch / names[1]) + 4000);
}

TEST_F(Downloads, export_a_session) {
  const auto rttm = records.find("/api/v1/export/rttm", {{"session", session}});
  ASSERT_TRUE(rttm.has_value());
  EXPECT_TRUE(rttm->remove_file);
  EXPECT_EQ(rttm->download_name, fs::path(session).stem().string() + ".rttm");
  EXPECT_TRUE(test::content(rttm->file)
                  .starts_with("SPEAKER " + fs::path(session).stem().string() + " 1 0.000 0.400 "))
      << test::content(rttm->file);
}

}  // namespace
}  // namespace odas::records_commands_test
