// SPDX-License-Identifier: MIT
#include "odas/config/describe.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

#include "odas/array/geometry.hpp"
#include "odas/config/phrases.hpp"
#include "odas/dsp/resampler.hpp"

namespace odas {

namespace {

std::string fixed(double value, int digits) {
  std::array<char, 64> buffer{};
  const double shown = std::abs(value) < 0.5 * std::pow(10.0, -digits) ? 0 : value;  // no "-0.000"
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), shown, std::chars_format::fixed, digits);
  return {buffer.data(), end.ptr};
}

std::string whole(std::size_t value) { return std::to_string(value); }

/// Rows of cells, written below each other: the first column to the left, numbers to the right.
class Table {
 public:
  void row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

  [[nodiscard]] std::string text() const {
    std::vector<std::size_t> widths;
    for (const auto& cells : rows_) {
      widths.resize(std::max(widths.size(), cells.size()));
      for (std::size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], cells[i].size());
    }
    std::string out;
    for (const auto& cells : rows_) {
      out += "  ";
      for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::string space(widths[i] - cells[i].size(), ' ');
        out += i == 0 ? cells[i] + space : "  " + space + cells[i];
      }
      out += '\n';
    }
    return out;
  }

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// What a line of text says of one thing: "  name          value".
std::string line(const std::string& name, const std::string& value) {
  constexpr std::size_t kColumn = 16;
  return "  " + name + std::string(name.size() < kColumn ? kColumn - name.size() : 1, ' ') + value + '\n';
}

std::string pointing(const std::array<float, 3>& direction) {
  const Vec3 u{direction[0], direction[1], direction[2]};
  if (std::hypot(u.x, u.y) < 1e-6F * norm(u)) return u.z > 0 ? "up" : "down";
  return fixed(azimuth_deg(u), 0) + ", " + fixed(elevation_deg(u), 0);
}

/// Half-angles: all passes up to the first, nothing from the second on.
std::string hearing(const std::array<float, 2>& angle) {
  if (angle[0] >= 180) return "everything";
  return number_text(angle[0]) + (angle[0] == angle[1] ? "" : " to " + number_text(angle[1])) + " deg";
}

std::string channel_of(const Configuration& config, std::size_t mic) {
  const std::vector<int>& map = config.mapping.map;
  if (map.empty()) return whole(mic + 1);
  return mic >= map.size() || map[mic] == 0 ? "none" : std::to_string(map[mic]);
}

std::string describe_array(const Configuration& config, const Pipeline::Plan& plan) {
  const GeneralConfig& general = config.pipeline.general;
  float closest = std::numeric_limits<float>::max();
  for (const Pair& pair : all_pairs(general.mics.size())) {
    const float distance = norm(position(general.mics[pair.i]) - position(general.mics[pair.j]));
    if (distance > 0) closest = std::min(closest, distance);
  }
  const float widest = aperture(general.mics);
  const float c = general.speedofsound.mu;
  const bool flat = flat_array_side(general.mics).has_value();

  std::string text = "Array\n";
  text += line("microphones", whole(general.mics.size()) + (flat ? ", in a plane" : ", with depth"));
  text +=
      line("aperture", fixed(1000.0 * widest, 1) + " mm; closest two " + fixed(1000.0 * closest, 1) + " mm");
  text += line("aliasing", "one pair alone is ambiguous from " + fixed(c / (2 * widest), 0) +
                               " Hz (widest) or " + fixed(c / (2 * closest), 0) + " Hz (closest) on");
  text += line("pairs", whole(plan.pairs_used) + " of " + whole(plan.pairs) + " hear a common direction");
  Table table;
  table.row({"mic", "channel", "x (mm)", "y (mm)", "z (mm)", "points (az, el)", "hears around it"});
  for (std::size_t m = 0; m < general.mics.size(); ++m) {
    const MicConfig& mic = general.mics[m];
    const auto mm = [&](std::size_t axis) { return fixed(1000.0 * mic.mu[axis], 2); };
    table.row({whole(m + 1), channel_of(config, m), mm(0), mm(1), mm(2), pointing(mic.direction),
               hearing(mic.angle)});
  }
  return text + table.text();
}

std::string listened_to(const Configuration& config, const Pipeline::Plan& plan) {
  const auto& filters = config.pipeline.general.spatialfilters;
  if (plan.half_sphere) return "half sphere, for the array is flat";
  if (!filters || filters->empty()) return "full sphere";
  std::string text;
  for (const SpatialFilterConfig& filter : *filters) {
    text += (text.empty() ? "" : " and ") + hearing(filter.angle) + " around (" +
            number_text(filter.direction[0]) + ", " + number_text(filter.direction[1]) + ", " +
            number_text(filter.direction[2]) + ")";
  }
  return text;
}

std::string describe_search(const Configuration& config, const Pipeline::Plan& plan) {
  const SslConfig& ssl = config.pipeline.ssl;
  std::string text = "\nSearch\n";
  text += line("directions", listened_to(config, plan));
  text += line("method", ssl.mode);
  if (ssl.mode == "srp_phat") text += line("weighting", ssl.weighting);
  text += line("potentials", std::to_string(ssl.n_pots) + " in each hop");
  text += line("lags", whole(plan.lags) + " of each cross-correlation, " + std::to_string(ssl.interp_rate) +
                           " to a sample");
  Table table;
  table.row({"level", "directions", "listened to", "step"});
  for (const Pipeline::Plan::Scan& scan : plan.scans) {
    // Each of n directions stands for 4 pi / n of the sphere.
    const double step =
        degrees(std::sqrt(4 * kPi / static_cast<float>(std::max<std::size_t>(1, scan.points))));
    table.row(
        {std::to_string(scan.level), whole(scan.points), whole(scan.active_points), fixed(step, 1) + " deg"});
  }
  return text + table.text();
}

/// The longest that a sample waits for its `block` to be full and then for its `hop` (both in ms): no more
/// than for the longer one where one is a multiple of the other.
double waiting(double block, double hop) {
  const double ratio = std::max(block, hop) / std::min(block, hop);
  return std::abs(ratio - std::round(ratio)) < 1e-6 ? std::max(block, hop) : block + hop;
}

/// What a resampler must see ahead, ms.
double ahead(int in_rate, int out_rate, int block, int hop) {
  if (in_rate == out_rate) return 0;
  const Resampler resampler(1, in_rate, out_rate, static_cast<std::size_t>(block),
                            static_cast<std::size_t>(hop));
  return 1000.0 * static_cast<double>(resampler.lookahead()) / in_rate;
}

/// The delays of the chain, from the microphone on.
std::string describe_latency(const Configuration& config, const Pipeline::Plan& plan) {
  const int hop = config.pipeline.general.size.hop_size;
  const int rate = config.pipeline.general.samplerate.mu;
  const AudioOutputConfig& out = config.separated;
  const double hop_ms = 1000.0 * hop / rate;
  struct Part {
    double ms;
    const char* what;
  };
  const Part full{waiting(1000.0 * config.raw.hop_size / config.raw.fs, hop_ms), "until a block is full"};
  const Part in{ahead(config.raw.fs, rate, config.raw.hop_size, hop), "resampling"};
  const std::array parts{
      full,
      in,
      Part{plan.transform_ms, "in the transforms"},
      Part{plan.lookback_ms, "of look-back"},
      Part{ahead(rate, out.fs, hop, out.hop_size), "resampling the output"},
      Part{std::max(0.0, 1000.0 * out.hop_size / out.fs - hop_ms), "until its block is full"}};
  double sum = 0;
  std::string list;
  for (const Part& part : parts) {
    sum += part.ms;
    if (part.ms > 0) list += (list.empty() ? "" : ", ") + fixed(part.ms, 1) + " ms " + part.what;
  }
  return line("latency", fixed(full.ms + in.ms, 1) + " ms to the tracks, " + fixed(sum, 1) +
                             " ms to the separated voices") +
         line("", list);
}

std::string describe_time(const Configuration& config, const Pipeline::Plan& plan) {
  const SizeConfig& size = config.pipeline.general.size;
  const int rate = config.pipeline.general.samplerate.mu;
  const auto ms = [](int samples, int hz) { return fixed(1000.0 * samples / hz, 1) + " ms"; };
  std::string text = "\nTime\n";
  text += line("microphones", std::to_string(config.raw.fs) + " Hz, " +
                                  (config.raw.format.empty() ? std::to_string(config.raw.n_bits) + " bit, "
                                                             : config.raw.format + ", ") +
                                  std::to_string(config.raw.n_channels) + " channels, blocks of " +
                                  ms(config.raw.hop_size, config.raw.fs));
  if (!config.mapping.reference.empty()) {
    std::string channels;
    for (const int channel : config.mapping.reference) {
      channels += (channels.empty() ? "" : ", ") + std::to_string(channel);
    }
    text += line("own voice", "channel " + channels + "; echoes up to " +
                                  number_text(config.mapping.echo_length) + " ms are taken out");
  }
  if (!config.pipeline.known_noise.empty()) {
    const std::size_t entries = config.pipeline.known_noise.entries.size();
    text += line("known noise",
                 config.pipeline.sss.noise + ", " + whole(entries) + (entries == 1 ? " state" : " states"));
  }
  text += line("processing", std::to_string(rate) + " Hz" + (config.raw.fs == rate ? "" : ", resampled"));
  text += line("hop", std::to_string(size.hop_size) + " samples, " + ms(size.hop_size, rate));
  text += line("frame", std::to_string(size.frame_size) + " samples, " + ms(size.frame_size, rate) +
                            ", bins of " + fixed(static_cast<double>(rate) / size.frame_size, 1) + " Hz");
  text += describe_latency(config, plan);
  text += line("memory", fixed(static_cast<double>(plan.memory_bytes) / (1024 * 1024), 1) + " MiB");
  return text;
}

std::string end_of(const InterfaceConfig& interface) {
  if (interface.type == "file" || interface.type == "voices") return interface.path;
  if (interface.port != 0) {
    return (interface.ip.empty() ? "127.0.0.1" : interface.ip) + ":" + std::to_string(interface.port);
  }
  if (interface.type == "soundcard") {
    return "hw:" + std::to_string(interface.card) + "," + std::to_string(interface.device);
  }
  if (interface.type == "soundcard_name") return interface.devicename;
  if (interface.type == "pulseaudio") return interface.source;
  return "";
}

std::string way_of(const InterfaceConfig& interface, const std::string& form) {
  if (interface.type == "blackhole") return "nobody listens: not computed";
  const std::string end = end_of(interface);
  return interface.type + (end.empty() ? "" : " " + end) + ", " + form;
}

std::string form_of(const AudioOutputConfig& output, const InterfaceConfig& to, std::size_t slots) {
  if (to.type == "voices") return "a WAV for each";
  const bool wav = to.path.ends_with(".wav");
  return whole(slots) + " channels, " + std::to_string(output.fs) + " Hz, " + std::to_string(output.n_bits) +
         " bit" + (to.type == "file" ? (wav ? ", WAV" : ", headerless") : "");
}

/// A line for each place that a stream goes to; `form`: what it has there.
template <class Output, class Form>
std::string lines_of(const std::string& title, const Output& output, Form&& form) {
  std::string text;
  for (const Place& place : places_of("", output)) {
    const InterfaceConfig& to = *place.interface;
    if (to.type == "blackhole" && (!output.interfaces.empty() || !text.empty())) continue;
    text += line(text.empty() ? title : "", way_of(to, form(place)));
  }
  return text.empty() ? line(title, way_of(output.interface, "")) : text;
}

std::string describe_ways(const Configuration& config) {
  const SstConfig& sst = config.pipeline.sst;
  const SssConfig& sss = config.pipeline.sss;
  const InterfaceConfig& source = config.raw.interface;
  std::string text = "\nWays\n";
  text += line("source", source.type == "blackhole" ? "none: give a recording, odas run RECORDING"
                                                    : source.type + " " + end_of(source));
  const auto format = [](const Place& place) { return place.format; };
  const auto audio = [&](const AudioOutputConfig& output, const std::string& mode) {
    return [&output, mode, slots = sst.slots()](const Place& place) {
      return mode + ", " + form_of(output, *place.interface, slots);
    };
  };
  text += lines_of("potentials", config.potential, format);
  text += lines_of("tracks", config.tracked, format);
  text += lines_of("separated", config.separated, audio(config.separated, sss.mode_sep));
  text += lines_of("postfiltered", config.postfiltered, audio(config.postfiltered, sss.mode_pf));
  text += lines_of("categories", config.category, format);
  std::string followed =
      sst.add == "dynamic" ? "up to " + whole(sst.slots()) + " sources, " + sst.mode : "targets only";
  for (const TargetConfig& target : sst.target) {
    const Vec3 u{target.x, target.y, target.z};
    followed +=
        "; target \"" + target.tag + "\" at " + fixed(azimuth_deg(u), 0) + ", " + fixed(elevation_deg(u), 0);
  }
  text += line("followed", followed);
  return text;
}

}  // namespace

std::string describe_plan(const Configuration& config, const Pipeline::Plan& plan) {
  return describe_array(config, plan) + describe_search(config, plan) + describe_time(config, plan) +
         describe_ways(config);
}

}  // namespace odas
