// SPDX-License-Identifier: MIT
#include "odas/scene/sound.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <memory>

#include <fcntl.h>
#include <samplerate.h>
#include <sndfile.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "odas/base/error.hpp"
#include "odas/scene/activity.hpp"
#include "odas/scene/noise.hpp"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX has no header for it

namespace odas {
namespace {

constexpr double kLevel = 0.0316227766;  // -30 dB of full scale: quiet enough for several talkers at once

/// A file that goes when its name does.
class TemporaryFile {
 public:
  TemporaryFile() : name_((std::filesystem::temp_directory_path() / "odas-speech-XXXXXX.wav").string()) {
    const int file = mkstemps(name_.data(), 4);
    if (file < 0) throw IoError("cannot write to " + name_ + ": " + std::strerror(errno));
    close(file);
  }
  ~TemporaryFile() { unlink(name_.c_str()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_;
};

struct Frames {
  SF_INFO info{};
  std::size_t channels = 0;
  std::vector<float> samples;  // interleaved
};

Frames read_frames(const std::filesystem::path& file) {
  Frames frames;
  const std::unique_ptr<SNDFILE, int (*)(SNDFILE*)> sound(sf_open(file.c_str(), SFM_READ, &frames.info),
                                                          sf_close);
  if (!sound) throw IoError("cannot read " + file.string() + ": " + sf_strerror(nullptr));
  frames.channels = static_cast<std::size_t>(frames.info.channels);
  frames.samples.resize(static_cast<std::size_t>(frames.info.frames) * frames.channels);
  const sf_count_t got = sf_readf_float(sound.get(), frames.samples.data(), frames.info.frames);
  frames.samples.resize(static_cast<std::size_t>(std::max<sf_count_t>(0, got)) * frames.channels);
  return frames;
}

std::vector<float> speak(const SoundRecipe& recipe, const std::string& words, int sample_rate) {
  const TemporaryFile file;
  const std::string speed = std::to_string(recipe.words_per_minute);
  const std::string pitch = std::to_string(recipe.pitch);
  std::vector<std::string> arguments{"espeak-ng", "-v", recipe.voice, "-s", speed, "-p",
                                     pitch,       "-w", file.name(),  "--", words};
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  const int error = posix_spawnp(&child, argv[0], nullptr, nullptr, argv.data(), environ);
  if (error != 0) {
    throw IoError(std::string("cannot run espeak-ng, which speaks the words of the scene: ") +
                  std::strerror(error) + "; install the package espeak-ng, or give recorded speech");
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw IoError("espeak-ng failed with voice '" + recipe.voice +
                  "'; 'espeak-ng --voices' lists those there are");
  }
  return read_mono(file.name(), sample_rate);
}

void add(const std::vector<float>& part, double start, int sample_rate, std::vector<float>& sound) {
  const auto first = static_cast<std::size_t>(start * sample_rate);
  for (std::size_t n = 0; n < part.size() && first + n < sound.size(); ++n) sound[first + n] += part[n];
}

void set_level(std::vector<float>& sound, float gain_db, int sample_rate) {
  const auto step = static_cast<std::size_t>(sample_rate) / 100;
  const auto active = activity_of(sound, step, sample_rate);
  double power = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < active.size(); ++i) {
    if (active[i] == 0) continue;
    for (std::size_t n = i * step; n < (i + 1) * step; ++n) power += static_cast<double>(sound[n]) * sound[n];
    count += step;
  }
  if (power <= 0) return;
  const double wanted = kLevel * std::pow(10.0, static_cast<double>(gain_db) / 20);
  const auto gain = static_cast<float>(wanted / std::sqrt(power / static_cast<double>(count)));
  for (float& x : sound) x *= gain;
}

}  // namespace

std::vector<float> read_mono(const std::filesystem::path& file, int sample_rate) {
  const Frames read = read_frames(file);
  const std::vector<float>& frames = read.samples;
  const std::size_t channels = read.channels;
  const SF_INFO& info = read.info;
  std::vector<float> mono(frames.size() / channels);
  for (std::size_t n = 0; n < mono.size(); ++n) mono[n] = frames[n * channels];
  if (info.samplerate == sample_rate || mono.empty()) return mono;
  const double ratio = static_cast<double>(sample_rate) / info.samplerate;
  std::vector<float> resampled(static_cast<std::size_t>(static_cast<double>(mono.size()) * ratio) + 1);
  SRC_DATA data{};
  data.data_in = mono.data();
  data.data_out = resampled.data();
  data.input_frames = static_cast<long>(mono.size());
  data.output_frames = static_cast<long>(resampled.size());
  data.src_ratio = ratio;
  const int error = src_simple(&data, SRC_SINC_BEST_QUALITY, 1);
  if (error != 0) throw IoError("cannot resample " + file.string() + ": " + src_strerror(error));
  resampled.resize(static_cast<std::size_t>(data.output_frames_gen));
  return resampled;
}

Grid<float> read_channels(const std::filesystem::path& file) {
  const Frames read = read_frames(file);
  Grid<float> sound(read.channels, read.samples.size() / read.channels);
  for (std::size_t c = 0; c < sound.rows(); ++c) {
    for (std::size_t n = 0; n < sound.cols(); ++n) sound[c][n] = read.samples[n * read.channels + c];
  }
  return sound;
}

std::vector<float> make_sound(const SoundRecipe& recipe, int sample_rate, std::size_t samples,
                              std::uint32_t seed) {
  std::vector<float> sound(samples);
  switch (recipe.kind) {
    case SoundRecipe::Kind::file:
      add(read_mono(recipe.file, sample_rate), recipe.start, sample_rate, sound);
      break;
    case SoundRecipe::Kind::speech:
      for (const Utterance& utterance : recipe.utterances) {
        add(speak(recipe, utterance.text, sample_rate), recipe.start + utterance.start, sample_rate, sound);
      }
      break;
    case SoundRecipe::Kind::noise:
      add(point_noise(recipe.colour, samples, sample_rate, seed), recipe.start, sample_rate, sound);
      break;
  }
  set_level(sound, recipe.gain_db, sample_rate);
  return sound;
}

}  // namespace odas
