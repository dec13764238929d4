// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "odas/engine/audio_source.hpp"
#include "odas/engine/pipeline_inbox.hpp"
#include "odas/engine/target_inbox.hpp"
#include "odas/studio/document.hpp"
#include "odas/studio/effect.hpp"
#include "odas/studio/hop_listener.hpp"
#include "odas/studio/log_book.hpp"
#include "odas/studio/messages.hpp"
#include "odas/studio/run_figures.hpp"

namespace odas {

/// What the engine does, as the message `engine` says it.
enum class EngineState : std::uint8_t { idle, starting, running, waiting, stopped, failed, ended };
[[nodiscard]] const char* name_of(EngineState state) noexcept;

/// Runs a configuration under the Studio's control, in a thread of its own: opens, starts, stops it and puts
/// another one in its place. Whatever becomes of a run, the host stays: a state says what happened and what
/// to do, and another configuration may be opened.
///
/// Threads: commands (`open` to `revert`, `save`) in one thread at a time; `status`, `targets` and
/// `health` in any. A command returns at once; what comes of it is announced.
class EngineHost {
 public:
  struct Options {
    Outputs outputs = Outputs::network;
    bool loop = false;  // recordings begin anew when they end
    /// In place of make_source, for tests.
    std::function<std::unique_ptr<AudioSource>(const RawConfig&)> open_source{};
  };
  struct Status {
    EngineState state = EngineState::idle;
    std::string what;
    Document document;
    bool has_document = false;
    bool dirty = false;         // it is not what its file says
    bool has_previous = false;  // there is one to revert to
  };

  /// `listeners`, `to` and `log` outlive it.
  EngineHost(Options options, Announcer& to, LogBook& log, std::vector<HopListener*> listeners);
  /// Ends the run well, with all files finished.
  ~EngineHost();
  /// Does that ahead of time; commands that come later are without effect.
  void shut_down();
  EngineHost(const EngineHost&) = delete;
  EngineHost& operator=(const EngineHost&) = delete;

  /// Runs it in place of what runs. Throws ConfigError, and nothing has changed.
  void open(Document document);
  /// Runs what is open from its beginning. Throws ConfigError.
  void start();
  void stop();

  /// What `apply` would do. Throws ConfigError with the text's faults.
  [[nodiscard]] Effect effect_of(const std::string& text) const;
  /// Puts the text in the place of what runs, as gently as can be. Throws ConfigError, and nothing has
  /// changed.
  Effect apply(const std::string& text);
  /// Back to the text before the last `apply`. Throws ConfigError where there is none.
  Effect revert();
  /// Writes what is open to `file`, from which it is from now on. Throws IoError.
  void save(const std::filesystem::path& file);

  [[nodiscard]] Status status() const;
  /// Waits until the run is over, or a time-out. For tests and for the end of the program.
  bool wait_for_end(std::chrono::milliseconds patience);

  /// The fixed and muted directions that hold.
  [[nodiscard]] TargetInbox::Orders targets() const;
  /// Changes them. False: nothing runs.
  bool change_targets(const std::function<void(TargetInbox::Orders&)>& edit);

  [[nodiscard]] nlohmann::json health();

 private:
  struct Job;      // a run that is to come
  struct Current;  // the run that goes on
  using Lock = std::unique_lock<std::mutex>;

  void work();
  [[nodiscard]] std::unique_ptr<AudioSource> open_source(const RawConfig& raw);
  void run(Job& job, std::unique_ptr<AudioSource>& source);
  void run_job(Job& job, std::unique_ptr<AudioSource>& source);
  void order(CheckedDocument checked, bool keep_source);
  [[nodiscard]] bool apply_live(CheckedDocument& checked);
  [[nodiscard]] Effect put_in_place(CheckedDocument checked);
  [[nodiscard]] StreamInfo info_of(const CheckedDocument& checked, bool live,
                                   const std::vector<Vec3>& power_grid) const;
  void set_state(EngineState state, const std::string& what);
  void notice(const std::string& text);
  void arrived();

  const Options options_;
  Announcer& to_;
  LogBook& log_;
  const std::vector<HopListener*> listeners_;
  HealthFigures health_;

  mutable std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  Status status_;
  std::string saved_text_;               // as the file says
  std::optional<std::string> previous_;  // before the last apply
  std::unique_ptr<Job> job_;
  Current* current_ = nullptr;
  std::uint64_t runs_ = 0;
  bool busy_ = false;
  bool quit_ = false;

  std::atomic<bool> stop_{false};  // of the run that goes on
  std::thread thread_;
};

}  // namespace odas
