// SPDX-License-Identifier: MIT
#include "odas/io/voice_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <nlohmann/json.hpp>

#include "odas/base/contract.hpp"
#include "odas/base/error.hpp"
#include "odas/io/pcm.hpp"

namespace odas {

namespace fs = std::filesystem;

std::string voice_file_name(std::uint64_t id) { return "source_" + std::to_string(id) + ".wav"; }

namespace {

constexpr int kVoiceBits = 16;

/// Only names that this program gives: a user may keep other files here.
bool is_voice(const std::string& name) {
  return name.starts_with("source_") && name.ends_with(".wav") && name.size() > 11 &&
         std::all_of(name.begin() + 7, name.end() - 4,
                     [](char c) { return (c >= '0' && c <= '9') || c == '_'; });
}

void remove_old_voices(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (is_voice(name) || name == "index.json") fs::remove(entry.path());
  }
}

}  // namespace

VoiceRecorder::VoiceRecorder(fs::path folder, Format format) : folder_(std::move(folder)), format_(format) {
  try {
    fs::create_directories(folder_);
    if (!format_.file_name) remove_old_voices(folder_);
  } catch (const fs::filesystem_error& error) {
    throw IoError("cannot use " + folder_.string() + " for the voices: " + error.code().message());
  }
}

IoStatus VoiceRecorder::add(HopIndex time, std::span<const Track> tracks, GridView<const float> audio) {
  if (open_.size() < tracks.size()) open_.resize(tracks.size());
  bytes_.resize(audio.cols() * pcm_bytes(kVoiceBits));
  for (std::size_t slot = 0; slot < tracks.size(); ++slot) {
    Open& open = open_[slot];
    const std::uint64_t id = tracks[slot].id;
    if (open.wav && voices_[open.voice].id != id) {
      IoStatus closed = open.wav->close();
      open.wav.reset();
      if (!closed.ok()) return closed;
    }
    if (id == 0) continue;
    if (!open.wav) {
      const double start = static_cast<double>(time - 1) * format_.hop_seconds - format_.delay_s;
      if (IoStatus begun = begin(slot, id, start); !begun.ok()) return begun;
    }
    const GridView<const float> voice(audio[slot].data(), 1, audio.cols());
    clipped_ += encode_pcm(voice, format_.gain, kVoiceBits, bytes_);
    if (IoStatus written = open.wav->write(bytes_); !written.ok()) return written;
    voices_[open.voice].seconds += static_cast<double>(audio.cols()) / format_.sample_rate;
  }
  return {};
}

std::string VoiceRecorder::name_of(std::uint64_t id, double start_s) const {
  if (format_.file_name) return format_.file_name(id, start_s);
  const auto times =
      std::count_if(voices_.begin(), voices_.end(), [&](const Voice& voice) { return voice.id == id; });
  if (times == 0) return voice_file_name(id);
  return "source_" + std::to_string(id) + "_" + std::to_string(times + 1) + ".wav";
}

IoStatus VoiceRecorder::begin(std::size_t slot, std::uint64_t id, double start_s) {
  const std::string name = name_of(id, start_s);
  try {
    open_[slot].wav =
        std::make_unique<WavWriter>(folder_ / name, WavWriter::Format{format_.sample_rate, 1, kVoiceBits});
  } catch (const IoError& error) { return IoStatus::failed(error.what()); }
  open_[slot].voice = voices_.size();
  voices_.push_back({id, name, start_s, 0});
  return {};
}

std::optional<std::size_t> VoiceRecorder::voice_of(std::size_t slot) const noexcept {
  if (slot >= open_.size() || !open_[slot].wav) return std::nullopt;
  return open_[slot].voice;
}

bool VoiceRecorder::is_open(std::size_t voice) const noexcept {
  return std::any_of(open_.begin(), open_.end(),
                     [&](const Open& open) { return open.wav && open.voice == voice; });
}

void VoiceRecorder::forget(std::size_t voice) {
  ODAS_EXPECT(format_.file_name && voice < voices_.size() && !is_open(voice));
  voices_.erase(voices_.begin() + static_cast<std::ptrdiff_t>(voice));
  for (Open& open : open_) {
    if (open.wav && open.voice > voice) --open.voice;
  }
}

IoStatus VoiceRecorder::flush() {
  for (const Open& open : open_) {
    if (!open.wav) continue;
    if (IoStatus status = open.wav->flush(); !status.ok()) return status;
  }
  return {};
}

IoStatus VoiceRecorder::close() {
  IoStatus first;
  for (Open& open : open_) {
    if (!open.wav) continue;
    IoStatus status = open.wav->close();
    if (first.ok()) first = status;
    open.wav.reset();
  }
  return first;
}

void write_voice_index(const fs::path& file, std::span<const Voice> voices,
                       std::span<const SourceHistory> sources) {
  const auto rounded = [](double value) { return std::round(value * 1000) / 1000; };
  nlohmann::ordered_json index = nlohmann::ordered_json::array();
  for (const Voice& voice : voices) {
    const auto source = std::find_if(sources.begin(), sources.end(),
                                     [&](const SourceHistory& s) { return s.id == voice.id; });
    if (source == sources.end()) continue;
    index.push_back({{"id", voice.id},
                     {"tag", source->tag},
                     {"file", voice.file},
                     {"start", rounded(voice.start_s)},
                     {"seconds", rounded(voice.seconds)},
                     {"azimuth", rounded(azimuth_deg(source->mean))},
                     {"elevation", rounded(elevation_deg(source->mean))},
                     {"active", rounded(source->active_share)}});
  }
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out << index.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
  out.close();
  if (!out) throw IoError("cannot write " + file.string() + ": is the disk full?");
}

}  // namespace odas
