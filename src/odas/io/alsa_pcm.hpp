// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "odas/io/capture_offer.hpp"

namespace odas {

/// The few calls of ALSA that capture needs, so that a test can play a card that overruns, sleeps or is
/// pulled out. Errors are negative numbers of errno, as ALSA gives them. Nothing waits but `wait`.
class AlsaPcm {
 public:
  virtual ~AlsaPcm() = default;

  /// What is possible with these channels and this rate; of what is absent, or impossible: with any.
  virtual CaptureOffer offer(std::optional<int> channels, std::optional<int> rate) = 0;
  /// Prepares to capture; `block` is the number of frames that will be read at once.
  virtual int configure(SampleFormat format, int channels, int rate, std::size_t block) = 0;
  virtual int start() = 0;
  /// 1: there is something to read, or to be told. 0: not within so many ms.
  virtual int wait(int milliseconds) = 0;
  /// Frames read into `bytes`, or an error: -EAGAIN, -EPIPE (overrun), -ESTRPIPE (the machine slept),
  /// -ENODEV.
  virtual long read(char* bytes, std::size_t frames) = 0;
  /// Frames that wait to be read.
  virtual long available() = 0;
  /// After -EPIPE or -ESTRPIPE: ready to start again. -EAGAIN: not yet.
  virtual int recover(int error) = 0;
};

/// Opens a PCM by its name, or gives the error.
using AlsaOpener = std::function<std::unique_ptr<AlsaPcm>(const std::string& name, int& error)>;

/// "No such file or directory" and the like.
using AlsaErrorText = std::string (*)(int error);

/// Those of the library.
[[nodiscard]] std::unique_ptr<AlsaPcm> open_alsa(const std::string& name, int& error);
[[nodiscard]] std::string alsa_error(int error);

}  // namespace odas
