// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "odas/engine/sink.hpp"
#include "odas/io/file_descriptor.hpp"

namespace odas {

/// Tells systemd (or whoever set NOTIFY_SOCKET) that the run has begun, and that it lives: READY=1 at the
/// first sign of life, WATCHDOG=1 twice in each WATCHDOG_USEC, STOPPING=1 at the end.
///
/// It is a sink that reads nothing: hops reach it only while capture, engine and output all work, and while a
/// device is waited for its flush is called. So a thread that hangs is noticed, and patience is not.
/// Source: sd_notify(3). Its protocol is stable and made to be spoken without libsystemd, which would bring
/// five libraries along.
class ServiceHeartbeat : public Sink {
 public:
  using Clock = std::chrono::steady_clock;

  /// What the environment asks for; nullptr: nobody does.
  [[nodiscard]] static std::unique_ptr<ServiceHeartbeat> from_environment();
  /// `socket`: a path, or an abstract name that begins with '@'. `watchdog`: zero where there is none.
  ServiceHeartbeat(const std::string& socket, std::chrono::microseconds watchdog);

  [[nodiscard]] std::string name() const override { return "service manager"; }
  [[nodiscard]] Wanted wanted() const noexcept override;
  IoStatus write(const HopResult& hop) override;
  IoStatus flush() override;
  IoStatus close() override;

 private:
  void beat(Clock::time_point now);
  /// A manager that does not listen is no reason to stop.
  void tell(const char* state) const;

  FileDescriptor socket_;
  Clock::duration period_;
  Clock::time_point last_{};
  bool ready_ = false;
};

}  // namespace odas
