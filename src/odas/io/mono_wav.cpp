// SPDX-License-Identifier: MIT
#include "odas/io/mono_wav.hpp"

#include <cerrno>
#include <string>
#include <system_error>

#include <sndfile.h>

#include "odas/base/error.hpp"

namespace odas {
namespace {

SNDFILE* sound_of(void* sound) { return static_cast<SNDFILE*>(sound); }

/// libsndfile only says "system error"; errno knows which.
[[noreturn]] void fail(const std::filesystem::path& file, const char* otherwise) {
  const int number = errno;
  throw IoError("cannot write " + file.string() + ": " +
                (number != 0 ? std::generic_category().message(number) : otherwise));
}

}  // namespace

void MonoWav::Closer::operator()(void* sound) const noexcept { sf_close(sound_of(sound)); }

MonoWav::MonoWav(std::filesystem::path file, int sample_rate) : file_(std::move(file)) {
  SF_INFO info{};
  info.samplerate = sample_rate;
  info.channels = 1;
  info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
  errno = 0;
  sound_.reset(sf_open(file_.c_str(), SFM_WRITE, &info));
  if (!sound_) fail(file_, sf_strerror(nullptr));
  sf_command(sound_of(sound_.get()), SFC_SET_CLIPPING, nullptr, SF_TRUE);
}

MonoWav::~MonoWav() = default;
MonoWav::MonoWav(MonoWav&&) noexcept = default;
MonoWav& MonoWav::operator=(MonoWav&&) noexcept = default;

void MonoWav::write(std::span<const float> samples) {
  errno = 0;
  const auto size = static_cast<sf_count_t>(samples.size());
  if (sf_write_float(sound_of(sound_.get()), samples.data(), size) != size) {
    fail(file_, sf_strerror(sound_of(sound_.get())));
  }
}

void MonoWav::close() {
  if (!sound_) return;
  errno = 0;
  if (sf_close(sound_of(sound_.release())) != 0) fail(file_, "it could not be finished");
}

}  // namespace odas
