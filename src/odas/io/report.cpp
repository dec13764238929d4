// SPDX-License-Identifier: MIT
#include "odas/io/report.hpp"

#include <cmath>
#include <fstream>

#include <nlohmann/json.hpp>

#include "odas/base/error.hpp"
#include "odas/io/report_assets.hpp"
#include "odas/io/report_audio.hpp"

namespace odas {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr std::size_t kWaveformColumns = 900;

double rounded(double value, double scale) { return std::round(value * scale) / scale; }

std::string escape_html(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

/// JSON that may stand inside <script>: without '<' there is no </script> and no <!--. Bytes that are not
/// UTF-8 (a file may be named so) become replacement characters.
std::string json_for_script(const Json& json) {
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string result;
  for (const char c : text) c == '<' ? result += "\\u003c" : result += c;
  return result;
}

Json angles(const SourceHistory& s, float (*of)(Vec3)) {
  return {
      {"mean", rounded(of(s.mean), 10)}, {"from", rounded(of(s.first), 10)}, {"to", rounded(of(s.last), 10)}};
}

Json to_json(const SourceHistory& s) {
  Json json{{"id", s.id},
            {"tag", s.tag},
            {"from", rounded(s.from_s, 1000)},
            {"to", rounded(s.to_s, 1000)},
            {"share", rounded(s.active_share, 1000)},
            {"places", {{"azimuth", angles(s, azimuth_deg)}, {"elevation", angles(s, elevation_deg)}}}};
  for (const char* key : {"t", "x", "y", "z", "activity"}) json[key] = Json::array();
  for (const TrailPoint& p : s.trail) {
    json["t"].push_back(rounded(p.seconds, 1000));
    json["x"].push_back(rounded(p.direction.x, 1000));
    json["y"].push_back(rounded(p.direction.y, 1000));
    json["z"].push_back(rounded(p.direction.z, 1000));
    json["activity"].push_back(rounded(p.activity, 100));
  }
  return json;
}

void add_clip(Json& json, const ReportClip& clip, const fs::path& folder) {
  const Waveform waveform = waveform_of(folder / clip.file, kWaveformColumns);
  json["file"] = clip.file;
  json["start"] = rounded(clip.start_s, 10000);
  json["length"] = rounded(waveform.seconds, 10000);
  json["peak_db"] = static_cast<int>(std::lround(20 * std::log10(std::max(waveform.peak, 1e-5F))));
  json["peaks"] = Json::array();
  const float scale = waveform.peak > 0 ? 100 / waveform.peak : 0;
  for (const float peak : waveform.peaks) json["peaks"].push_back(std::lround(scale * peak));
}

Json to_json(const ReportData& data, const fs::path& folder) {
  Json json{{"title", data.title}, {"seconds", rounded(data.seconds, 1000)}};
  json["facts"] = data.facts;
  json["warnings"] = data.warnings;
  json["mics"] = Json::array();
  for (const Vec3 m : data.mics) json["mics"].push_back({m.x, m.y, m.z});
  Json& potentials = json["potentials"];
  for (const char* key : {"t", "azimuth", "elevation", "energy"}) potentials[key] = Json::array();
  for (const PotentialPoint& p : data.potentials) {
    potentials["t"].push_back(rounded(p.seconds, 100));
    potentials["azimuth"].push_back(rounded(azimuth_deg(p.direction), 10));
    potentials["elevation"].push_back(rounded(elevation_deg(p.direction), 10));
    potentials["energy"].push_back(rounded(p.energy, 100));
  }
  json["sources"] = Json::array();
  for (const ReportSource& s : data.sources) {
    Json source = to_json(s.history);
    if (s.voice) add_clip(source, *s.voice, folder);
    json["sources"].push_back(std::move(source));
  }
  if (data.reference) {
    Json reference{{"name", "Microphone 1"}};
    add_clip(reference, *data.reference, folder);
    json["reference"] = std::move(reference);
  }
  return json;
}

/// The clips in the order of the page: the sources that have a voice, then the reference.
std::vector<ReportClip> clips_of(const ReportData& data) {
  std::vector<ReportClip> clips;
  for (const ReportSource& s : data.sources) {
    if (s.voice) clips.push_back(*s.voice);
  }
  if (data.reference) clips.push_back(*data.reference);
  return clips;
}

void write_audio(std::ostream& out, const ReportData& data, const fs::path& folder, std::uintmax_t limit) {
  const std::vector<ReportClip> clips = clips_of(data);
  std::uintmax_t bytes = 0;
  for (const ReportClip& clip : clips) bytes += fs::file_size(folder / clip.file);
  if (bytes > limit) return;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    out << R"(<script type="text/plain" id="audio-)" << i << "\">";
    write_base64(out, folder / clips[i].file);
    out << "</script>\n";
  }
}

/// Fills the places {{...}} of the page.
void write_page(std::ostream& out, const ReportData& data, const fs::path& folder, std::uintmax_t limit) {
  for (std::string_view page = kReportHtml; !page.empty();) {
    const std::size_t open = page.find("{{");
    out << page.substr(0, open);
    if (open == std::string_view::npos) break;
    const std::size_t close = page.find("}}", open);
    const std::string_view name = page.substr(open + 2, close - open - 2);
    if (name == "title") out << escape_html(data.title);
    if (name == "style") out << kReportCss;
    if (name == "data") out << json_for_script(to_json(data, folder));
    if (name == "audio") write_audio(out, data, folder, limit);
    if (name == "script") out << kDataJs << kTimelineJs << kSphereJs << kPlayerJs << kPageJs;
    page.remove_prefix(close + 2);
  }
}

}  // namespace

void write_report(const fs::path& file, const ReportData& data, std::uintmax_t max_embedded_audio) {
  fs::path part = file;
  part += ".part";
  std::error_code error;
  try {
    std::ofstream out(part, std::ios::binary | std::ios::trunc);
    write_page(out, data, file.parent_path(), max_embedded_audio);
    out.close();
    if (!out) throw IoError("cannot write " + file.string() + ": is the disk full?");
    fs::rename(part, file, error);
    if (error) throw IoError("cannot write " + file.string() + ": " + error.message());
  } catch (...) {
    fs::remove(part, error);
    throw;
  }
}

}  // namespace odas
