// SPDX-License-Identifier: MIT
#include "odas/scene/score_text.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

namespace odas {
namespace {

using nlohmann::ordered_json;
using Figure = std::optional<double>;

template <class... Arguments>
std::string print(const char* format, Arguments... arguments) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), format, arguments...);
  return text.data();
}

std::string cell(Figure figure, int decimals) {
  return figure ? print("%10.*f", decimals, *figure) : print("%10s", "-");
}

std::string row(const char* name, Figure a, Figure b, int decimals) {
  return print("  %-44s", name) + cell(a, decimals) + cell(b, decimals) + "\n";
}

Figure percent(Figure share) { return share ? Figure(100 * *share) : share; }

std::string voice_rows(const char* name, const Figure in, const Figure separated, const Figure postfiltered) {
  return print("  %-34s", name) + cell(in, 2) + cell(separated, 2) + cell(postfiltered, 2) + "\n";
}

std::string voice_table(const Score& score) {
  const auto of = [](const std::optional<SeparationScore>& s, auto member) {
    return s ? Figure((*s).*member) : Figure();
  };
  const auto& in = score.separated ? score.separated : score.postfiltered;
  using S = SeparationScore;
  std::string text = print("\nVoices, dB%36s%10s%10s\n", "mic 1", "separated", "filtered");
  text += voice_rows("SDR, signal to distortion", of(in, &S::sdr_in), of(score.separated, &S::sdr),
                     of(score.postfiltered, &S::sdr));
  text += voice_rows("SI-SDR, the same without a filter", of(in, &S::si_sdr_in),
                     of(score.separated, &S::si_sdr), of(score.postfiltered, &S::si_sdr));
  text += voice_rows("SIR, signal to other talkers", of(in, &S::sir_in), of(score.separated, &S::sir),
                     of(score.postfiltered, &S::sir));
  text += voice_rows("STOI, how much is understood, %", percent(of(in, &S::stoi_in)),
                     percent(of(score.separated, &S::stoi)), percent(of(score.postfiltered, &S::stoi)));
  return text;
}

ordered_json rounded(Figure figure) {
  if (!figure) return nullptr;
  return std::round(*figure * 1000) / 1000;
}

void put_places(ordered_json& out, const PlaceScore& place, const std::string& prefix, bool sources) {
  out[prefix + "false_s"] = rounded(place.tracks.false_s_per_min);
  out[prefix + "ospa"] = rounded(place.ospa_deg);
  if (!sources) return;
  out[prefix + "recall"] = rounded(place.tracks.recall);
  out[prefix + "err"] = rounded(place.tracks.error_deg);
  out[prefix + "dup"] = rounded(place.tracks.duplicates);
  out[prefix + "switches"] = rounded(place.tracks.switches_per_min);
  out[prefix + "switches_apart"] = rounded(place.tracks.switches_apart_per_min);
  out[prefix + "onset_s"] = rounded(place.tracks.onset_s);
}

void put_voices(ordered_json& out, const std::optional<SeparationScore>& voices, const std::string& prefix) {
  if (!voices) return;
  out[prefix + "sdr"] = rounded(voices->sdr);
  out[prefix + "sdr_in"] = rounded(voices->sdr_in);
  out[prefix + "si_sdr"] = rounded(voices->si_sdr);
  out[prefix + "si_sdr_in"] = rounded(voices->si_sdr_in);
  out[prefix + "sir"] = rounded(voices->sir);
  out[prefix + "sir_in"] = rounded(voices->sir_in);
  out[prefix + "stoi"] = rounded(voices->stoi);
  out[prefix + "stoi_in"] = rounded(voices->stoi_in);
}

}  // namespace

std::string score_table(const Score& score) {
  const auto& a = score.azimuth;
  const auto& b = score.angle;
  std::string text =
      print("%.1f s, %zu talker%s\n\n", score.seconds, score.sources, score.sources == 1 ? "" : "s");
  text += print("Directions%46s%10s\n", "azimuth", "3-D");
  text += row("strongest potential, median error, deg", a.potentials.median_deg, b.potentials.median_deg, 2);
  text +=
      row("strongest potential, within 15 deg, %", percent(a.potentials.hits), percent(b.potentials.hits), 1);
  text += row("followed while talking (recall), %", percent(a.tracks.recall), percent(b.tracks.recall), 1);
  text += row("error of the tracks, deg", a.tracks.error_deg, b.tracks.error_deg, 2);
  text += row("false tracks, s per minute", a.tracks.false_s_per_min, b.tracks.false_s_per_min, 2);
  text += row("second tracks on a talker, per hop", a.tracks.duplicates, b.tracks.duplicates, 3);
  text +=
      row("changes of id, per minute and talker", a.tracks.switches_per_min, b.tracks.switches_per_min, 2);
  text += row("the same while talkers are 20 deg apart", a.tracks.switches_apart_per_min,
              b.tracks.switches_apart_per_min, 2);
  text += row("first word to first track, s (99: never)", a.tracks.onset_s, b.tracks.onset_s, 2);
  text += row("OSPA (cut off at 30), deg", a.ospa_deg, b.ospa_deg, 2);
  if (score.separated || score.postfiltered) text += voice_table(score);
  return text;
}

std::string score_json(const Score& score) {
  ordered_json out;
  const bool sources = score.sources > 0;
  if (score.angle.potentials.median_deg) {
    out["pot_err"] = rounded(score.angle.potentials.median_deg);
    out["pot_in15"] = rounded(score.angle.potentials.hits);
    out["pot_az_err"] = rounded(score.azimuth.potentials.median_deg);
    out["pot_az_in15"] = rounded(score.azimuth.potentials.hits);
  }
  put_places(out, score.angle, "", sources);
  put_places(out, score.azimuth, "az_", sources);
  put_voices(out, score.separated, "");
  put_voices(out, score.postfiltered, "pf_");
  return out.dump() + "\n";
}

}  // namespace odas
