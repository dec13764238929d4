// SPDX-License-Identifier: MIT
#include "odas/studio/studio.hpp"

#include <atomic>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "odas/studio/config_commands.hpp"
#include "odas/studio/engine_commands.hpp"
#include "odas/studio/engine_host.hpp"
#include "odas/studio/own_file.hpp"
#include "odas/studio/records.hpp"
#include "odas/studio/server.hpp"

namespace odas {

using nlohmann::json;

namespace {

json camera_json(const CameraConfig& camera) {
  if (camera.url.empty()) return nullptr;
  return {{"url", camera.url},
          {"width", camera.width},
          {"height", camera.height},
          {"fx", camera.fx},
          {"fy", camera.fy},
          {"cx", camera.cx},
          {"cy", camera.cy},
          {"position", camera.position},
          {"rotation", camera.rotation}};
}

/// Stands for the server while there is none yet: who speaks to it is made before it.
class ServerRelay final : public Announcer, public HopListener {
 public:
  void set(StudioServer* server) { server_.store(server); }
  void announce(const std::string& topic, const json& message) override {
    if (StudioServer* server = server_) server->announce(topic, message);
  }
  void begin(const StreamInfo& info) override {
    if (StudioServer* server = server_) server->begin(info);
  }
  void change(const StreamInfo& info) override {
    if (StudioServer* server = server_) server->change(info);
  }
  void hop(const HopResult& hop) override {
    if (StudioServer* server = server_) server->hop(hop);
  }
  void end() override {
    if (StudioServer* server = server_) server->end();
  }

 private:
  std::atomic<StudioServer*> server_{nullptr};
};

/// Stands for the records while there are none: the log is made before them, for they have something to say,
/// too.
class AnnouncerRelay final : public Announcer {
 public:
  void set(Announcer* to) { to_.store(to); }
  void announce(const std::string& topic, const json& message) override {
    if (Announcer* to = to_) to->announce(topic, message);
  }

 private:
  std::atomic<Announcer*> to_{nullptr};
};

RecordsOptions records_options(const StudioConfig& config, LogBook& log) {
  RecordsOptions options;
  options.folder = recordings_folder(config.recordings);
  options.preroll_s = static_cast<double>(config.preroll);
  options.events = config.events;
  options.speech = config.speech;
  options.say = [&log](const std::string& level, const std::string& text) { log.say(level, text); };
  return options;
}

}  // namespace

class Studio::Body {
 public:
  explicit Body(StudioOptions options)
      : options_(std::move(options)),
        log_(options_.program, log_relay_),
        records_(records_options(options_.config, log_), relay_),
        host_({options_.outputs, options_.loop, {}}, records_, log_, {&relay_, &records_}) {
    log_relay_.set(&records_);
    // Of another program's run nothing can be changed.
    if (!options_.odas) {
      add_engine_methods(rpc_, host_, records_);
      add_config_methods(rpc_, host_);
    }
    records_.add_methods(rpc_);
    server_.emplace(options_.config, rpc_, std::vector<FileProvider*>{&records_}, hooks());
    relay_.set(&*server_);
    if (options_.odas) {
      odas_.emplace(*options_.odas, std::vector<HopListener*>{&relay_, &records_}, records_, log_);
    } else if (options_.open) {
      host_.open(*options_.open);
    } else {
      records_.announce("", {{"type", "engine"},
                             {"state", "idle"},
                             {"what", "nothing is open: choose a device or a file, and an array"}});
    }
  }
  ~Body() {
    // The run ends while the server is there to tell of it; the server ends before what it asks is gone.
    host_.shut_down();
    odas_.reset();
    relay_.set(nullptr);
    server_.reset();
    log_relay_.set(nullptr);
  }
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  [[nodiscard]] const StudioServer& server() const { return *server_; }
  [[nodiscard]] EngineHost::Status status() const { return host_.status(); }
  [[nodiscard]] std::string url() const { return server_->url(); }

 private:
  ServerHooks hooks() {
    ServerHooks hooks;
    hooks.health = [this] { return host_.health(); };
    hooks.hello = [this] { return hello(); };
    hooks.failure = [this]() -> std::string {
      const EngineHost::Status now = host_.status();
      return now.state == EngineState::failed ? now.what : "";
    };
    hooks.say = [this](const std::string& what) { log_.warning(what); };
    return hooks;
  }

  json hello() {
    json capabilities = {"record", "sessions"};
    if (!options_.odas) capabilities.insert(capabilities.end(), {"config", "engine", "targets", "power"});
    if (!options_.config.speech.command.empty()) capabilities.push_back("transcripts");
    return {{"capabilities", std::move(capabilities)},
            {"recordings", recordings_folder(options_.config.recordings).string()},
            {"open_session", options_.session.empty() ? json() : json(options_.session)},
            {"camera", camera_json(options_.config.camera)},
            {"targets", targets_json(host_.targets())}};
  }

  const StudioOptions options_;
  RpcRegistry rpc_;
  ServerRelay relay_;
  AnnouncerRelay log_relay_;
  LogBook log_;
  Records records_;
  EngineHost host_;
  std::optional<OdasView> odas_;
  std::optional<StudioServer> server_;
};

Studio::Studio(StudioOptions options) : body_(std::make_unique<Body>(std::move(options))) {}
Studio::~Studio() = default;
int Studio::port() const { return body_->server().port(); }
std::string Studio::url() const { return body_->url(); }

std::optional<Studio::End> Studio::end() const {
  const EngineHost::Status now = body_->status();
  if (now.state == EngineState::failed) return End{1, now.what};
  if (now.state == EngineState::ended) return End{0, ""};
  return std::nullopt;
}

}  // namespace odas
