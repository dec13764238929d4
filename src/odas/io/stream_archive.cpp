// SPDX-License-Identifier: MIT
#include "odas/io/stream_archive.hpp"

#include <system_error>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "odas/base/error.hpp"
#include "odas/io/hop_encoder.hpp"

namespace odas {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double kLongestRun = 1e9;  // seconds

std::string iso_8601(StreamArchive::Instant now) {
  using namespace std::chrono;
  const auto second = floor<seconds>(now);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(system_clock::to_time_t(second)),
                     duration_cast<milliseconds>(now - second).count());
}

std::string line_of(const json& object) {
  return object.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
}

std::string line_of(HopEncoder& encoder, const StreamRecord& record) {
  const auto bytes = encoder.encode({record.time, record.potentials, record.tracks, {}, {}});
  return {bytes.data(), bytes.size()};
}

/// The class of each slot that has one; ODAS says no ids here, so that those of the tracks are put in.
std::string categories_line(const StreamRecord& record, double seconds, StreamArchive::Instant now) {
  json rows = json::array();
  for (std::size_t slot = 0; slot < record.tracks.size(); ++slot) {
    const Track& track = record.tracks[slot];
    if (track.category == Category::undefined) continue;
    json row{{"slot", slot}, {"class", track.category == Category::speech ? "speech" : "nonspeech"}};
    if (track.id != 0) row["id"] = track.id;
    rows.push_back(std::move(row));
  }
  return line_of({{"timeStamp", record.time}, {"time", seconds}, {"utc", iso_8601(now)}, {"src", rows}});
}

const char* file_of(StreamKind kind) {
  switch (kind) {
    case StreamKind::tracks:
      return "tracks.jsonl";
    case StreamKind::potentials:
      return "potentials.jsonl";
    case StreamKind::categories:
      break;
  }
  return "categories.jsonl";
}

}  // namespace

StreamArchive::StreamArchive(fs::path folder, double hop_seconds)
    : folder_(std::move(folder)), hop_seconds_(hop_seconds) {
  std::error_code fault;
  made_ = fs::create_directories(folder_, fault);
  if (fault || !fs::is_directory(folder_, fault)) {
    throw IoError("cannot make the folder " + folder_.string() + ": " +
                  (fault ? fault.message() : "there is a file of that name"));
  }
  if (!fs::is_empty(folder_, fault)) {
    throw IoError(folder_.string() + " is not empty: name a new folder, for each run has its own");
  }
}

IoStatus StreamArchive::write_line(const std::string& name, std::string_view line) {
  std::unique_ptr<FileWriter>& file = files_[name];
  try {
    if (!file) file = std::make_unique<FileWriter>(folder_ / name);
  } catch (const IoError& error) { return IoStatus::failed(error.what()); }
  return file->write(line);
}

IoStatus StreamArchive::add(const StreamRecord& record, std::string_view text, Instant now) {
  const std::string name = file_of(record.kind);
  if (record.is_line) return write_line(name, std::string(text) + "\n");
  // A stamp that no run reaches tells no time.
  double seconds = (static_cast<double>(record.time) - 1) * hop_seconds_;
  const bool tells_time = seconds >= 0 && seconds < kLongestRun;
  if (!tells_time) seconds = 0;
  if (record.kind == StreamKind::categories) return write_line(name, categories_line(record, seconds, now));
  const std::chrono::duration<double> elapsed(seconds);
  const StreamClock clock{tells_time ? hop_seconds_ : 0,
                          now - std::chrono::duration_cast<Instant::duration>(elapsed)};
  const auto encoder =
      record.kind == StreamKind::tracks ? make_json_lines_tracks(clock) : make_json_lines_potentials(clock);
  return write_line(name, line_of(*encoder, record));
}

IoStatus StreamArchive::note(const Event& event, Instant now) {
  json line{{"utc", iso_8601(now)}, {"stream", event.stream}, {"event", event.what}, {"from", event.from}};
  if (!event.file.empty()) line["file"] = event.file;
  if (event.bytes != 0) line["bytes"] = event.bytes;
  return write_line("connections.jsonl", line_of(line));
}

std::unique_ptr<WavWriter> StreamArchive::open_wav(const std::string& stream,
                                                   const WavWriter::Format& format) {
  const int number = ++recordings_[stream];
  const std::string name = number == 1 ? stream + ".wav" : fmt::format("{}_{}.wav", stream, number);
  return std::make_unique<WavWriter>(folder_ / name, format);
}

IoStatus StreamArchive::flush() {
  for (const auto& [name, file] : files_) {
    if (!file) continue;
    if (IoStatus status = file->flush(); !status.ok()) return status;
  }
  return {};
}

IoStatus StreamArchive::close() {
  IoStatus all;
  for (const auto& [name, file] : files_) {
    if (!file) continue;
    IoStatus status = file->close();
    if (all.ok()) all = std::move(status);
  }
  files_.clear();
  return all;
}

StreamArchive::~StreamArchive() {
  std::error_code stays;  // what is not empty
  if (made_) fs::remove(folder_, stays);
}

}  // namespace odas
