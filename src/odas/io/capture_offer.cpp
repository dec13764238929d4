// SPDX-License-Identifier: MIT
#include "odas/io/capture_offer.hpp"

#include <algorithm>
#include <cstdlib>
#include <span>
#include <string_view>

namespace odas {
namespace {

template <class Items, class Text>
std::string listed(const Items& items, Text text) {
  std::string all;
  for (const auto& item : items) {
    if (!all.empty()) all += ", ";
    all += text(item);
  }
  return all;
}

std::string span_text(int min, int max) {
  return min == max ? std::to_string(min) : std::to_string(min) + " to " + std::to_string(max);
}

bool contains(std::span<const int> all, int value) {
  return std::find(all.begin(), all.end(), value) != all.end();
}

/// The least that is enough, or else the most.
int nearest_channels(const CaptureOffer& offer, int wanted) {
  for (const int n : offer.channels) {
    if (n >= wanted) return n;
  }
  return std::clamp(wanted, offer.min_channels, offer.max_channels);
}

int nearest_rate(const CaptureOffer& offer, int wanted) {
  if (offer.has_rate(wanted)) return wanted;
  int best = std::clamp(wanted, offer.min_rate, offer.max_rate);
  for (const int rate : offer.rates) {
    if (offer.rates.front() == rate || std::abs(rate - wanted) < std::abs(best - wanted)) best = rate;
  }
  return best;
}

/// The value of `raw.format`, or of nBits where that says the same.
std::string format_line(SampleFormat format) {
  const bool plain = format == SampleFormat::s16 || format == SampleFormat::s32;
  return plain ? "nBits = " + std::to_string(bits_of(format)) + ";"
               : "format = \"" + std::string(name_of(format)) + "\";";
}

}  // namespace

bool CaptureOffer::has_channels(int n) const noexcept {
  const bool asked = !channels.empty() && n <= kAskedChannels;
  return n >= min_channels && n <= max_channels && (!asked || contains(channels, n));
}

bool CaptureOffer::has_rate(int hz) const noexcept {
  const bool asked = !rates.empty() && contains(kUsualRates, hz);
  return hz >= min_rate && hz <= max_rate && (!asked || contains(rates, hz));
}

std::string channels_text(const CaptureOffer& offer) {
  const int range = offer.max_channels - offer.min_channels + 1;
  const bool gaps = range <= kAskedChannels && static_cast<int>(offer.channels.size()) < range;
  if (offer.channels.empty() || !gaps) return span_text(offer.min_channels, offer.max_channels);
  return listed(offer.channels, [](int n) { return std::to_string(n); });
}

std::string rates_text(const CaptureOffer& offer) {
  const std::string usual = listed(offer.rates, [](int rate) { return std::to_string(rate); });
  std::string range = span_text(offer.min_rate, offer.max_rate);
  if (usual.empty()) return range;
  return offer.rates.size() == kUsualRates.size() ? range : usual;
}

std::string formats_text(const CaptureOffer& offer) {
  std::string text = listed(offer.formats, [](SampleFormat f) { return std::string(name_of(f)); });
  if (!text.empty()) return text;
  const std::string others = listed(offer.other_formats, [](const std::string& name) { return name; });
  return others.empty() ? "none" : others + " (which odas cannot read)";
}

std::vector<SampleFormat> wanted_formats(const RawConfig& raw) {
  using F = SampleFormat;
  if (raw.format == "auto") return {F::s32, F::s24_3, F::s24, F::f32, F::s16, F::s8, F::u8};
  if (const auto named = sample_format(raw.format)) return {*named};
  if (raw.n_bits == 8) return {F::s8, F::u8};
  if (raw.n_bits == 24) return {F::s24_3, F::s24};
  return {stream_format(raw)};
}

std::optional<SampleFormat> choose_format(const RawConfig& raw, const CaptureOffer& offer) {
  for (const SampleFormat format : wanted_formats(raw)) {
    if (std::find(offer.formats.begin(), offer.formats.end(), format) != offer.formats.end()) return format;
  }
  return std::nullopt;
}

std::string misfit(const std::string& device, const RawConfig& raw, const CaptureOffer& offer) {
  const bool channels = offer.has_channels(raw.n_channels);
  const bool rate = offer.has_rate(raw.fs);
  const bool format = choose_format(raw, offer).has_value();
  if (channels && rate && format) return "";
  std::string wrong, lines;
  const auto add = [&](const std::string& what, const std::string& line) {
    wrong += (wrong.empty() ? "" : "; ") + what;
    lines += (lines.empty() ? "" : " ") + line;
  };
  if (!channels) {
    add("raw.nChannels is " + std::to_string(raw.n_channels) + ", it has " + channels_text(offer),
        "nChannels = " + std::to_string(nearest_channels(offer, raw.n_channels)) + ";");
  }
  if (!rate) {
    add("raw.fS is " + std::to_string(raw.fs) + ", it has " + rates_text(offer) + " Hz",
        "fS = " + std::to_string(nearest_rate(offer, raw.fs)) + ";");
  }
  if (!format) {
    const std::string asked = sample_format(raw.format) ? "raw.format is \"" + raw.format + "\""
                              : raw.format == "auto"    ? std::string("raw.format is \"auto\"")
                                                        : "raw.nBits is " + std::to_string(raw.n_bits);
    add(asked + ", it has " + formats_text(offer),
        offer.formats.empty() ? "" : format_line(offer.formats.front()));
  }
  return device + " offers something else: " + wrong + ". In raw, write: " + lines;
}

std::string propose_raw(const CaptureOffer& offer, const std::string& interface) {
  const SampleFormat best = offer.formats.empty() ? SampleFormat::s16 : offer.formats.front();
  // A plug-in that converts (the way to PulseAudio or PipeWire is one) offers any number, at rates that no
  // card has: what is behind it, nobody can tell.
  constexpr int kMostChannels = 64, kLeastRate = 1000;
  const bool any = offer.max_channels > kMostChannels || offer.min_rate < kLeastRate;
  return "raw: {\n  fS = " + std::to_string(nearest_rate(offer, 16000)) + ";\n  " + format_line(best) +
         "\n  nChannels = " + std::to_string(any ? offer.min_channels : offer.max_channels) +
         (any ? ";  # as many as the microphone behind it has" : ";") + "\n  interface: { " + interface +
         " };\n};\n";
}

}  // namespace odas
