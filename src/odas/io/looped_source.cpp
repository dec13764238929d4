// SPDX-License-Identifier: MIT
#include "odas/io/looped_source.hpp"

#include <algorithm>

namespace odas {

ReadResult LoopedSource::read(GridView<float> block) {
  ReadResult result;
  Grid<float> part(block.rows(), block.cols());
  bool is_empty = false;  // a recording without a frame would be opened for ever
  bool is_fresh = false;  // opened just now
  while (result.frames < block.cols() && !is_empty) {
    const std::size_t room = block.cols() - result.frames;
    ReadResult read = recording_->read(GridView<float>(part.data(), part.rows(), room, part.cols()));
    for (std::size_t c = 0; c < block.rows(); ++c) {
      std::copy_n(part[c].data(), read.frames, block[c].data() + result.frames);
    }
    result.frames += read.frames;
    result.lost += read.lost;
    result.notice += read.notice;
    if (!read.status.ok()) {
      result.end = true;
      result.status = read.status;
      return result;
    }
    if (!read.end) continue;
    is_empty = is_fresh && read.frames == 0;
    is_fresh = true;
    recording_ = open_();
  }
  result.end = is_empty;
  return result;
}

}  // namespace odas
