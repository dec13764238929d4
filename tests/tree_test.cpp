// SPDX-License-Identifier: MIT
// What holds of every file of the tree: who may include whom, what the core may not touch, and the rules of
// the house.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

namespace odas::test::tree_test {
namespace {

namespace fs = std::filesystem;

/// Paths from the root of the tree, with '/'.
using Files = std::map<std::string, std::string>;

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// What has no words in it: any letters may stand in it by chance.
bool is_binary(const fs::path& file) { return file.extension() == ".flac" || file.extension() == ".png"; }

/// All text files that are the project's own: no builds, no results, nothing of git.
const Files& tree() {
  static const Files files = [] {
    Files found;
    const fs::path root = ODAS_SOURCE_DIR;
    for (auto entry = fs::recursive_directory_iterator(root); entry != fs::recursive_directory_iterator();
         ++entry) {
      const std::string path = fs::relative(entry->path(), root).generic_string();
      const bool foreign = path.starts_with("build") || path == "out" || path == ".git" || path == ".cache";
      // The built page is made of web/src, and its tools are others' work.
      const bool made = path == "web/dist" || path == "web/node_modules" || path == "web/.test";
      if ((foreign && entry.depth() == 0) || made) {
        entry.disable_recursion_pending();
      } else if (entry->is_regular_file() && !is_binary(entry->path())) {
        found[path] = read(entry->path());
      }
    }
    return found;
  }();
  return files;
}

bool is_cpp(const std::string& path) { return path.ends_with(".cpp") || path.ends_with(".hpp"); }
bool is_test(const std::string& path) { return path.ends_with("_test.cpp") || path.ends_with("_bench.cpp"); }

/// The first folder below src/odas; empty elsewhere.
std::string room_of(const std::string& path) {
  static const std::string base = "src/odas/";
  if (!path.starts_with(base)) return "";
  const std::size_t end = path.find('/', base.size());
  return end == std::string::npos ? "" : path.substr(base.size(), end - base.size());
}

std::vector<std::string> includes_of(const std::string& text) {
  static const std::regex include(R"((?:^|\n)[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"])");
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), include), end; match != end; ++match) {
    found.push_back((*match)[1]);
  }
  return found;
}

/// base <- array <- dsp <- {...} <- pipeline <- {config, engine} <- {io, scene} <- studio; a room sees those
/// of lower rank.
const std::map<std::string, int> kRank{
    {"base", 0},       {"array", 1},    {"dsp", 2},    {"localization", 3}, {"tracking", 3},
    {"separation", 3}, {"pipeline", 4}, {"config", 5}, {"engine", 5},       {"classification", 3},
    {"io", 6},         {"scene", 6},    {"studio", 7}};
constexpr int kPipelineRank = 4;

bool may_include(const std::string& room, const std::string& header) {
  const std::string other = room_of("src/" + header);
  if (other == room) return true;
  // The configuration as a plain struct belongs to the engine; its reader may see it.
  if (room == "config" && header == "odas/engine/config.hpp") return true;
  return kRank.contains(other) && kRank.at(other) < kRank.at(room);
}

bool is_core(const std::string& path) {
  const std::string room = room_of(path);
  return !room.empty() && kRank.at(room) <= kPipelineRank && !is_test(path);
}

TEST(Tree, is_read) {
  EXPECT_GT(std::count_if(tree().begin(), tree().end(), [](const auto& file) { return is_cpp(file.first); }),
            100);
  EXPECT_TRUE(tree().contains("src/odas/pipeline/pipeline.cpp"));
}

TEST(Rooms, are_all_known) {
  for (const auto& [path, text] : tree()) {
    const std::string room = room_of(path);
    if (!room.empty()) { EXPECT_TRUE(kRank.contains(room)) << path; }
  }
}

TEST(Arrows, of_right_and_wrong_includes_are_told_apart) {
  EXPECT_TRUE(may_include("dsp", "odas/base/grid.hpp"));
  EXPECT_TRUE(may_include("config", "odas/engine/config.hpp"));
  EXPECT_FALSE(may_include("base", "odas/dsp/window.hpp"));
  EXPECT_FALSE(may_include("tracking", "odas/localization/localizer.hpp"));
  EXPECT_FALSE(may_include("config", "odas/engine/run.hpp"));
  EXPECT_FALSE(may_include("io", "odas/scene/scene.hpp"));
}

TEST(Arrows, a_room_includes_only_rooms_to_its_left) {
  for (const auto& [path, text] : tree()) {
    const std::string room = room_of(path);
    if (room.empty() || !is_cpp(path)) continue;
    for (const std::string& header : includes_of(text)) {
      if (!header.starts_with("odas/")) continue;
      EXPECT_TRUE(may_include(room, header)) << path << " includes " << header;
    }
  }
}

TEST(Arrows, the_core_has_no_thread_file_socket_clock_or_print) {
  const std::regex banned(
      "thread|mutex|shared_mutex|condition_variable|future|semaphore|barrier|latch|stop_token|iostream|"
      "fstream|"
      "ostream|istream|filesystem|chrono|ctime|time.h|unistd.h|fcntl.h|signal.h|csignal|pthread.h|sys/"
      ".*|netinet/.*|"
      "arpa/.*|spdlog/.*");
  for (const auto& [path, text] : tree()) {
    if (!is_core(path) || !is_cpp(path)) continue;
    for (const std::string& header : includes_of(text)) {
      EXPECT_FALSE(std::regex_match(header, banned)) << path << " includes " << header;
    }
    // One exception: the last words of a broken contract.
    if (path == "src/odas/base/contract.cpp") continue;
    EXPECT_FALSE(
        std::regex_search(text, std::regex(R"(\b(f?printf|fputs|puts|fopen|std::c(out|err|log))\b)")))
        << path;
  }
}

TEST(Libraries, stay_in_their_rooms) {
  const std::map<std::string, std::set<std::string>> homes{{"libconfig", {"config"}},
                                                           {"nlohmann/", {"io", "scene", "studio"}},
                                                           {"fftw3", {"dsp"}},
                                                           {"samplerate", {"dsp", "scene"}},
                                                           {"sndfile", {"io", "scene", "studio"}},
                                                           {"curl/", {"studio"}},
                                                           {"CLI/", {}},
                                                           {"hwy/", {"localization", "separation"}},
                                                           {"alsa/", {"io"}},
                                                           {"pulse/", {"io"}}};
  for (const auto& [path, text] : tree()) {
    const std::string room = room_of(path);
    if (room.empty() || !is_cpp(path) || is_test(path)) continue;
    for (const std::string& header : includes_of(text)) {
      for (const auto& [library, rooms] : homes) {
        if (header.starts_with(library)) {
          EXPECT_TRUE(rooms.contains(room)) << path << " includes " << header;
        }
      }
    }
  }
}

// A time of day that is set while a run goes on must change neither what is lost nor when anything is done.
TEST(Clocks, of_engine_and_sources_are_never_set) {
  int files = 0;
  for (const auto& [path, text] : tree()) {
    const bool source = path.starts_with("src/odas/io/") && path.ends_with("_source.cpp");
    if (is_test(path) || !(room_of(path) == "engine" || source || path == "src/odas/io/frame_clock.hpp"))
      continue;
    ++files;
    EXPECT_EQ(text.find("system_clock"), std::string::npos) << path;
    EXPECT_EQ(text.find("gettimeofday"), std::string::npos) << path;
  }
  EXPECT_GT(files, 20);
}

TEST(SourceFiles, say_their_licence_first) {
  for (const auto& [path, text] : tree()) {
    const bool script = path.ends_with(".sh") || path == ".ci/run" || path.ends_with("CMakeLists.txt") ||
                        path.ends_with(".cmake") || path.ends_with(".js") || path.ends_with(".css");
    if (is_cpp(path) || script) { EXPECT_LT(text.find("SPDX-License-Identifier: MIT"), 60U) << path; }
  }
}

TEST(SourceFiles, have_their_test_beside_them) {
  for (const auto& [path, text] : tree()) {
    if (!path.starts_with("src/") || !path.ends_with(".cpp") || is_test(path)) continue;
    // Tables, which are tested where they are read: names and their makers, keys and their ranges.
    if (path.ends_with("/registry.cpp") || path.ends_with("config.cpp")) continue;
    EXPECT_TRUE(tree().contains(path.substr(0, path.size() - 4) + "_test.cpp")) << path;
  }
}

TEST(SourceFiles, are_short) {
  for (const auto& [path, text] : tree()) {
    if (is_cpp(path)) { EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 450) << path; }
  }
}

TEST(Documents, link_to_what_is_there) {
  const std::regex link(R"(\]\(([^)#:]+)(?:#[^)]*)?\))");
  for (const auto& [path, text] : tree()) {
    if (!path.ends_with(".md")) continue;
    for (std::sregex_iterator match(text.begin(), text.end(), link), end; match != end; ++match) {
      const fs::path target = (fs::path(ODAS_SOURCE_DIR) / path).parent_path() / std::string((*match)[1]);
      EXPECT_TRUE(fs::exists(target)) << path << " links to " << (*match)[1];
    }
  }
}

TEST(Files, name_no_place_of_one_machine_and_leave_nothing_to_do) {
  const std::regex place(R"((^|[\s"'(=])/(work|root|home/\w+)/)");
  const std::regex promise(
      "\\b(TO"
      "DO|FIX"
      "ME|XX"
      "X)\\b");
  for (const auto& [path, text] : tree()) {
    EXPECT_FALSE(std::regex_search(text, place)) << path;
    EXPECT_FALSE(std::regex_search(text, promise)) << path;
  }
}

}  // namespace
}  // namespace odas::test::tree_test
