// SPDX-License-Identifier: MIT
#include "odas/io/paced_source.hpp"

#include <algorithm>
#include <thread>

namespace odas {
PacedSource::PacedSource(std::unique_ptr<AudioSource> recording)
    : PacedSource(std::move(recording), {[] { return Clock::now(); },
                                         [](Clock::duration time) { std::this_thread::sleep_for(time); }}) {}

PacedSource::PacedSource(std::unique_ptr<AudioSource> recording, Time time)
    : recording_(std::move(recording)), time_(std::move(time)) {}

ReadResult PacedSource::read(GridView<float> block) {
  const Clock::time_point now = time_.now();
  if (!start_) start_ = now;
  const double seconds = static_cast<double>(given_ + block.cols()) / sample_rate();
  const Clock::time_point due =
      *start_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  if (due > now) time_.sleep(std::min<Clock::duration>(due - now, kReadPatience));
  if (due > now + kReadPatience) return {};
  ReadResult result = recording_->read(block);
  given_ += result.frames + result.lost;
  return result;
}

}  // namespace odas
