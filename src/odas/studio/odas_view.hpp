// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "odas/engine/config.hpp"
#include "odas/studio/hop_listener.hpp"
#include "odas/studio/log_book.hpp"
#include "odas/studio/messages.hpp"
#include "odas/studio/odas_intake.hpp"

namespace odas {

/// What is known beforehand of the C program `odaslive` whose run is to be shown.
struct OdasSender {
  OdasIntakeConfig intake;
  std::string name = "ODAS";
  std::vector<MicConfig> mics;  // none: unknown
};

/// As its own configuration says: rates, hop, channels, bits, microphones, and the ports that it dials.
[[nodiscard]] OdasSender odas_sender(const Configuration& config, std::string name);

/// Shows a running `odaslive` in place of an engine of our own: its hops go to all listeners, and whether it
/// is there is told as the state of the engine. There is nothing of it that could be changed from here.
class OdasView final : public HopListener {
 public:
  /// Listens at once. `listeners`, `to` and `log` outlive it. Throws as OdasIntake.
  OdasView(OdasSender sender, std::vector<HopListener*> listeners, Announcer& to, LogBook& log);

  void begin(const StreamInfo& info) override;
  void hop(const HopResult& hop) override;
  void end() override;

  [[nodiscard]] const OdasIntake& intake() const noexcept { return intake_; }

 private:
  void tell(const char* state, const std::string& what) const;

  OdasSender sender_;
  std::vector<HopListener*> listeners_;
  Announcer& to_;
  LogBook& log_;
  std::string where_;
  OdasIntake intake_;  // the last: its thread calls us
};

}  // namespace odas
