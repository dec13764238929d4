// SPDX-License-Identifier: MIT
#include "odas/io/alsa_pcm.hpp"

#include <algorithm>
#include <array>
#include <cerrno>

#include <alsa/asoundlib.h>

namespace odas {
namespace {

struct FormatRow {
  SampleFormat ours;
  snd_pcm_format_t theirs;
};
constexpr std::array<FormatRow, kSampleFormats> kFormats{{
    {SampleFormat::s32, SND_PCM_FORMAT_S32_LE},
    {SampleFormat::s24_3, SND_PCM_FORMAT_S24_3LE},
    {SampleFormat::s24, SND_PCM_FORMAT_S24_LE},
    {SampleFormat::f32, SND_PCM_FORMAT_FLOAT_LE},
    {SampleFormat::s16, SND_PCM_FORMAT_S16_LE},
    {SampleFormat::s8, SND_PCM_FORMAT_S8},
    {SampleFormat::u8, SND_PCM_FORMAT_U8},
}};

snd_pcm_format_t alsa_format(SampleFormat format) {
  return std::find_if(kFormats.begin(), kFormats.end(), [&](const FormatRow& r) { return r.ours == format; })
      ->theirs;
}

/// A space of parameters of a device, from which choices take something away.
class Params {
 public:
  explicit Params(snd_pcm_t* pcm) : pcm_(pcm) {
    snd_pcm_hw_params_malloc(&params_);
    if (snd_pcm_hw_params_any(pcm_, params_) < 0) return;
    // The card's own rates: what ALSA would resample to is not what the microphones heard.
    snd_pcm_hw_params_set_rate_resample(pcm_, params_, 0);
    good_ = snd_pcm_hw_params_set_access(pcm_, params_, SND_PCM_ACCESS_RW_INTERLEAVED) >= 0;
  }
  ~Params() { snd_pcm_hw_params_free(params_); }
  Params(const Params&) = delete;
  Params& operator=(const Params&) = delete;

  [[nodiscard]] bool good() const noexcept { return good_; }
  [[nodiscard]] snd_pcm_hw_params_t* get() const noexcept { return params_; }

 private:
  snd_pcm_t* pcm_;
  snd_pcm_hw_params_t* params_ = nullptr;
  bool good_ = false;
};

class LibraryPcm : public AlsaPcm {
 public:
  explicit LibraryPcm(snd_pcm_t* pcm) : pcm_(pcm) {}
  ~LibraryPcm() override { snd_pcm_close(pcm_); }
  LibraryPcm(const LibraryPcm&) = delete;
  LibraryPcm& operator=(const LibraryPcm&) = delete;

  CaptureOffer offer(std::optional<int> channels, std::optional<int> rate) override {
    CaptureOffer offer;
    const Params params(pcm_);
    if (!params.good()) return offer;
    snd_pcm_hw_params_t* p = params.get();
    if (channels) snd_pcm_hw_params_set_channels(pcm_, p, static_cast<unsigned>(*channels));
    if (rate) snd_pcm_hw_params_set_rate(pcm_, p, static_cast<unsigned>(*rate), 0);
    unsigned least = 0;
    unsigned most = 0;
    const auto limited = [](unsigned n) { return static_cast<int>(std::min(n, 1000000U)); };
    if (snd_pcm_hw_params_get_channels_min(p, &least) >= 0 &&
        snd_pcm_hw_params_get_channels_max(p, &most) >= 0) {
      offer.min_channels = limited(least);
      offer.max_channels = limited(most);
    }
    for (int n = std::max(1, offer.min_channels); n <= std::min(offer.max_channels, kAskedChannels); ++n) {
      if (snd_pcm_hw_params_test_channels(pcm_, p, static_cast<unsigned>(n)) == 0)
        offer.channels.push_back(n);
    }
    int direction = 0;
    if (snd_pcm_hw_params_get_rate_min(p, &least, &direction) >= 0 &&
        snd_pcm_hw_params_get_rate_max(p, &most, &direction) >= 0) {
      offer.min_rate = limited(least);
      offer.max_rate = limited(most);
    }
    for (const int usual : kUsualRates) {
      if (snd_pcm_hw_params_test_rate(pcm_, p, static_cast<unsigned>(usual), 0) == 0)
        offer.rates.push_back(usual);
    }
    for (int f = 0; f <= SND_PCM_FORMAT_LAST; ++f) {
      const auto format = static_cast<snd_pcm_format_t>(f);
      if (snd_pcm_hw_params_test_format(pcm_, p, format) != 0) continue;
      const auto* row = std::find_if(kFormats.begin(), kFormats.end(),
                                     [&](const FormatRow& r) { return r.theirs == format; });
      if (row != kFormats.end()) {
        offer.formats.push_back(row->ours);
      } else if (const char* name = snd_pcm_format_name(format); name != nullptr) {
        offer.other_formats.emplace_back(name);
      }
    }
    std::sort(offer.formats.begin(), offer.formats.end());
    return offer;
  }

  int configure(SampleFormat format, int channels, int rate, std::size_t block) override {
    const Params params(pcm_);
    snd_pcm_hw_params_t* p = params.get();
    int error = params.good() ? 0 : -EINVAL;
    const auto then = [&](int result) {
      if (error >= 0) error = result;
    };
    then(snd_pcm_hw_params_set_format(pcm_, p, alsa_format(format)));
    then(snd_pcm_hw_params_set_channels(pcm_, p, static_cast<unsigned>(channels)));
    then(snd_pcm_hw_params_set_rate(pcm_, p, static_cast<unsigned>(rate), 0));
    if (error < 0) return error;
    // The smallest delay that the block allows, and half a second for a scheduler that looks away.
    snd_pcm_uframes_t period = block;
    auto buffer = std::max<snd_pcm_uframes_t>(static_cast<snd_pcm_uframes_t>(rate) / 2, 8 * block);
    snd_pcm_hw_params_set_period_size_near(pcm_, p, &period, nullptr);
    snd_pcm_hw_params_set_buffer_size_near(pcm_, p, &buffer);
    return snd_pcm_hw_params(pcm_, p);
  }

  int start() override { return snd_pcm_start(pcm_); }
  int wait(int milliseconds) override { return snd_pcm_wait(pcm_, milliseconds); }
  long read(char* bytes, std::size_t frames) override { return snd_pcm_readi(pcm_, bytes, frames); }
  long available() override { return snd_pcm_avail_update(pcm_); }

  int recover(int error) override {
    if (error == -ESTRPIPE) {
      const int resumed = snd_pcm_resume(pcm_);
      if (resumed == -EAGAIN) return resumed;  // it is still waking
      if (resumed >= 0) snd_pcm_drop(pcm_);    // what it heard while it woke is not wanted: it starts anew
    }
    return snd_pcm_prepare(pcm_);
  }

 private:
  snd_pcm_t* pcm_;
};

void say_nothing(const char*, int, const char*, int, const char*, ...) {}

}  // namespace

std::unique_ptr<AlsaPcm> open_alsa(const std::string& name, int& error) {
  // The library writes to stderr by itself; what it has to say comes with the error, in our words.
  snd_lib_error_set_handler(say_nothing);
  snd_pcm_t* pcm = nullptr;
  error = snd_pcm_open(&pcm, name.c_str(), SND_PCM_STREAM_CAPTURE, SND_PCM_NONBLOCK);
  if (error < 0) return nullptr;
  return std::make_unique<LibraryPcm>(pcm);
}

std::string alsa_error(int error) { return snd_strerror(error); }

}  // namespace odas
