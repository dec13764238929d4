// SPDX-License-Identifier: MIT
#include "odas/studio/odas_view.hpp"

#include <utility>

#include <nlohmann/json.hpp>

namespace odas {

OdasSender odas_sender(const Configuration& config, std::string name) {
  OdasSender sender;
  sender.name = std::move(name);
  sender.mics = config.pipeline.general.mics;
  OdasIntakeConfig& intake = sender.intake;
  intake.rate = config.pipeline.general.samplerate.mu;
  intake.hop = config.pipeline.general.size.hop_size;
  intake.sound_rate = config.separated.fs;
  intake.channels = static_cast<int>(config.pipeline.sst.slots());
  intake.bits = config.separated.n_bits;
  const auto take_port = [](const InterfaceConfig& from, int& port) {
    if (from.type == "socket" && from.port > 0) port = from.port;
  };
  take_port(config.tracked.interface, intake.tracked);
  take_port(config.potential.interface, intake.potential);
  take_port(config.separated.interface, intake.separated);
  take_port(config.postfiltered.interface, intake.postfiltered);
  return sender;
}

OdasView::OdasView(OdasSender sender, std::vector<HopListener*> listeners, Announcer& to, LogBook& log)
    : sender_(std::move(sender)),
      listeners_(std::move(listeners)),
      to_(to),
      log_(log),
      intake_(sender_.intake, *this,
              [this](const std::string& level, const std::string& text) { log_.say(level, text); }) {
  for (const char* stream : {"tracked", "potential", "separated", "postfiltered"}) {
    where_ += (where_.empty() ? "" : ", ") + std::string(stream) + " to " + intake_.where(stream);
  }
  log_.info("waiting for odaslive, which is to send " + where_);
  tell("waiting", "start odaslive now; it is to send " + where_);
  intake_.start();
}

void OdasView::begin(const StreamInfo& info) {
  StreamInfo known = info;
  known.name = sender_.name;
  known.mics = sender_.mics;
  for (HopListener* listener : listeners_) listener->begin(known);
  tell("running", "what odaslive sends");
}

void OdasView::hop(const HopResult& hop) {
  for (HopListener* listener : listeners_) listener->hop(hop);
}

void OdasView::end() {
  for (HopListener* listener : listeners_) listener->end();
  tell("waiting", "odaslive has gone; it may come again and send " + where_);
}

void OdasView::tell(const char* state, const std::string& what) const {
  to_.announce("", {{"type", "engine"}, {"state", state}, {"what", what}});
}

}  // namespace odas
