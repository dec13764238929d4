// SPDX-License-Identifier: MIT
#include "odas/studio/session_shelf.hpp"

#include <algorithm>
#include <fstream>

#include "odas/base/error.hpp"
#include "odas/studio/own_file.hpp"
#include "odas/studio/rpc.hpp"
#include "odas/studio/take.hpp"
#include "odas/studio/wire.hpp"

namespace odas {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

bool is_ours(const fs::path& file) {
  try {
    return McapReader(file).profile() == "odas";
  } catch (const IoError&) { return false; }
}

/// Beside the session, and only where it has a label.
json label_file(const fs::path& session) {
  std::ifstream in(fs::path(session).replace_extension(".json"), std::ios::binary);
  json content = json::parse(in, nullptr, false);
  const bool ours = content.is_object() && content.value("made_by", json()) == Take::kMaker &&
                    content.value("file", json()) == session.filename().string();
  return ours ? content : json();
}

}  // namespace

const SessionInfo& SessionShelf::read(const fs::path& file) {
  std::error_code error;
  Known& known = known_[file.filename().string()];
  const std::uintmax_t size = fs::file_size(file, error);
  const auto time = fs::last_write_time(file, error);
  if (known.size != size || known.time != time) {
    known = {size, time, {}};
    try {
      known.info = SessionReader(file).info();
    } catch (const IoError&) { known.info = {}; }  // no MCAP
  }
  return known.info;
}

json SessionShelf::list(const std::string& unfinished) {
  std::vector<json> entries;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_, error)) {
    const fs::path file = entry.path();
    const std::string name = file.filename().string();
    if (file.extension() != ".mcap" || !is_plain_name(name) || !is_file(file) || name == unfinished) continue;
    const SessionInfo& info = read(file);
    if (!info.ours) continue;
    const json label = label_file(file);
    const std::chrono::nanoseconds since(info.start_ns);
    entries.push_back(
        {{"name", name},
         {"seconds", info.seconds},
         {"bytes", known_[name].size},
         {"start", iso_time(std::chrono::system_clock::time_point(
                       std::chrono::duration_cast<std::chrono::system_clock::duration>(since)))},
         {"label", label.is_null() ? json("") : label.value("label", json(""))},
         {"audio", info.audio},
         {"fault", info.fault}});
  }
  std::sort(entries.begin(), entries.end(),
            [](const json& a, const json& b) { return a["name"] > b["name"]; });
  return entries;
}

std::optional<fs::path> SessionShelf::find(const std::string& name) const {
  const fs::path file = folder_ / name;
  if (!is_plain_name(name) || file.extension() != ".mcap" || !is_file(file) || !is_ours(file)) {
    return std::nullopt;
  }
  return file;
}

fs::path SessionShelf::must_find(const std::string& name) const {
  const auto found = find(name);
  if (!found) throw RpcError("not_found", "there is no session '" + name + "' that a Studio made");
  return *found;
}

void SessionShelf::rename(const std::string& name, const std::string& label) {
  const fs::path session = must_find(name);
  const fs::path file = fs::path(session).replace_extension(".json");
  if (fs::exists(fs::symlink_status(file)) && label_file(session).is_null()) {
    throw RpcError("conflict", file.string() + " is somebody else's: the label would go there");
  }
  const json content{{"made_by", Take::kMaker}, {"file", name}, {"kind", "session"}, {"label", label}};
  if (IoStatus status =
          write_whole(file, content.dump(-1, ' ', false, json::error_handler_t::replace) + "\n");
      !status.ok()) {
    throw RpcError("failed", status.what());
  }
}

void SessionShelf::remove(const std::string& name) {
  const fs::path session = must_find(name);
  const bool has_label = !label_file(session).is_null();
  std::error_code error;
  fs::remove(session, error);
  if (error) throw RpcError("failed", "cannot delete " + session.string() + ": " + error.message());
  if (has_label) fs::remove(fs::path(session).replace_extension(".json"), error);
  known_.erase(name);
}

}  // namespace odas
