// SPDX-License-Identifier: MIT
// Of Records: the commands and downloads, in the thread of the commands.
#include <algorithm>
#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

#include "odas/base/error.hpp"
#include "odas/studio/records.hpp"
#include "odas/studio/session_export.hpp"
#include "odas/studio/zip.hpp"

namespace odas {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostColumns = 20000;
constexpr std::size_t kLongestLabel = 200;  // bytes
constexpr std::string_view kApi = "/api/v1/";

}  // namespace

void Records::add_methods(RpcRegistry& rpc) {
  const auto op = Role::operator_;
  rpc.add("record.start", op, "records a voice, all voices, the microphones or a session",
          [this](const Json& params) { return start(params); });
  rpc.add("record.stop", op, "ends a recording, or all", [this](const Json& params) { return stop(params); });
  rpc.add("recordings.list", Role::viewer, "the recordings, the newest first",
          [this](const Json&) { return recordings_.list(); });
  rpc.add("recordings.peaks", Role::viewer, "the waveform of a recording", [this](const Json& params) {
    const auto columns = std::clamp<std::size_t>(params.value("columns", std::size_t{600}), 1, kMostColumns);
    return recordings_.peaks(params.at("name").get<std::string>(), columns);
  });
  rpc.add("recordings.rename", op, "gives a recording a label",
          [this](const Json& params) { return rename(params, false); });
  rpc.add("recordings.delete", op, "deletes recordings that a Studio made",
          [this](const Json& params) { return remove(params, false); });
  rpc.add("sessions.list", Role::viewer, "the sessions, the newest first",
          [this](const Json&) { return sessions(); });
  rpc.add("sessions.rename", op, "gives a session a label",
          [this](const Json& params) { return rename(params, true); });
  rpc.add("sessions.delete", op, "deletes sessions that a Studio made",
          [this](const Json& params) { return remove(params, true); });
}

nlohmann::json Records::sessions() {
  std::string unfinished;
  {
    const std::scoped_lock lock(mutex_);
    if (session_) unfinished = session_->name();
  }
  return sessions_.list(unfinished);
}

nlohmann::json Records::rename(const Json& params, bool sessions) {
  const std::string name = params.at("name").get<std::string>();
  const std::string label = params.at("label").get<std::string>();
  if (label.size() > kLongestLabel) {
    throw RpcError("bad_request", fmt::format("a label has at most {} bytes", kLongestLabel));
  }
  Lock lock(mutex_);
  if (sessions) {
    sessions_.rename(name, label);
  } else if (!recorder_.set_label(name, label)) {
    recordings_.rename(name, label);
  }
  tell(lock);
  return Json::object();
}

nlohmann::json Records::remove(const Json& params, bool sessions) {
  const auto names = params.at("names").get<std::vector<std::string>>();
  Lock lock(mutex_);
  Json deleted = Json::array();
  for (const std::string& name : names) {
    if (recorder_.is_open(name) || (session_ && session_->name() == name)) {
      throw RpcError("conflict", name + " is being recorded: stop it first", {{"deleted", deleted}});
    }
    try {
      if (sessions) {
        sessions_.remove(name);
      } else {
        recordings_.remove(name);
      }
    } catch (const RpcError& error) { throw RpcError(error.code(), error.what(), {{"deleted", deleted}}); }
    deleted.push_back(name);
  }
  tell(lock);
  return {{"deleted", deleted}};
}

std::optional<Served> Records::find(std::string_view path, const Query& query) {
  if (!path.starts_with(kApi)) return std::nullopt;
  path.remove_prefix(kApi.size());
  const auto after = [&](std::string_view prefix) -> std::optional<std::string> {
    if (!path.starts_with(prefix)) return std::nullopt;
    return std::string(path.substr(prefix.size()));
  };
  if (path == "recordings.zip") return zip(query);
  if (const auto name = after("recordings/")) {
    const auto file = recordings_.find(*name);
    if (!file) return std::nullopt;
    return Served{*file, false, "", file->extension() == ".wav" ? "audio/wav" : "application/json", *name};
  }
  if (const auto name = after("sessions/")) {
    const auto file = sessions_.find(*name);
    if (!file) return std::nullopt;
    return Served{*file, false, "", "application/octet-stream", *name};
  }
  if (const auto format = after("export/")) return exported(*format, query);
  return std::nullopt;
}

fs::path Records::scratch_file(const std::string& extension) {
  return options_.folder / fmt::format(".odas-{}-{}{}", ::getpid(), scratches_++, extension);
}

std::optional<Served> Records::zip(const Query& query) {
  std::vector<std::string> names;
  const auto [begin, end] = query.equal_range("name");
  for (auto at = begin; at != end; ++at) names.push_back(at->second);
  if (names.empty()) {
    for (const Json& entry : recordings_.list()) names.push_back(entry.at("name").get<std::string>());
  }
  std::vector<fs::path> files;
  std::uint64_t bytes = options_.least_free;
  for (const std::string& name : names) {
    const auto wav = recordings_.find(name);
    if (!wav) return std::nullopt;
    for (const fs::path& file : {*wav, fs::path(*wav).replace_extension(".json")}) {
      files.push_back(file);
      bytes += fs::file_size(file);
    }
  }
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  if (free_space() < bytes) {
    throw RpcError("failed", "there is no room to pack the recordings: fetch them one by one");
  }
  const fs::path scratch = scratch_file(".zip");
  try {
    ZipWriter archive(scratch);
    for (const fs::path& file : files) archive.add(file, file.filename().string());
    archive.close();
  } catch (const IoError&) {
    std::error_code ignored;
    fs::remove(scratch, ignored);
    throw;
  }
  return Served{scratch, true, "", "application/zip", "recordings.zip"};
}

std::optional<Served> Records::exported(const std::string& format_name, const Query& query) {
  const auto format = export_format(format_name);
  const auto name = query.find("session");
  if (!format || name == query.end()) return std::nullopt;
  const auto session = sessions_.find(name->second);
  if (!session) return std::nullopt;
  const fs::path scratch = scratch_file("." + format_name);
  const std::string stem = session->stem().string();
  std::ofstream out(scratch, std::ios::binary);
  export_session(SessionReader(*session), *format, stem, out);
  out.close();
  if (!out) {
    std::error_code ignored;
    fs::remove(scratch, ignored);
    throw IoError("cannot write " + scratch.string() + ": is the disk full?");
  }
  const char* type = *format == ExportFormat::csv     ? "text/csv; charset=utf-8"
                     : *format == ExportFormat::jsonl ? "application/x-ndjson"
                                                      : "text/plain; charset=utf-8";
  return Served{scratch, true, "", type, stem + "." + format_name};
}

}  // namespace odas
