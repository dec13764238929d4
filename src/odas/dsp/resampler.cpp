// SPDX-License-Identifier: MIT
#include "odas/dsp/resampler.hpp"

#include <algorithm>
#include <cmath>

#include <samplerate.h>

#include "odas/base/error.hpp"

namespace odas {

namespace {

// Aliases stay under -97 dB, at less than half the cost and the delay of the next better one.
constexpr int kQuality = SRC_SINC_FASTEST;
// Half the length of libsamplerate's filter of that quality, in samples of the lower rate, rounded up.
constexpr std::size_t kHalfLength = 20;

struct SrcDeleter {
  void operator()(SRC_STATE* state) const noexcept { src_delete(state); }
};

}  // namespace

/// libsamplerate and its interleaved buffers.
struct Resampler::Converter {
  std::unique_ptr<SRC_STATE, SrcDeleter> state;
  double ratio = 1;
  std::size_t lookahead = 0;
  std::vector<float> in;         // [frame][channel]
  std::vector<float> out;        // [frame][channel]
  std::uint64_t frames_in = 0;   // taken so far
  std::uint64_t frames_out = 0;  // given so far

  Converter(std::size_t channels, double out_per_in, std::size_t max_block) : ratio(out_per_in) {
    int error = 0;
    state.reset(src_new(kQuality, static_cast<int>(channels), &error));
    if (!state || src_is_valid_ratio(ratio) == 0) {
      throw ConfigError("general.samplerate.mu",
                        std::string("cannot resample by this ratio: ") +
                            (state ? "must be within 1/256 .. 256" : src_strerror(error)));
    }
    lookahead = static_cast<std::size_t>(std::ceil(static_cast<double>(kHalfLength) / std::min(ratio, 1.0)));
    const auto most = static_cast<std::size_t>(
        std::ceil(static_cast<double>(std::max(max_block, std::size_t{64}) + 2 * lookahead) * ratio));
    in.resize(max_block * channels);
    out.resize((most + 16) * channels);
    src_set_ratio(state.get(), ratio);
  }
};

Resampler::Resampler(std::size_t channels, int in_rate, int out_rate, std::size_t max_block, std::size_t hop)
    : max_block_(max_block), hop_(hop) {
  std::size_t most = max_block;
  if (in_rate != out_rate) {
    converter_ = std::make_unique<Converter>(
        channels, static_cast<double>(out_rate) / static_cast<double>(in_rate), max_block);
    most = converter_->out.size() / std::max<std::size_t>(channels, 1);
  }
  held_ = Grid<float>(channels, 2 * (hop + most));
}

Resampler::~Resampler() = default;
Resampler::Resampler(Resampler&&) noexcept = default;
Resampler& Resampler::operator=(Resampler&&) noexcept = default;

std::size_t Resampler::lookahead() const noexcept { return converter_ ? converter_->lookahead : 0; }

void Resampler::push(GridView<const float> block) noexcept {
  ODAS_EXPECT(block.rows() == held_.rows() && block.cols() <= max_block_);
  if (!converter_) {
    append(block);
    return;
  }
  const std::size_t channels = block.rows();
  for (std::size_t c = 0; c < channels; ++c) {
    float* to = converter_->in.data() + c;
    for (const float x : block[c]) {
      *to = x;
      to += channels;
    }
  }
  convert(converter_->in.data(), block.cols(), false);
}

void Resampler::convert(const float* interleaved, std::size_t frames, bool end) noexcept {
  Converter& c = *converter_;
  const std::size_t channels = held_.rows();
  if (channels == 0) return;
  const auto room = static_cast<long>(c.out.size() / channels);
  c.frames_in += frames;
  for (;;) {
    SRC_DATA data{};
    data.data_in = interleaved;
    data.input_frames = static_cast<long>(frames);
    data.data_out = c.out.data();
    data.output_frames = room;
    data.src_ratio = c.ratio;
    data.end_of_input = end ? 1 : 0;
    if (src_process(c.state.get(), &data) != 0) return;  // only for arguments that are never passed here
    auto given = static_cast<std::uint64_t>(data.output_frames_gen);
    if (end) {  // libsamplerate gives a few samples more or less than the input is long
      const auto all = static_cast<std::uint64_t>(std::llround(static_cast<double>(c.frames_in) * c.ratio));
      given = std::min(given, all - std::min(all, c.frames_out));
    }
    c.frames_out += given;
    const auto n = static_cast<std::size_t>(given);
    if (end_ + n > held_.cols()) {  // make room at the front
      for (std::size_t k = 0; k < channels; ++k) {
        std::copy_n(held_[k].data() + begin_, held(), held_[k].data());
      }
      end_ -= begin_;
      begin_ = 0;
    }
    ODAS_EXPECT(end_ + n <= held_.cols());
    for (std::size_t k = 0; k < channels; ++k) {
      const float* from = c.out.data() + k;
      float* to = held_[k].data() + end_;
      for (std::size_t i = 0; i < n; ++i) to[i] = from[i * channels];
    }
    end_ += n;
    interleaved += static_cast<std::size_t>(data.input_frames_used) * channels;
    frames -= static_cast<std::size_t>(data.input_frames_used);
    if (data.output_frames_gen == 0 || (frames == 0 && !end)) return;
  }
}

void Resampler::append(GridView<const float> block) noexcept {
  const std::size_t n = block.cols();
  const bool shift = end_ + n > held_.cols();
  for (std::size_t c = 0; c < held_.rows(); ++c) {
    float* row = held_[c].data();
    if (shift) std::copy_n(row + begin_, held(), row);
    std::copy_n(block[c].data(), n, row + (shift ? held() : end_));
  }
  if (shift) {
    end_ -= begin_;
    begin_ = 0;
  }
  end_ += n;
  ODAS_EXPECT(end_ <= held_.cols());
}

bool Resampler::pop(GridView<float> hop) noexcept {
  ODAS_EXPECT(hop.rows() == held_.rows() && hop.cols() == hop_);
  if (held() < hop_) return false;
  for (std::size_t c = 0; c < held_.rows(); ++c) {
    std::copy_n(held_[c].data() + begin_, hop_, hop[c].data());
  }
  begin_ += hop_;
  if (begin_ == end_) begin_ = end_ = 0;
  return true;
}

void Resampler::finish() noexcept {
  if (converter_) convert(converter_->in.data(), 0, true);
}

std::size_t Resampler::pop_rest(GridView<float> hop) noexcept {
  const std::size_t n = std::min(held(), hop_);
  for (std::size_t c = 0; c < held_.rows(); ++c) {
    std::copy_n(held_[c].data() + begin_, n, hop[c].data());
    std::fill(hop[c].begin() + static_cast<std::ptrdiff_t>(n), hop[c].end(), 0.0F);
  }
  begin_ += n;
  return n;
}

void Resampler::reset() noexcept {
  begin_ = end_ = 0;
  if (!converter_) return;
  src_reset(converter_->state.get());
  converter_->frames_in = converter_->frames_out = 0;
}

}  // namespace odas
