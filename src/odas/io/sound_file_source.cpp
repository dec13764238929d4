// SPDX-License-Identifier: MIT
#include "odas/io/sound_file_source.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

#include <sndfile.h>

#include "odas/base/error.hpp"

namespace odas {
namespace {

SNDFILE* sound_of(void* sound) { return static_cast<SNDFILE*>(sound); }

/// How many frames the header of a WAV speaks of, where the file is shorter: libsndfile corrects the number
/// and only notes it in its log, as `data : 64000 (should be 38382)`. Zero: nothing was corrected.
std::uint64_t frames_before_the_cut(SNDFILE* sound, std::uint64_t frames) {
  std::array<char, 4096> log{};
  sf_command(sound, SFC_GET_LOG_INFO, log.data(), static_cast<int>(log.size()));
  const std::string_view text(log.data());
  const std::size_t at = text.find("\ndata : ");
  if (at == std::string_view::npos) return 0;
  unsigned long said = 0;
  unsigned long is = 0;
  const int read = std::sscanf(text.data() + at, "\ndata : %lu (should be %lu)", &said, &is);
  const bool streamed = said >= 0x7FFFFF00UL;  // sizes that recorders write when they do not know the length
  if (read != 2 || streamed || said <= is || is == 0) return 0;
  return static_cast<std::uint64_t>(static_cast<double>(frames) * static_cast<double>(said) /
                                    static_cast<double>(is));
}

}  // namespace

void SoundFileSource::Closer::operator()(void* sound) const noexcept { sf_close(sound_of(sound)); }

SoundFileSource::SoundFileSource(std::filesystem::path file) : file_(std::move(file)) {
  SF_INFO info{};
  sound_.reset(sf_open(file_.c_str(), SFM_READ, &info));
  if (!sound_) throw IoError("cannot read " + file_.string() + ": " + sf_strerror(nullptr));
  channels_ = static_cast<std::size_t>(info.channels);
  sample_rate_ = info.samplerate;
  if (info.frames == 0) throw IoError(file_.string() + " is empty: there is no sound in it");
  if (info.frames < SF_COUNT_MAX) total_ = static_cast<std::uint64_t>(info.frames);
  promised_ = std::max(frames_before_the_cut(sound_of(sound_.get()), total_.value_or(0)), total_.value_or(0));
}

ReadResult SoundFileSource::read(GridView<float> block) {
  ODAS_EXPECT(block.rows() == channels_);
  interleaved_.resize(block.cols() * channels_);  // grows once: blocks are of one size
  const sf_count_t got =
      sf_readf_float(sound_of(sound_.get()), interleaved_.data(), static_cast<sf_count_t>(block.cols()));
  ReadResult result;
  result.frames = static_cast<std::size_t>(std::max<sf_count_t>(got, 0));
  result.end = result.frames < block.cols();
  for (std::size_t c = 0; c < channels_; ++c) {
    const float* from = interleaved_.data() + c;
    for (std::size_t i = 0; i < result.frames; ++i) block[c][i] = from[i * channels_];
  }
  delivered_ += result.frames;
  ended_ = result.end;
  if (ended_ && delivered_ < total_.value_or(0)) {  // a FLAC whose frames are broken or not there
    result.status =
        IoStatus::failed("cannot read on in " + file_.string() + share(*total_) + ": it is cut or damaged");
  }
  return result;
}

std::string SoundFileSource::share(std::uint64_t of) const {
  std::array<char, 64> text{};
  const auto seconds = [&](std::uint64_t frames) { return static_cast<double>(frames) / sample_rate_; };
  std::snprintf(text.data(), text.size(), " after %.1f s of %.1f s", seconds(delivered_), seconds(of));
  return text.data();
}

std::string SoundFileSource::warning() const {
  if (!ended_ || delivered_ >= promised_ || delivered_ < total_.value_or(0)) return {};
  return file_.string() + " ends early," + share(promised_) + " that its header speaks of: it was cut";
}

}  // namespace odas
