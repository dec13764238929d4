// SPDX-License-Identifier: MIT
#include "odas/studio/records.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "odas/base/error.hpp"

namespace odas {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kBetweenFlushes{1};
constexpr std::chrono::milliseconds kBetweenTelling{500};
constexpr std::size_t kMostMessages = 1000;  // that wait for a session

AudioStream stream_in(const nlohmann::json& name) {
  for (std::size_t i = 0; i < kAudioStreams; ++i) {
    if (name == name_of(static_cast<AudioStream>(i))) return static_cast<AudioStream>(i);
  }
  throw RpcError("bad_request", "there is no stream " + name.dump() + ": separated, postfiltered, raw");
}

std::unique_ptr<Webhook> make_webhook(const RecordsOptions& options) {
  if (options.events.url.empty()) return nullptr;
  Webhook::Options hook;
  hook.url = options.events.url;
  hook.timeout = std::chrono::milliseconds(static_cast<int>(options.events.timeout * 1000));
  hook.say = options.say;
  return std::make_unique<Webhook>(std::move(hook));
}

}  // namespace

Records::Records(RecordsOptions options, Announcer& to)
    : options_(std::move(options)),
      to_(to),
      recordings_(options_.folder),
      sessions_(options_.folder),
      recorder_(options_.folder, options_.preroll_s),
      webhook_(make_webhook(options_)),
      teller_([this](const Json& event) {
        announce("events", event);
        if (webhook_) webhook_->post(event.dump(-1, ' ', false, Json::error_handler_t::replace));
      }),
      speech_(speech_options()) {}

Speech::Options Records::speech_options() {
  Speech::Options speech;
  speech.command = options_.speech.command;
  speech.heard = [this](const SpokenText& said) { heard(said); };
  speech.say = options_.say;
  return speech;
}

Records::~Records() { end(); }

void Records::begin(const StreamInfo& info) {
  teller_.begin(info);
  speech_.begin(info);
  Lock lock(mutex_);
  info_ = info;
  last_ = 0;
  recorder_.begin(info);
  if (session_) session_failed(session_->begin(info));
  tell(lock);
}

void Records::hop(const HopResult& hop) {
  teller_.hop(hop);
  speech_.hop(hop);
  Lock lock(mutex_);
  recorder_.hop(hop);
  last_ = hop.time;
  if (session_) session_failed(session_->hop(hop));
  if (session_) drain_messages();
  const Clock::time_point now = Clock::now();
  if (now - flushed_ >= kBetweenFlushes) {
    flushed_ = now;
    each_second();
  }
  for (std::string& fault : recorder_.take_faults()) faults_.push_back(std::move(fault));
  const bool busy = session_ != nullptr || !recorder_.jobs().empty();
  if (!faults_.empty() || (busy && now - told_ >= kBetweenTelling)) tell(lock);
}

void Records::end() {
  teller_.end();
  speech_.end();
  Lock lock(mutex_);
  if (!info_) return;
  stop_all();
  recorder_.end();
  info_.reset();
  tell(lock);
}

void Records::each_second() {
  if (!session_ && recorder_.jobs().empty()) return;
  const std::uint64_t free = free_space();
  if (free < options_.least_free) {
    faults_.push_back(fmt::format("recording has stopped: only {} MB are free in {}", free / 1'000'000,
                                  options_.folder.string()));
    stop_all();
    return;
  }
  recorder_.flush();
  if (session_) session_failed(session_->flush());
}

void Records::stop_all() {
  std::vector<std::string> names;
  if (session_) stop_one(session_id_, names);
  while (!recorder_.jobs().empty()) recorder_.stop(recorder_.jobs().begin()->first);
}

void Records::session_failed(const IoStatus& status) {
  if (status.ok()) return;
  faults_.push_back(status.what() + "; the session has ended");
  static_cast<void>(session_->close().ok());
  session_.reset();
  keeps_messages_ = false;
}

void Records::announce(const std::string& topic, const Json& message) {
  to_.announce(topic, message);
  const std::string type = message.value("type", "");
  if (!keeps_messages_ || (type != "log" && type != "event" && type != "transcript")) return;
  // Not under the lock of the disk: whoever announces must not wait for it.
  const std::scoped_lock lock(messages_mutex_);
  if (messages_.size() < kMostMessages) messages_.emplace_back(type, message);
}

void Records::drain_messages() {
  std::deque<std::pair<std::string, Json>> messages;
  {
    const std::scoped_lock lock(messages_mutex_);
    messages.swap(messages_);
  }
  for (const auto& [topic, message] : messages) {
    if (session_) session_failed(session_->add(topic, message));
  }
}

void Records::heard(const SpokenText& said) {
  announce("transcripts", {{"type", "transcript"},
                           {"track", said.track},
                           {"text", said.text},
                           {"final", said.is_final},
                           {"from", said.from_s},
                           {"to", said.to_s}});
  if (!said.is_final) return;
  const std::scoped_lock lock(mutex_);
  recorder_.add(said.track, {said.from_s, said.to_s, said.text});
}

std::uint64_t Records::free_space() const {
  if (options_.free_space) return options_.free_space(options_.folder);
  std::error_code error;
  const fs::space_info space = fs::space(options_.folder, error);
  return error ? 0 : space.available;
}

nlohmann::json Records::state() const {
  static constexpr std::array<const char*, 3> kWhat{"track", "all", "raw"};
  Json active = Json::array();
  for (const auto& [id, job] : recorder_.jobs()) {
    Json entry{{"id", id},
               {"what", kWhat[static_cast<std::size_t>(job.order.what)]},
               {"name", job.names.empty() ? "" : job.names.back()},
               {"files", job.names.size()},
               {"seconds", recorder_.seconds_of(job)}};
    if (job.order.what != Recorder::What::raw) entry["stream"] = name_of(job.order.stream);
    if (job.order.what == Recorder::What::track) entry["track"] = job.order.track;
    active.push_back(std::move(entry));
  }
  if (session_) {
    active.push_back({{"id", session_id_},
                      {"what", "session"},
                      {"name", session_->name()},
                      {"seconds", session_->seconds()}});
  }
  return {{"type", "recordings"}, {"active", active}, {"disk_free", free_space()}};
}

void Records::tell(Lock& lock) {
  for (std::string& fault : recorder_.take_faults()) faults_.push_back(std::move(fault));
  const std::vector<std::string> faults = std::exchange(faults_, {});
  Json message = state();
  if (!faults.empty()) message["fault"] = faults.back();
  told_ = Clock::now();
  const std::uint64_t number = ++states_;
  lock.unlock();
  {
    // Another thread may have come in between: what is told last is how it is.
    const std::scoped_lock telling(telling_mutex_);
    if (number > told_state_) to_.announce("recordings", message);
    told_state_ = std::max(told_state_, number);
  }
  if (!options_.say) return;
  for (const std::string& fault : faults) options_.say("error", fault);
}

nlohmann::json Records::start(const Json& params) {
  Lock lock(mutex_);
  if (!info_) throw RpcError("conflict", "nothing is running that could be recorded");
  std::error_code error;
  fs::create_directories(options_.folder, error);
  if (error) {
    throw RpcError("failed",
                   "cannot use " + options_.folder.string() + " for recordings: " + error.message());
  }
  if (const std::uint64_t free = free_space(); free < options_.least_free) {
    throw RpcError("failed", fmt::format("only {} MB are free in {}: delete something first",
                                         free / 1'000'000, options_.folder.string()));
  }
  flushed_ = Clock::now();
  const bool session = params.at("what") == "session";
  const std::uint64_t id = session ? start_session(params) : start_takes(params);
  std::string name;
  if (session) {
    name = session_->name();
  } else if (const auto& names = recorder_.jobs().at(id).names; !names.empty()) {
    name = names.back();
  }
  tell(lock);
  return {{"id", id}, {"name", name}};
}

std::uint64_t Records::start_session(const Json& params) {
  if (session_) throw RpcError("conflict", "a session is being recorded already");
  SessionRecorder::Streams streams{true, true, true};
  if (params.contains("audio")) {
    streams = {};
    for (const Json& name : params.at("audio")) streams[static_cast<std::size_t>(stream_in(name))] = true;
  }
  session_ = std::make_unique<SessionRecorder>(options_.folder, streams);
  session_id_ = next_id_++;
  keeps_messages_ = true;
  if (IoStatus status = session_->begin(*info_, last_); !status.ok()) {
    session_.reset();
    throw RpcError("failed", status.what());
  }
  return session_id_;
}

std::uint64_t Records::start_takes(const Json& params) {
  Recorder::Order order;
  const std::string what = params.at("what").get<std::string>();
  if (what == "track") {
    order.track = params.at("track").get<std::uint64_t>();
  } else if (what == "raw" || what == "all") {
    order.what = what == "raw" ? Recorder::What::raw : Recorder::What::all;
  } else {
    throw RpcError("bad_request", "cannot record '" + what + "': track, all, raw or session");
  }
  if (what != "raw") order.stream = stream_in(params.value("stream", "separated"));
  if (what != "raw" && order.stream == AudioStream::raw) {
    throw RpcError("bad_request", "the microphones are recorded by \"what\": \"raw\"");
  }
  order.preroll_s = std::clamp(params.value("preroll", options_.preroll_s), 0.0, options_.preroll_s);
  const std::uint64_t id = next_id_++;
  try {
    recorder_.start(id, order);
  } catch (const IoError& error) { throw RpcError("failed", error.what()); }
  return id;
}

std::optional<std::string> Records::stop_one(std::uint64_t id, std::vector<std::string>& names) {
  if (session_ && id == session_id_) {
    drain_messages();
    if (!session_) return std::nullopt;
    names.push_back(session_->name());
    if (IoStatus status = session_->close(); !status.ok()) faults_.push_back(status.what());
    session_.reset();
    keeps_messages_ = false;
    return std::nullopt;
  }
  auto stopped = recorder_.stop(id);
  if (!stopped) return "nothing is being recorded under " + std::to_string(id) + "; perhaps it has ended";
  names.insert(names.end(), stopped->begin(), stopped->end());
  return std::nullopt;
}

nlohmann::json Records::stop(const Json& params) {
  Lock lock(mutex_);
  std::vector<std::string> names;
  if (params.value("all", false)) {
    if (session_) stop_one(session_id_, names);
    while (!recorder_.jobs().empty()) stop_one(recorder_.jobs().begin()->first, names);
  } else if (const auto fault = stop_one(params.at("id").get<std::uint64_t>(), names)) {
    throw RpcError("not_found", *fault);
  }
  tell(lock);
  return {{"names", names}};
}

}  // namespace odas
