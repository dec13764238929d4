// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "odas/engine/studio_config.hpp"
#include "odas/studio/document.hpp"
#include "odas/studio/odas_view.hpp"

namespace odas {

struct StudioOptions {
  StudioConfig config;                 // where it listens, tokens, folder
  std::optional<Document> open;        // what runs at once; none: the page chooses
  std::optional<OdasSender> odas;      // in place of a run: an `odaslive` that sends to us
  std::string session;                 // a session file that the page shows at once; "": none
  Outputs outputs = Outputs::network;  // of the configurations that run
  bool loop = false;                   // recordings begin anew when they end
  std::string program = "odas";        // what lines on stderr begin with; "": nothing is said
};

/// The Studio: an engine under its control, and the server of the page that shows it. All of it works in
/// threads of its own until the end of its life, which ends the run well.
class Studio {
 public:
  /// Listens and runs. Throws ConfigError and IoError where that cannot be, as of StudioServer and
  /// EngineHost::open.
  explicit Studio(StudioOptions options);
  ~Studio();
  Studio(const Studio&) = delete;
  Studio& operator=(const Studio&) = delete;

  [[nodiscard]] int port() const;
  /// Where a browser finds it, with the token where one is needed.
  [[nodiscard]] std::string url() const;
  /// The run is over, and will not go on by itself: its exit code, and why it failed. None: it goes on.
  struct End {
    int exit_code = 0;
    std::string fault;
  };
  [[nodiscard]] std::optional<End> end() const;

 private:
  class Body;
  std::unique_ptr<Body> body_;
};

}  // namespace odas
