// SPDX-License-Identifier: MIT
#include "odas/studio/recorder.hpp"

#include <algorithm>

#include "odas/base/error.hpp"
#include "odas/io/pcm.hpp"

namespace odas {
namespace {

constexpr std::array kStreams{AudioStream::separated, AudioStream::postfiltered, AudioStream::raw};
constexpr std::uint64_t kEverybody = 1;  // the "id" of all microphones
constexpr double kLongestGap = 60;       // s: a longer one ends a recording
constexpr std::size_t kRemembered = 64;  // finished files that a late transcript may still find

std::size_t index_of(AudioStream stream) { return static_cast<std::size_t>(stream); }
int bits_of(AudioStream stream) { return stream == AudioStream::raw ? 24 : 16; }

std::string no_such_sound(AudioStream stream) {
  return stream == AudioStream::raw
             ? "the microphones themselves are not at hand in this run"
             : std::string("the voices '") + name_of(stream) + "' are not made in this run";
}

}  // namespace

void Recorder::begin(const StreamInfo& info) {
  // A new pipeline in a run that goes on: those who record all, or the microphones, go on in new files.
  for (Open& open : open_) finish(open);
  open_.clear();
  std::erase_if(jobs_, [](const auto& job) { return job.second.order.what == What::track; });
  info_ = info;
  time_ = 0;
  lanes_ = {};
  heard_ = {};
  finished_.clear();
  for (auto& [id, job] : jobs_) job.begun_s = 0;
}

void Recorder::end() {
  for (Open& open : open_) finish(open);
  open_.clear();
  jobs_.clear();
  info_.reset();
  lanes_ = {};
}

double Recorder::now_s() const noexcept {
  return info_ ? static_cast<double>(time_ * info_->hop_size) / info_->sample_rate : 0;
}

void Recorder::hop(const HopResult& hop) {
  if (!info_ || hop.time <= time_) return;
  time_ = hop.time - 1;  // what is heard now begins here
  for (const AudioStream stream : kStreams) hear(hop, stream);
  time_ = hop.time;
  refuse_jobs_without_sound();
}

/// Those that were started before the first hop told what there is.
void Recorder::refuse_jobs_without_sound() {
  for (const auto& [number, job] : std::map(jobs_)) {
    const AudioStream stream = job.order.what == What::raw ? AudioStream::raw : job.order.stream;
    if (heard_[index_of(stream)] != 0) continue;
    faults_.push_back(no_such_sound(stream) + "; this recording has ended");
    stop(number);
  }
}

template <class Act>
void Recorder::for_takes(AudioStream stream, std::size_t lane, Act act) {
  std::vector<std::uint64_t> failed;
  for (Open& open : open_) {
    if (open.stream != stream || open.lane != lane) continue;
    if (IoStatus status = act(open); !status.ok()) {
      faults_.push_back(status.what() + "; this recording has ended");
      failed.push_back(open.job);
    }
  }
  for (const std::uint64_t job : failed) stop(job);
}

void Recorder::hear(const HopResult& hop, AudioStream stream) {
  const GridView<const float> audio = audio_of(hop, stream);
  const bool raw = stream == AudioStream::raw;
  if (audio.empty()) return;
  const int bits = bits_of(stream);
  const std::size_t channels = raw ? audio.rows() : 1;
  std::vector<Lane>& lanes = lanes_[index_of(stream)];
  const std::size_t count = raw ? 1 : std::min(audio.rows(), hop.tracks.size());
  if (lanes.size() != count) {
    const auto frames = static_cast<std::size_t>(preroll_s_ * info_->sample_rate);
    lanes.assign(count, Lane{0, "", SampleRing(channels * pcm_bytes(bits), frames)});
  }
  HopIndex& heard = heard_[index_of(stream)];
  const std::uint64_t lost_frames = heard == 0 ? 0 : (hop.time - heard - 1) * info_->hop_size;
  heard = hop.time;
  const bool torn = static_cast<double>(lost_frames) > kLongestGap * info_->sample_rate;
  bytes_.resize(channels * audio.cols() * pcm_bytes(bits));
  for (std::size_t i = 0; i < count; ++i) {
    Lane& lane = lanes[i];
    const std::uint64_t id = raw ? kEverybody : hop.tracks[i].id;
    const bool born = lane.id != id || torn;
    if (born) {
      close(stream, i);
      lane.ring.clear();
      if (lane.id != id && lane.id != 0 && !raw) drop_jobs_of(lane.id, stream);
      lane.id = id;
    }
    if (id == 0) continue;
    const GridView<const float> rows(audio[i].data(), channels, audio.cols(), audio.stride());
    encode_pcm(rows, gain_of(*info_, stream), bits, bytes_);
    if (!raw) lane.tag = hop.tracks[i].tag.view();
    if (born) {
      for (const auto& [number, job] : std::map(jobs_)) {
        const bool wanted = raw ? job.order.what == What::raw
                                : job.order.what != What::raw && job.order.stream == stream &&
                                      (job.order.what == What::all || job.order.track == id);
        if (!wanted) continue;
        try {
          open(number, stream, i, 0);
        } catch (const IoError& error) {
          faults_.push_back(std::string(error.what()) + "; this recording has ended");
          stop(number);
        }
      }
    } else if (lost_frames > 0) {
      const std::vector<char> silence(static_cast<std::size_t>(lost_frames) * lane.ring.frame_bytes());
      lane.ring.push(silence);
      for_takes(stream, i,
                [&](Open& to) { return to.take.write_silence(static_cast<std::size_t>(lost_frames)); });
    }
    lane.ring.push(bytes_);
    for_takes(stream, i, [&](Open& to) {
      if (!raw) to.take.steer(now_s(), hop.tracks[i].direction);
      return to.take.write(bytes_);
    });
  }
}

void Recorder::open(std::uint64_t job, AudioStream stream, std::size_t index, double preroll_s) {
  const bool raw = stream == AudioStream::raw;
  const Lane& lane = lanes_[index_of(stream)][index];
  const std::vector<char> before =
      lane.ring.last(static_cast<std::size_t>(preroll_s * info_->sample_rate + 0.5));
  TakeHead head;
  head.stream = stream;
  head.track = raw ? 0 : lane.id;
  head.tag = lane.tag;
  head.start_s = now_s() - static_cast<double>(before.size() / lane.ring.frame_bytes()) / info_->sample_rate -
                 (raw ? 0 : info_->voice_delay_s);
  head.start = info_->start + std::chrono::duration_cast<std::chrono::system_clock::duration>(
                                  std::chrono::duration<double>(head.start_s));
  const int bits = bits_of(stream);
  head.format = {info_->sample_rate, lane.ring.frame_bytes() / pcm_bytes(bits), bits};
  head.config_name = info_->name;
  head.config_hash = info_->config_hash;
  Open opened{job, stream, index, Take(folder_, std::move(head))};
  if (IoStatus status = opened.take.write(before); !status.ok()) throw IoError(status.what());
  jobs_[job].names.push_back(opened.take.name());
  open_.push_back(std::move(opened));
}

void Recorder::finish(Open& open) {
  if (IoStatus status = open.take.close(); !status.ok()) faults_.push_back(status.what());
  finished_.emplace_back(open.take.head().track, open.take.name());
  if (finished_.size() > kRemembered) finished_.pop_front();
}

void Recorder::close(AudioStream stream, std::size_t lane) {
  for (auto open = open_.begin(); open != open_.end();) {
    if (open->stream == stream && open->lane == lane) {
      finish(*open);
      open = open_.erase(open);
    } else {
      ++open;
    }
  }
}

void Recorder::drop_jobs_of(std::uint64_t track, AudioStream stream) {
  std::erase_if(jobs_, [&](const auto& job) {
    const Order& order = job.second.order;
    return order.what == What::track && order.track == track && order.stream == stream;
  });
}

void Recorder::start(std::uint64_t number, const Order& order) {
  if (!info_) throw IoError("nothing is running that could be recorded");
  const bool raw = order.what == What::raw;
  const AudioStream stream = raw ? AudioStream::raw : order.stream;
  const std::vector<Lane>& lanes = lanes_[index_of(stream)];
  if (time_ > 0 && lanes.empty()) { throw IoError(no_such_sound(stream)); }
  std::vector<std::size_t> now;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    if (lanes[i].id != 0 && (order.what != What::track || lanes[i].id == order.track)) now.push_back(i);
  }
  if (order.what == What::track && now.empty()) {
    throw IoError("there is no source " + std::to_string(order.track) + " now");
  }
  jobs_[number] = {order, {}, now_s()};
  try {
    for (const std::size_t lane : now) open(number, stream, lane, order.preroll_s);
  } catch (...) {
    static_cast<void>(stop(number));
    throw;
  }
}

std::optional<std::vector<std::string>> Recorder::stop(std::uint64_t number) {
  const auto job = jobs_.find(number);
  if (job == jobs_.end()) return std::nullopt;
  for (auto open = open_.begin(); open != open_.end();) {
    if (open->job == number) {
      finish(*open);
      open = open_.erase(open);
    } else {
      ++open;
    }
  }
  std::vector<std::string> names = std::move(job->second.names);
  jobs_.erase(job);
  return names;
}

void Recorder::flush() {
  for (const AudioStream stream : kStreams) {
    for (std::size_t lane = 0; lane < lanes_[index_of(stream)].size(); ++lane) {
      for_takes(stream, lane, [](Open& open) { return open.take.flush(); });
    }
  }
}

void Recorder::add(std::uint64_t track, const Transcript& transcript) {
  for (Open& open : open_) {
    if (open.take.head().track == track) open.take.add(transcript);
  }
  for (const auto& [id, name] : finished_) {
    if (id != track) continue;
    const auto file = std::filesystem::path(folder_ / name).replace_extension(".json");
    if (IoStatus status = add_transcript(file, transcript); !status.ok()) faults_.push_back(status.what());
  }
}

bool Recorder::is_open(const std::string& name) const {
  return std::any_of(open_.begin(), open_.end(), [&](const Open& open) { return open.take.name() == name; });
}

bool Recorder::set_label(const std::string& name, const std::string& label) {
  for (Open& open : open_) {
    if (open.take.name() != name) continue;
    if (IoStatus status = open.take.set_label(label); !status.ok()) throw IoError(status.what());
    return true;
  }
  return false;
}

}  // namespace odas
