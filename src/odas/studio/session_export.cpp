// SPDX-License-Identifier: MIT
#include "odas/studio/session_export.hpp"

#include <algorithm>
#include <map>
#include <ostream>

#include <fmt/format.h>

#include "odas/base/vec3.hpp"
#include "odas/studio/wire.hpp"

namespace odas {
namespace {

using nlohmann::json;

/// A voice is talking where it is this active; shorter pauses than kPause are within its talk.
constexpr double kActive = 0.5, kPause = 0.5;  // -, s

std::string utc_of(std::uint64_t ns) {
  const auto since =
      std::chrono::duration_cast<std::chrono::system_clock::duration>(std::chrono::nanoseconds(ns));
  return iso_time(std::chrono::system_clock::time_point(since));
}

/// A row of `tracks` of a hop.
struct Row {
  std::uint64_t slot, id;
  Vec3 direction;
  double activity;
  std::optional<double> level;
  int category;
  std::string tag;

  static std::optional<Row> of(const json& row) {
    if (!row.is_array() || row.size() < 8) return std::nullopt;
    for (const std::size_t i : {0U, 1U, 2U, 3U, 4U, 5U, 7U}) {
      if (!row[i].is_number()) return std::nullopt;
    }
    return Row{row[0],
               row[1],
               {row[2], row[3], row[4]},
               row[5],
               row[6].is_number() ? std::optional<double>(row[6]) : std::nullopt,
               row[7],
               row.size() > 8 && row[8].is_string() ? row[8].get<std::string>() : "dynamic"};
  }
};

const char* class_of(int category) { return category == 2 ? "speech" : category == 1 ? "nonspeech" : ""; }

/// A field of CSV: with quotes where it must.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

void write_csv(std::ostream& out, std::uint64_t hop, double time, const std::string& utc, const Row& row) {
  out << fmt::format("{},{:.3f},{},{},{},{},{:.4f},{:.4f},{:.4f},{:.2f},{:.2f},{:.3f},{},{}\n", hop, time,
                     utc, row.slot, row.id, csv_field(row.tag), row.direction.x, row.direction.y,
                     row.direction.z, azimuth_deg(row.direction), elevation_deg(row.direction), row.activity,
                     row.level ? fmt::format("{:.1f}", *row.level) : "", class_of(row.category));
}

void write_line(std::ostream& out, std::uint64_t hop, double time, const std::string& utc,
                const std::vector<Row>& rows) {
  out << fmt::format(R"({{"timeStamp":{},"time":{:.6f},"utc":"{}","src":[)", hop, time, utc);
  bool first = true;
  for (const Row& row : rows) {
    out << fmt::format(
        R"({}{{"slot":{},"id":{},"tag":{},"x":{:.4f},"y":{:.4f},"z":{:.4f},"azimuth":{:.3f},"elevation":{:.3f},"activity":{:.3f})",
        std::exchange(first, false) ? "" : ",", row.slot, row.id, json(row.tag).dump(), row.direction.x,
        row.direction.y, row.direction.z, azimuth_deg(row.direction), elevation_deg(row.direction),
        row.activity);
    if (row.category > 0) out << R"(,"class":")" << class_of(row.category) << '"';
    out << '}';
  }
  out << "]}\n";
}

/// Who talked when: spans that are written once they are surely over.
class Diarisation {
 public:
  Diarisation(std::ostream& out, std::string name) : out_(out), name_(std::move(name)) {
    // RTTM has no quotes.
    std::replace_if(
        name_.begin(), name_.end(), [](char c) { return static_cast<unsigned char>(c) <= ' '; }, '_');
  }
  void add(double time, double hop_s, const std::string& speaker) {
    Span& span = spans_[speaker];
    if (span.end > 0 && time - span.end > kPause) write(speaker, std::exchange(span, {}));
    if (span.end == 0) span.begin = time;
    span.end = time + hop_s;
  }
  void finish() {
    for (const auto& [speaker, span] : spans_) write(speaker, span);
    spans_.clear();
  }

 private:
  struct Span {
    double begin = 0, end = 0;
  };
  void write(const std::string& speaker, const Span& span) {
    out_ << fmt::format("SPEAKER {} 1 {:.3f} {:.3f} <NA> <NA> {} <NA> <NA>\n", name_, span.begin,
                        span.end - span.begin, speaker);
  }
  std::ostream& out_;
  std::string name_;
  std::map<std::string, Span> spans_;
};

}  // namespace

std::optional<ExportFormat> export_format(std::string_view name) noexcept {
  if (name == "csv") return ExportFormat::csv;
  if (name == "jsonl") return ExportFormat::jsonl;
  if (name == "rttm") return ExportFormat::rttm;
  return std::nullopt;
}

std::string export_session(const SessionReader& session, ExportFormat format, const std::string& name,
                           std::ostream& out) {
  if (format == ExportFormat::csv) {
    out << "timeStamp,time,utc,slot,id,tag,x,y,z,azimuth,elevation,activity,level,class\n";
  }
  Diarisation diarisation(out, name);
  double hop_s = 0;
  int runs = 0;
  std::uint64_t first = 0;
  SessionReader::Visitor visitor;
  visitor.run = [&](const json& run) {
    hop_s = run.value("hop", 0.0) / std::max(1.0, run.value("rate", 1.0));
    ++runs;
  };
  visitor.hop = [&](const json& hop, std::uint64_t time_ns) {
    if (first == 0) first = time_ns;
    const double time = static_cast<double>(time_ns - std::min(first, time_ns)) / 1e9;
    const std::string utc = format == ExportFormat::rttm ? "" : utc_of(time_ns);
    const auto stamp = hop.value("t", std::uint64_t{0});
    std::vector<Row> rows;
    for (const json& track : hop.value("tracks", json::array())) {
      if (auto row = Row::of(track)) rows.push_back(std::move(*row));
    }
    if (format == ExportFormat::jsonl) write_line(out, stamp, time, utc, rows);
    for (const Row& row : rows) {
      if (format == ExportFormat::csv) write_csv(out, stamp, time, utc, row);
      if (format == ExportFormat::rttm && row.activity >= kActive && row.category != 1) {
        // Ids begin anew with each run.
        const std::string speaker = "source_" + std::to_string(row.id);
        diarisation.add(time, hop_s, runs > 1 ? fmt::format("run{}_{}", runs, speaker) : speaker);
      }
    }
  };
  std::string fault = session.read(visitor);
  diarisation.finish();
  return fault;
}

}  // namespace odas
