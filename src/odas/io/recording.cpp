// SPDX-License-Identifier: MIT
#include "odas/io/recording.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <string_view>

#include "odas/base/error.hpp"
#include "odas/io/raw_source.hpp"
#include "odas/io/sound_file_source.hpp"

namespace odas {
namespace {

/// Whether the first bytes are those of a format with a header that libsndfile reads.
bool has_header(std::string_view head) {
  const auto holds = [&](std::size_t at, std::string_view text) {
    return head.substr(at, text.size()) == text;
  };
  if (head.size() < 12) return false;
  const bool wave = (holds(0, "RIFF") || holds(0, "RIFX") || holds(0, "RF64")) && holds(8, "WAVE");
  const bool aiff = holds(0, "FORM") && (holds(8, "AIFF") || holds(8, "AIFC"));
  const bool wave64 = holds(0, "riff\x2E\x91\xCF\x11");
  return wave || aiff || wave64 || holds(0, "fLaC") || holds(0, "caff") || holds(0, "OggS") ||
         holds(0, ".snd");
}

std::string extension(const std::filesystem::path& file) {
  std::string text = file.extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

/// Looks only into regular files: what is read from a pipe is gone.
bool is_sound_file(const std::filesystem::path& file) {
  const std::string ending = extension(file);
  if (ending == ".raw" || ending == ".pcm") return false;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return false;
  std::array<char, 12> head{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), head.size());
  return has_header({head.data(), static_cast<std::size_t>(stream.gcount())});
}

/// A .wav that does not begin as one would be read as noise.
void expect_headerless(const std::filesystem::path& file) {
  constexpr std::array<const char*, 6> kWithHeader{".wav", ".flac", ".aiff", ".aif", ".ogg", ".w64"};
  const std::string ending = extension(file);
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file, ignored) && std::filesystem::file_size(file, ignored) > 0 &&
      std::any_of(kWithHeader.begin(), kWithHeader.end(), [&](const char* e) { return ending == e; })) {
    throw IoError(file.string() + " is no sound file, though its name ends in " + ending +
                  "; rename it to .raw if it is headerless");
  }
}

}  // namespace

std::unique_ptr<AudioSource> open_recording(const std::filesystem::path& file, const RawConfig& raw) {
  if (!is_sound_file(file)) {
    expect_headerless(file);
    return std::make_unique<RawSource>(file, raw);
  }
  auto source = std::make_unique<SoundFileSource>(file);
  if (source->sample_rate() != raw.fs) {
    throw IoError(file.string() + " has " + std::to_string(source->sample_rate()) + " Hz, but raw.fS is " +
                  std::to_string(raw.fs) + "; set raw.fS to the rate of the recording");
  }
  if (source->channels() != static_cast<std::size_t>(raw.n_channels)) {
    throw IoError(file.string() + " has " + std::to_string(source->channels()) +
                  " channels, but raw.nChannels is " + std::to_string(raw.n_channels) +
                  "; is it a recording of another array?");
  }
  return source;
}

}  // namespace odas
