// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "odas/engine/studio_config.hpp"
#include "odas/studio/event_teller.hpp"
#include "odas/studio/hop_listener.hpp"
#include "odas/studio/messages.hpp"
#include "odas/studio/recorder.hpp"
#include "odas/studio/recording_shelf.hpp"
#include "odas/studio/rpc.hpp"
#include "odas/studio/served.hpp"
#include "odas/studio/session_recorder.hpp"
#include "odas/studio/session_shelf.hpp"
#include "odas/studio/speech.hpp"
#include "odas/studio/webhook.hpp"

namespace odas {

struct RecordsOptions {
  std::filesystem::path folder;  // made when it is first needed
  double preroll_s = 1;
  EventsConfig events{};
  SpeechConfig speech{};
  std::uint64_t least_free = 100'000'000;  // bytes: recording stops before the disk is full
  /// Bytes that are free where the folder is; empty: the file system is asked.
  std::function<std::uint64_t(const std::filesystem::path&)> free_space{};
  /// Told of what goes wrong: `level` as in the log. May be called in any thread.
  std::function<void(const std::string& level, const std::string& text)> say{};
};

/// All that a Studio keeps and tells others: recordings of voices and microphones, sessions, the commands and
/// downloads for them; events; and what is said, by the speech program. Whatever the disk does, the run goes
/// on: what goes wrong is said, and told with the message `recordings`.
///
/// Also an Announcer before the other one: what is announced through it (log, events, transcripts) goes into
/// the session that is being recorded, too.
class Records : public HopListener, public FileProvider, public Announcer {
 public:
  /// Throws ConfigError: `events.url`.
  Records(RecordsOptions options, Announcer& to);
  ~Records() override;
  Records(const Records&) = delete;
  Records& operator=(const Records&) = delete;

  void add_methods(RpcRegistry& rpc);

  void begin(const StreamInfo& info) override;
  void hop(const HopResult& hop) override;
  void end() override;
  std::optional<Served> find(std::string_view path, const Query& query) override;
  void announce(const std::string& topic, const nlohmann::json& message) override;

 private:
  using Json = nlohmann::json;
  using Lock = std::unique_lock<std::mutex>;

  Json start(const Json& params);
  std::uint64_t start_session(const Json& params);
  std::uint64_t start_takes(const Json& params);
  Json stop(const Json& params);
  std::optional<std::string> stop_one(std::uint64_t id, std::vector<std::string>& names);
  Json remove(const Json& params, bool sessions);
  Json rename(const Json& params, bool sessions);
  Json sessions();
  std::optional<Served> zip(const Query& query);
  std::optional<Served> exported(const std::string& format, const Query& query);

  Speech::Options speech_options();
  void heard(const SpokenText& said);
  void stop_all();
  void each_second();
  void session_failed(const IoStatus& status);
  void drain_messages();
  [[nodiscard]] std::uint64_t free_space() const;
  [[nodiscard]] Json state() const;
  /// Says what has gone wrong and tells who records what; without the lock.
  void tell(Lock& lock);
  [[nodiscard]] std::filesystem::path scratch_file(const std::string& extension);

  RecordsOptions options_;
  Announcer& to_;
  RecordingShelf recordings_;  // of the thread of the commands
  SessionShelf sessions_;      // likewise
  std::atomic<int> scratches_{0};

  std::mutex mutex_;  // of all below
  Recorder recorder_;
  std::unique_ptr<SessionRecorder> session_;
  std::uint64_t session_id_ = 0, next_id_ = 1;
  std::optional<StreamInfo> info_;
  HopIndex last_ = 0;
  std::chrono::steady_clock::time_point flushed_{}, told_{};
  std::vector<std::string> faults_;
  std::uint64_t states_ = 0;  // that were taken down so far

  std::mutex telling_mutex_;
  std::uint64_t told_state_ = 0;  // which of them was told last

  std::mutex messages_mutex_;
  std::deque<std::pair<std::string, Json>> messages_;  // that a session has yet to keep
  std::atomic<bool> keeps_messages_{false};

  std::unique_ptr<Webhook> webhook_;  // none: nobody is told
  EventTeller teller_;
  Speech speech_;  // the last: its thread calls us
};

}  // namespace odas
