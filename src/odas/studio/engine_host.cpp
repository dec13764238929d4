// SPDX-License-Identifier: MIT
#include "odas/studio/engine_host.hpp"

#include <array>
#include <exception>
#include <utility>

#include <nlohmann/json.hpp>

#include "odas/base/error.hpp"
#include "odas/engine/live.hpp"
#include "odas/engine/signals_blocked.hpp"
#include "odas/io/looped_source.hpp"
#include "odas/io/paced_source.hpp"
#include "odas/io/recording.hpp"
#include "odas/io/registry.hpp"
#include "odas/io/run_equipment.hpp"
#include "odas/studio/stream_info.hpp"
#include "odas/studio/studio_sink.hpp"

namespace odas {

using std::chrono::milliseconds;

namespace {

/// A source that outlives the run that reads it: another may go on where this one stops.
class LentSource : public AudioSource {
 public:
  explicit LentSource(AudioSource& source) : source_(source) {}
  [[nodiscard]] std::size_t channels() const noexcept override { return source_.channels(); }
  [[nodiscard]] int sample_rate() const noexcept override { return source_.sample_rate(); }
  [[nodiscard]] bool live() const noexcept override { return source_.live(); }
  [[nodiscard]] std::optional<std::uint64_t> total_frames() const noexcept override {
    return source_.total_frames();
  }
  [[nodiscard]] ReadResult read(GridView<float> block) override { return source_.read(block); }
  [[nodiscard]] std::string warning() const override { return source_.warning(); }

 private:
  AudioSource& source_;
};

}  // namespace

const char* name_of(EngineState state) noexcept {
  static constexpr std::array<const char*, 7> kNames{"idle",    "starting", "running", "waiting",
                                                     "stopped", "failed",   "ended"};
  return kNames[static_cast<std::size_t>(state)];
}

struct EngineHost::Job {
  CheckedDocument checked;
  bool keep_source = false;
};

struct EngineHost::Current {
  Pipeline& pipeline;
  RunEquipment& equipment;
  StudioSink& sink;
  StreamInfo info;
  std::vector<Vec3> power_grid;
  std::shared_ptr<PipelineInbox> pipelines;
  CheckedDocument& checked;  // its configuration is that which runs
};

EngineHost::EngineHost(Options options, Announcer& to, LogBook& log, std::vector<HopListener*> listeners)
    : options_(std::move(options)), to_(to), log_(log), listeners_(std::move(listeners)) {
  const SignalsBlocked signals_blocked;
  thread_ = std::thread([this] { work(); });
}

EngineHost::~EngineHost() { shut_down(); }

void EngineHost::shut_down() {
  if (!thread_.joinable()) return;
  {
    const Lock lock(mutex_);
    quit_ = true;
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void EngineHost::open(Document document) {
  CheckedDocument checked = check_document(std::move(document), options_.outputs);
  {
    const Lock lock(mutex_);
    status_.document = checked.document;
    status_.has_document = true;
    saved_text_ = checked.document.file.empty() ? "" : checked.document.text;
    previous_.reset();
  }
  order(std::move(checked), false);
}

void EngineHost::start() {
  const Status now = status();
  if (!now.has_document) throw ConfigError("", "nothing is open: choose a device or a file, and an array");
  order(check_document(now.document, options_.outputs), false);
}

void EngineHost::stop() {
  const Lock lock(mutex_);
  job_.reset();
  stop_ = true;
}

void EngineHost::order(CheckedDocument checked, bool keep_source) {
  for (const Fault& fault : checked.loaded.faults) log_.warning(fault.path + ": " + fault.what);
  {
    const Lock lock(mutex_);
    job_ = std::make_unique<Job>(Job{std::move(checked), keep_source});
    stop_ = true;
  }
  changed_.notify_all();
}

Effect EngineHost::effect_of(const std::string& text) const {
  const Status now = status();
  Document document = now.document;
  document.text = text;
  const CheckedDocument checked = check_document(document, options_.outputs);
  if (!now.has_document) return Effect::reopen;
  const CheckedDocument before = check_document(now.document, options_.outputs);
  return odas::effect_of(before.loaded.config, checked.loaded.config,
                         checked.pipeline->can_continue(*before.pipeline));
}

Effect EngineHost::apply(const std::string& text) {
  const Status now = status();
  Document document = now.document;
  document.text = text;
  if (document.name.empty()) document.name = "unnamed";
  Effect effect = put_in_place(check_document(document, options_.outputs));
  const Lock lock(mutex_);
  if (now.has_document && now.document.text != text) previous_ = now.document.text;
  return effect;
}

Effect EngineHost::revert() {
  const Status now = status();
  std::string text;
  {
    const Lock lock(mutex_);
    if (!previous_) throw ConfigError("", "there is nothing to go back to: nothing was applied");
    text = *previous_;
  }
  Document document = now.document;
  document.text = text;
  const Effect effect = put_in_place(check_document(document, options_.outputs));
  const Lock lock(mutex_);
  previous_.reset();
  return effect;
}

Effect EngineHost::put_in_place(CheckedDocument checked) {
  const Status before = status();
  Effect effect = Effect::reopen;
  if (before.has_document) {
    const CheckedDocument old = check_document(before.document, options_.outputs);
    effect = odas::effect_of(old.loaded.config, checked.loaded.config,
                             checked.pipeline->can_continue(*old.pipeline));
  }
  {
    const Lock lock(mutex_);
    status_.document = checked.document;
    status_.has_document = true;
  }
  if (effect == Effect::none) return effect;
  const bool runs = before.state == EngineState::running || before.state == EngineState::waiting ||
                    before.state == EngineState::starting;
  // Whoever has stopped it does not want to be heard because a number was changed.
  if (!runs && before.state == EngineState::stopped) return effect;
  if (effect == Effect::live && !apply_live(checked)) effect = Effect::restart;
  if (effect == Effect::live) return effect;
  order(std::move(checked), runs && effect == Effect::restart);
  return effect;
}

bool EngineHost::apply_live(CheckedDocument& checked) {
  constexpr milliseconds kStep{5}, kPatience{1000};
  std::shared_ptr<PipelineInbox> pipelines;
  {
    const Lock lock(mutex_);
    if (current_ == nullptr || job_ != nullptr || !current_->pipelines->tidy() ||
        !checked.pipeline->can_continue(current_->pipeline)) {
      return false;
    }
    pipelines = current_->pipelines;
    pipelines->post(std::move(checked.pipeline));
    StreamInfo info = info_of(checked, current_->info.kind == StreamInfo::Kind::live, current_->power_grid);
    info.run = current_->info.run;
    info.start = current_->info.start;
    current_->sink.change(info);
    current_->info = std::move(info);
  }
  // The old pipeline is taken down here, not by the engine. A source that gives nothing takes none.
  for (milliseconds waited{0}; !pipelines->tidy() && waited < kPatience; waited += kStep) {
    std::this_thread::sleep_for(kStep);
  }
  log_.info("the configuration was applied between two hops");
  return true;
}

void EngineHost::save(const std::filesystem::path& file) {
  const Status now = status();
  if (!now.has_document) throw IoError("nothing is open that could be saved");
  save_text(file, now.document.text);
  const Lock lock(mutex_);
  status_.document.file = file;
  status_.document.name = file.stem().string();
  saved_text_ = now.document.text;
}

EngineHost::Status EngineHost::status() const {
  const Lock lock(mutex_);
  Status status = status_;
  status.dirty = status.has_document && status.document.text != saved_text_;
  status.has_previous = previous_.has_value();
  return status;
}

bool EngineHost::wait_for_end(milliseconds patience) {
  Lock lock(mutex_);
  return changed_.wait_for(lock, patience, [&] { return !busy_ && job_ == nullptr; });
}

TargetInbox::Orders EngineHost::targets() const {
  const Lock lock(mutex_);
  return current_ != nullptr ? current_->equipment.targets().orders() : TargetInbox::Orders{};
}

bool EngineHost::change_targets(const std::function<void(TargetInbox::Orders&)>& edit) {
  const Lock lock(mutex_);
  if (current_ == nullptr) return false;
  current_->equipment.targets().change(edit);
  return true;
}

nlohmann::json EngineHost::health() { return health_.read(); }

void EngineHost::work() {
  std::unique_ptr<AudioSource> source;
  for (;;) {
    std::unique_ptr<Job> job;
    {
      Lock lock(mutex_);
      busy_ = false;
      changed_.notify_all();
      if (job_ == nullptr || !job_->keep_source) {
        const std::unique_ptr<AudioSource> over = std::move(source);
        lock.unlock();
        if (over) {
          if (const IoStatus kept = over->finish(); !kept.ok()) log_.error(kept.what());
        }
        lock.lock();
      }
      changed_.wait(lock, [&] { return quit_ || job_ != nullptr; });
      if (quit_) break;
      job = std::move(job_);
      busy_ = true;
      stop_ = false;
    }
    run(*job, source);
  }
}

void EngineHost::run(Job& job, std::unique_ptr<AudioSource>& source) {
  try {
    if (!job.keep_source || source == nullptr) {
      source.reset();
      set_state(EngineState::starting, "opening " + source_text(job.checked.config.raw));
      source = open_source(job.checked.config.raw);
    }
    run_job(job, source);
  } catch (const ConfigError& error) {
    set_state(EngineState::failed, job.checked.loaded.locations.locate(error).what());
  } catch (const std::exception& error) { set_state(EngineState::failed, error.what()); }
}

std::unique_ptr<AudioSource> EngineHost::open_source(const RawConfig& raw) {
  if (options_.open_source) return options_.open_source(raw);
  if (!options_.loop || raw.interface.type != "file") return make_source(raw);
  return std::make_unique<PacedSource>(
      std::make_unique<LoopedSource>([raw] { return open_recording(raw.interface.path, raw); }));
}

void EngineHost::run_job(Job& job, std::unique_ptr<AudioSource>& source) {
  CheckedDocument& checked = job.checked;
  Pipeline& pipeline = *checked.pipeline;
  SinkOptions sink_options;
  sink_options.live = source->live();
  sink_options.stop = &stop_;
  sink_options.say = [this](const std::string& what) { log_.info(what); };
  RunEquipment equipment(checked.config, sink_options);
  const auto figures = std::make_shared<RunFigures>();
  std::vector<Sink*> sinks = equipment.sinks();
  StudioSink studio(listeners_, sinks, figures);
  sinks.push_back(&studio);

  const auto pipelines = std::make_shared<PipelineInbox>();
  const std::vector<Vec3> grid(pipeline.power_grid().begin(), pipeline.power_grid().end());
  Current current{pipeline, equipment, studio, info_of(checked, source->live(), grid),
                  grid,     pipelines, checked};
  current.info.start = sink_options.start;
  RunOptions options;
  options.stop = &stop_;
  options.targets = &equipment.targets();
  options.pipelines = pipelines.get();
  options.metrics = &figures->engine;
  options.warn = [this](const std::string& warning) { log_.warning(warning); };
  options.notice = [this](const std::string& text) { notice(text); };
  options.progress = [this, &equipment, before = std::uint64_t{0}](std::uint64_t done,
                                                                   std::optional<std::uint64_t>) mutable {
    equipment.targets().retry();
    if (std::exchange(before, done) != done) arrived();
  };
  {
    const Lock lock(mutex_);
    current.info.run = ++runs_;
    current_ = &current;
  }
  health_.begin(figures);
  for (HopListener* listener : listeners_) listener->begin(current.info);
  set_state(EngineState::running, source_text(checked.config.raw));
  LentSource lent(*source);
  RunSummary summary;
  std::exception_ptr failure;
  try {
    summary = run_live(lent, checked.config, pipeline, sinks, options);
  } catch (...) { failure = std::current_exception(); }
  bool goes_on = false;
  {
    const Lock lock(mutex_);
    current_ = nullptr;
    goes_on = job_ != nullptr || quit_;
  }
  for (HopListener* listener : listeners_) listener->end();
  if (failure) std::rethrow_exception(failure);
  switch (summary.end) {
    case RunSummary::End::stopped:
      if (!goes_on) set_state(EngineState::stopped, "stopped; Start begins anew");
      break;
    case RunSummary::End::end_of_input:
      set_state(EngineState::ended, "the input has ended; Start begins anew");
      break;
    case RunSummary::End::source_failed:
    case RunSummary::End::sink_failed:
      set_state(EngineState::failed, summary.fault);
  }
}

StreamInfo EngineHost::info_of(const CheckedDocument& checked, bool live,
                               const std::vector<Vec3>& power_grid) const {
  StreamInfo info = stream_info(checked);
  info.kind = live ? StreamInfo::Kind::live : StreamInfo::Kind::recording;
  info.power_grid = power_grid;
  return info;
}

void EngineHost::set_state(EngineState state, const std::string& what) {
  {
    const Lock lock(mutex_);
    status_.state = state;
    status_.what = what;
  }
  if (state == EngineState::failed) {
    log_.error(what);
  } else {
    log_.info(std::string(name_of(state)) + ": " + what);
  }
  to_.announce("", {{"type", "engine"}, {"state", name_of(state)}, {"what", what}});
}

void EngineHost::notice(const std::string& text) {
  const bool waits =
      text.find("waiting") != std::string::npos || text.find("cannot reach") != std::string::npos;
  if (waits) return set_state(EngineState::waiting, text);
  log_.info(text);
}

void EngineHost::arrived() {
  std::string what;
  {
    const Lock lock(mutex_);
    if (status_.state != EngineState::waiting || current_ == nullptr) return;
    what = current_->info.source;
  }
  set_state(EngineState::running, what);
}

}  // namespace odas
