// SPDX-License-Identifier: MIT
#include "odas/io/alsa_source.hpp"

#include <algorithm>
#include <cerrno>
#include <thread>

#include "odas/base/error.hpp"
#include "odas/io/alsa_devices.hpp"
#include "odas/io/card_owner.hpp"

namespace odas {
namespace {

using std::chrono::milliseconds;

constexpr auto kFirstPause = milliseconds(100), kLongestPause = milliseconds(3000);
constexpr auto kHangsAfter = std::chrono::seconds(5);  // a card that gives nothing for so long hangs
constexpr auto kSayAgain = std::chrono::seconds(10);   // overruns come in flocks

}  // namespace

AlsaSource::World::World()
    : owner([](const std::string& pcm) { return owner_of_card(pcm); }),
      now([] { return Clock::now(); }),
      sleep([](Clock::duration time) { std::this_thread::sleep_for(time); }) {}

AlsaSource::AlsaSource(std::string pcm, const RawConfig& raw, World world)
    : name_(std::move(pcm)),
      raw_(raw),
      world_(std::move(world)),
      channels_(static_cast<std::size_t>(raw.n_channels)),
      away_(raw.fs) {
  const Refusal refusal = open();
  if (refusal.misfit) throw ConfigError("raw", refusal.why);
  if (!refusal.why.empty()) throw IoError(refusal.why);
}

AlsaSource::Refusal AlsaSource::open() {
  int error = 0;
  std::unique_ptr<AlsaPcm> pcm = world_.open(name_, error);
  if (!pcm) {
    return {"cannot open the sound card " + name_ + ": " + world_.error_text(error) +
            alsa_advice(error, name_, error == -EBUSY ? world_.owner(name_) : "")};
  }
  const CaptureOffer all = pcm->offer(std::nullopt, std::nullopt);
  std::string wrong = misfit(name_, raw_, all);
  // A card may have each of them and yet not all at once.
  const CaptureOffer together = pcm->offer(raw_.n_channels, raw_.fs);
  if (wrong.empty())
    wrong = misfit(name_ + " with " + std::to_string(raw_.n_channels) + " channels", raw_, together);
  if (!wrong.empty()) return {wrong, true};
  format_ = *choose_format(raw_, together);
  error = pcm->configure(format_, raw_.n_channels, raw_.fs, static_cast<std::size_t>(raw_.hop_size));
  if (error >= 0) error = pcm->start();
  if (error < 0) return {"cannot start the sound card " + name_ + ": " + world_.error_text(error)};
  pcm_ = std::move(pcm);
  heard_ = alive_ = world_.now();
  return {};
}

ReadResult AlsaSource::read(GridView<float> block) {
  ReadResult result;
  const Clock::time_point deadline = world_.now() + kReadPatience;
  bytes_.resize(block.cols() * channels_ * bytes_of(format_));  // grows once
  while (result.frames == 0) {
    if (!pcm_) {
      reopen(result);
      if (!pcm_) return result;
    }
    if (overrun_) {
      recover(0, result);
      if (overrun_ || !pcm_) return result;
    }
    const long got = pcm_->read(bytes_.data(), block.cols());
    const Clock::time_point now = world_.now();
    if (got > 0) {
      result.frames = static_cast<std::size_t>(got);
      decode_samples({bytes_.data(), result.frames * channels_ * bytes_of(format_)}, format_,
                     GridView<float>(block.data(), block.rows(), result.frames, block.stride()));
      note_position(now);
      return result;
    }
    int error = static_cast<int>(got);
    if (error == -EINTR) return result;  // a signal: perhaps the program is to stop
    if (error == 0 || error == -EAGAIN) {
      if (now - alive_ > kHangsAfter) {
        give_up("gives no sound any more", result);
        return result;
      }
      const auto left = std::chrono::ceil<milliseconds>(deadline - now);
      if (left.count() <= 0) return result;
      if (error == 0) world_.sleep(milliseconds(1));  // a plug-in that says it is ready, and is not
      error = pcm_->wait(static_cast<int>(left.count()));
      if (error >= 0 || error == -EINTR) {
        if (world_.now() >= deadline) return result;
        continue;
      }
    }
    if (error == -EPIPE || error == -ESTRPIPE) {
      recover(error, result);
    } else {
      give_up(error == -ENODEV ? "was pulled out" : "has failed (" + world_.error_text(error) + ")", result);
      return result;
    }
  }
  return result;
}

void AlsaSource::note_position(Clock::time_point now) {
  const long waiting = std::max(0L, pcm_->available());
  heard_ = now - std::chrono::duration_cast<Clock::duration>(
                     std::chrono::duration<double>(static_cast<double>(waiting) / raw_.fs));
  alive_ = now;
}

/// `error` 0: once more, after a recovery that was not possible yet.
void AlsaSource::recover(int error, ReadResult& result) {
  if (error != 0) {
    overrun_ = true;
    ++overruns_;
    away_.start(heard_);
  }
  const int recovered = pcm_->recover(error == 0 ? -ESTRPIPE : error);
  if (recovered == -EAGAIN) {
    result.lost += away_.take(world_.now());
    world_.sleep(kReadPatience / 2);
    return;
  }
  const int started = recovered < 0 ? recovered : pcm_->start();
  const Clock::time_point now = world_.now();
  overrun_ = false;
  if (started < 0) {
    give_up("has failed (" + world_.error_text(started) + ")", result);
    return;
  }
  const std::uint64_t lost = away_.take(now);
  away_.stop();
  result.lost += lost;
  lost_ += lost;
  heard_ = alive_ = now;
  if (overruns_ == 1 || now - said_ > kSayAgain) {
    said_ = now;
    result.notice += name_ + " has overrun: this machine was too slow for it; " + std::to_string(overruns_) +
                     (overruns_ == 1 ? " time, " : " times, ") + std::to_string(lost_) +
                     " frames lost so far";
  }
}

void AlsaSource::give_up(const std::string& why, ReadResult& result) {
  result.notice += (result.notice.empty() ? "" : "; ") + name_ + " " + why + "; waiting until it is back";
  pcm_.reset();
  overrun_ = false;
  if (!away_.running()) away_.start(heard_);
  pause_ = kFirstPause;
  next_try_ = world_.now() + pause_;
  result.lost += away_.take(world_.now());
}

void AlsaSource::reopen(ReadResult& result) {
  const Clock::time_point now = world_.now();
  if (now < next_try_) {
    world_.sleep(std::min<Clock::duration>(next_try_ - now, kReadPatience));
    result.lost += away_.take(world_.now());
    return;
  }
  const bool back = open().why.empty();  // one that does not fit is another device: ours may yet come
  result.lost += away_.take(world_.now());
  if (back) {
    away_.stop();
    result.notice += name_ + " is back";
    return;
  }
  pause_ = std::min<Clock::duration>(2 * pause_, kLongestPause);
  next_try_ = world_.now() + pause_;
}

}  // namespace odas
