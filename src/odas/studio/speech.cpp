// SPDX-License-Identifier: MIT
#include "odas/studio/speech.hpp"

#include <algorithm>
#include <csignal>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <poll.h>

#include "odas/base/error.hpp"
#include "odas/io/pcm.hpp"

namespace odas {
namespace {

constexpr int kWaitMs = 20;  // sound comes by the hop: there is no hurry
constexpr int kIdleMs = 100;
constexpr std::size_t kReadBytes = 65536;
constexpr std::size_t kLongestLine = 65536;
constexpr std::size_t kSampleBytes = 2;

}  // namespace

Speech::Speech(Options options) : options_(std::move(options)) {
  if (!options_.command.empty()) thread_ = std::thread([this] { run(); });
}

Speech::~Speech() {
  end();
  {
    const std::scoped_lock lock(mutex_);
    ending_ = true;
    until_ = Clock::now() + options_.farewell;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void Speech::begin(const StreamInfo& info) {
  end();
  const std::scoped_lock lock(mutex_);
  info_ = info;
  failures_ = 0;
  said_.clear();
}

void Speech::end() {
  const std::scoped_lock lock(mutex_);
  for (Voice& voice : voices_) {
    if (!std::exchange(voice.over, true)) voice.ended = Clock::now();
  }
  info_.reset();
}

void Speech::hop(const HopResult& hop) {
  const AudioStream stream = hop.separated.empty() ? AudioStream::postfiltered : AudioStream::separated;
  const GridView<const float> audio = audio_of(hop, stream);
  const std::scoped_lock lock(mutex_);
  if (!info_ || options_.command.empty() || audio.empty()) return;
  const auto most = static_cast<std::size_t>(kBuffered * info_->sample_rate) * kSampleBytes;
  bytes_.resize(audio.cols() * kSampleBytes);
  const auto lives = [&](std::uint64_t id) {
    return std::any_of(hop.tracks.begin(), hop.tracks.end(),
                       [&](const Track& track) { return track.id == id; });
  };
  for (Voice& voice : voices_) {
    if (!voice.over && !lives(voice.track)) {
      voice.over = true;
      voice.ended = Clock::now();
    }
  }
  for (std::size_t slot = 0; slot < std::min(audio.rows(), hop.tracks.size()); ++slot) {
    const std::uint64_t id = hop.tracks[slot].id;
    if (id == 0) continue;
    auto voice = std::find_if(voices_.begin(), voices_.end(),
                              [&](const Voice& known) { return known.track == id && !known.over; });
    if (voice == voices_.end()) {
      if (failures_ >= kFailures || voices_.size() >= kPrograms) {
        if (voices_.size() >= kPrograms)
          say_once("many", "more voices at a time than programs may be started");
        continue;
      }
      voice = voices_.emplace(voices_.end());
      voice->track = id;
      voice->rate = info_->sample_rate;
      voice->start_s =
          static_cast<double>((hop.time - 1) * info_->hop_size) / info_->sample_rate - info_->voice_delay_s;
    }
    if (voice->is_deaf) continue;  // its program has gone
    voice->samples += audio.cols();
    if (voice->waiting.size() + bytes_.size() > most) {
      say_once("slow", "it reads too slowly, and misses sound");
      continue;
    }
    encode_pcm(GridView<const float>(audio[slot].data(), 1, audio.cols()), gain_of(*info_, stream), 16,
               bytes_);
    voice->waiting.append(bytes_.data(), bytes_.size());
  }
}

void Speech::say_once(const char* kind, const std::string& text) {
  if (std::find(said_.begin(), said_.end(), kind) != said_.end()) return;
  said_.emplace_back(kind);
  if (options_.say) options_.say("warning", "the speech program (" + options_.command + "): " + text);
}

std::vector<Speech::Voice*> Speech::start_programs() {
  std::vector<Voice*> served;
  const std::scoped_lock lock(mutex_);
  for (Voice& voice : voices_) {
    const auto enough = static_cast<std::uint64_t>(kShortest * voice.rate);
    if (!voice.program && voice.samples >= enough && failures_ < kFailures) {
      try {
        voice.program = std::make_unique<SpeechProgram>(
            options_.command, std::vector<std::string>{"ODAS_TRACK=" + std::to_string(voice.track),
                                                       "ODAS_SAMPLE_RATE=" + std::to_string(voice.rate)});
      } catch (const IoError& error) {
        say_once("start", error.what());
        failures_ = kFailures;
      }
    }
    if (voice.program) served.push_back(&voice);
  }
  return served;
}

void Speech::run() {
  // A program that has gone is an error value of write, not our end.
  sigset_t pipe;
  sigemptyset(&pipe);
  sigaddset(&pipe, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &pipe, nullptr);
  for (;;) {
    const std::vector<Voice*> served = start_programs();
    std::vector<pollfd> outputs;
    for (const Voice* voice : served) outputs.push_back({voice->program->output(), POLLIN, 0});
    if (!outputs.empty()) ::poll(outputs.data(), outputs.size(), kWaitMs);
    for (Voice* voice : served) serve(*voice);
    std::unique_lock lock(mutex_);
    for (auto voice = voices_.begin(); voice != voices_.end();) {
      voice = is_done(*voice) ? voices_.erase(voice) : std::next(voice);
    }
    if (ending_ && (voices_.empty() || Clock::now() >= until_)) {
      voices_.clear();
      return;
    }
    wake_.wait_for(lock, std::chrono::milliseconds(voices_.empty() ? kIdleMs : kWaitMs));
  }
}

void Speech::serve(Voice& voice) {
  SpeechProgram& program = *voice.program;
  std::string input;
  bool over = false;
  {
    const std::scoped_lock lock(mutex_);
    input.swap(voice.waiting);
    over = voice.over;
  }
  const std::size_t taken = program.write(input);
  if (taken < input.size()) {
    const std::scoped_lock lock(mutex_);
    voice.waiting.insert(0, input, taken);
  } else if (over) {
    program.close_input();
  }
  const std::string output = program.read(kReadBytes);
  const Clock::time_point now = Clock::now();
  if (now - voice.second > std::chrono::seconds(1)) {
    voice.second = now;
    voice.said = 0;
  }
  voice.was_quiet = output.empty();
  voice.said += output.size();
  if (voice.said > kFlood && !std::exchange(voice.was_killed, true)) {
    program.kill();
    const std::scoped_lock lock(mutex_);
    say_once("flood", "it writes without end, and was killed");
  }
  if (voice.was_killed) return;
  for (const char c : output) {
    if (c != '\n') {
      if (voice.line.size() < kLongestLine) voice.line += c;
      continue;
    }
    take_line(voice, voice.line);
    voice.line.clear();
  }
}

void Speech::take_line(Voice& voice, const std::string& line) {
  if (line.find_first_not_of(" \t\r") == std::string::npos) return;
  const nlohmann::json said = nlohmann::json::parse(line, nullptr, false);
  const bool is_good = said.is_object() && said.contains("text") && said["text"].is_string();
  double until = 0;
  {
    const std::scoped_lock lock(mutex_);
    if (!is_good) return say_once("nonsense", "it wrote what is no line of {\"text\":...,\"final\":...}");
    until = static_cast<double>(voice.samples - voice.waiting.size() / kSampleBytes) / voice.rate;
    failures_ = 0;
  }
  voice.has_spoken = true;
  const auto number = [&](const char* key, double otherwise) {
    const auto found = said.find(key);
    return found != said.end() && found->is_number() ? found->get<double>() : otherwise;
  };
  SpokenText text;
  text.track = voice.track;
  text.text = said["text"].get<std::string>();
  text.is_final = said.contains("final") && said["final"] == true;
  text.from_s = voice.start_s + number("from", voice.said_until_s);
  text.to_s = voice.start_s + number("to", until);
  if (text.is_final) voice.said_until_s = number("to", until);
  if (!text.text.empty() && options_.heard) options_.heard(text);
}

bool Speech::is_done(Voice& voice) {
  if (!voice.program) {
    // Too short for a word, or nobody is there to hear it.
    if (failures_ >= kFailures) return voice.over || voice.samples > static_cast<std::uint64_t>(voice.rate);
    return voice.over && voice.samples < static_cast<std::uint64_t>(kShortest * voice.rate);
  }
  const auto code = voice.program->exit_code();
  // What it wrote last may still be in the pipe: one more round, and as many as there is something.
  if (code && std::exchange(voice.has_exited, true) && voice.was_quiet &&
      !std::exchange(voice.is_deaf, true)) {
    const bool failed = !voice.was_killed && (*code != 0 || !voice.over) && !voice.has_spoken;
    if (failed && ++failures_ >= kFailures) {
      say_once("failed", fmt::format("it has ended {} times without a word, with code {}; it is not started "
                                     "again in this run. Try it by hand",
                                     failures_, *code));
    } else if (!voice.over && !voice.was_killed) {
      say_once("ended", fmt::format("it has ended before its voice, with code {}", *code));
    }
    voice.waiting = {};
  }
  if (voice.is_deaf) return voice.over;
  if (voice.over && Clock::now() - voice.ended > options_.patience &&
      !std::exchange(voice.was_killed, true)) {
    voice.program->kill();
    say_once("late", "it did not end after its voice, and was killed");
  }
  return false;
}

}  // namespace odas
