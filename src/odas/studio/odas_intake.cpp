// SPDX-License-Identifier: MIT
#include "odas/studio/odas_intake.hpp"

#include <algorithm>
#include <cerrno>

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>

#include "odas/base/error.hpp"
#include "odas/io/stream_intake.hpp"

namespace odas {
namespace {

using Clock = HopJoiner::Clock;

constexpr std::size_t kPiece = 65536;
constexpr int kRoundMs = 20;
constexpr std::chrono::seconds kSilence{3};            // then a sender gives way to another
constexpr std::chrono::milliseconds kAfterwards{300};  // tracks have gone: what is on its way may still come

HopJoiner::Config joined(const OdasIntakeConfig& config) {
  const auto must = [](bool good, const char* what) {
    if (!good) throw ConfigError("", what);
  };
  must(config.rate > 0 && config.sound_rate > 0, "a sample rate of ODAS is over 0");
  must(config.hop > 0 && config.hop <= 65536, "a hop of ODAS is of 1 to 65536 samples");
  must(config.channels > 0 && config.channels <= 1024, "ODAS sends 1 to 1024 channels");
  must(config.bits == 8 || config.bits == 16 || config.bits == 24 || config.bits == 32,
       "a sample of ODAS has 8, 16, 24 or 32 bits");
  HopJoiner::Config made;
  made.rate = config.rate;
  made.hop = static_cast<std::size_t>(config.hop);
  made.sound_rate = config.sound_rate;
  made.channels = static_cast<std::size_t>(config.channels);
  made.source = "ODAS";
  return made;
}

SampleFormat format_of(int bits) {
  return bits == 8    ? SampleFormat::s8
         : bits == 16 ? SampleFormat::s16
         : bits == 24 ? SampleFormat::s24_3
                      : SampleFormat::s32;
}

}  // namespace

/// A port, and who sends to it.
struct OdasIntake::Port {
  Port(const char* its_name, const std::string& host, int number, StreamKind text_kind,
       std::optional<AudioStream> sound_stream)
      : name(its_name), listener(host, number), kind(text_kind), sound(sound_stream) {}

  const char* name;
  TcpListener listener;
  StreamKind kind;
  std::optional<AudioStream> sound;  // none: text
  std::optional<FileDescriptor> socket;
  std::string from;
  Clock::time_point heard;
  std::optional<Clock::time_point> gone;  // of text: its end is told a little later
  JsonCutter cutter;
  std::unique_ptr<PcmAssembler> samples;
  bool said_nonsense = false;
  bool has_begun = false;
  bool is_text = false;  // of sound: nothing of it is any
};

OdasIntake::OdasIntake(const OdasIntakeConfig& config, HopListener& to, Say say)
    : config_(config),
      say_(say ? std::move(say) : [](const std::string&, const std::string&) {}),
      allowed_(config.allow),
      joiner_(joined(config), to, say_) {
  const auto open = [&](const char* name, int port, StreamKind kind, std::optional<AudioStream> sound) {
    return std::make_unique<Port>(name, config.listen, port, kind, sound);
  };
  ports_[0] = open("tracked", config.tracked, StreamKind::tracks, std::nullopt);
  ports_[1] = open("potential", config.potential, StreamKind::potentials, std::nullopt);
  ports_[2] = open("separated", config.separated, StreamKind::tracks, AudioStream::separated);
  ports_[3] = open("postfiltered", config.postfiltered, StreamKind::tracks, AudioStream::postfiltered);
}

OdasIntake::~OdasIntake() { stop(); }

void OdasIntake::start() {
  if (thread_.joinable()) return;
  ending_ = false;
  thread_ = std::thread([this] { run(); });
}

void OdasIntake::stop() {
  ending_ = true;
  if (thread_.joinable()) thread_.join();
}

std::string OdasIntake::where(std::string_view stream) const {
  for (const auto& port : ports_) {
    if (port->name == stream) return port->listener.where();
  }
  return "";
}

int OdasIntake::port(std::string_view stream) const {
  for (const auto& port : ports_) {
    if (port->name == stream) return port->listener.port();
  }
  return 0;
}

void OdasIntake::run() {
  while (!ending_) {
    std::vector<pollfd> asked;
    for (const auto& port : ports_) {
      asked.push_back({port->listener.descriptor(), POLLIN, 0});
      if (port->socket && !must_wait(*port)) asked.push_back({port->socket->get(), POLLIN, 0});
    }
    ::poll(asked.data(), asked.size(), kRoundMs);
    // All connections first: those of one start are then there before their first bytes.
    for (const auto& port : ports_) accept(*port);
    for (const auto& port : ports_) read(*port);
    const Clock::time_point now = Clock::now();
    joiner_.give(now);
    for (const auto& port : ports_) {
      if (port->gone && now - *port->gone > kAfterwards) {
        port->gone.reset();
        joiner_.end(port->kind);
      }
    }
    has_sender_ = ports_[0]->socket.has_value();
  }
  for (const auto& port : ports_) {
    if (port->socket) part(*port, "is left");
    if (!port->sound) joiner_.end(port->kind);
    port->gone.reset();
  }
  has_sender_ = false;
}

bool OdasIntake::must_wait(const Port& port) const {
  if (port.sound) return joiner_.is_full_of(*port.sound);
  return port.kind == StreamKind::tracks && joiner_.is_full_of_tracks();
}

void OdasIntake::accept(Port& port) {
  while (std::optional<TcpClient> client = port.listener.accept()) {
    const Clock::time_point now = Clock::now();
    if (!allowed_.allows(client->address)) {
      say_("warning", fmt::format("a sender from {} is turned away at {}: it is not allowed", client->from,
                                  port.listener.where()));
      continue;
    }
    if (port.socket) {
      read(port);  // the old one may have gone, and what it said comes first
      if (port.socket && now - port.heard < kSilence) {
        say_("warning",
             fmt::format("another sender, {}, is turned away: {} is sending", client->from, port.from));
        continue;
      }
      if (port.socket) part(port, "is silent, and gives way to another sender");
    }
    if (port.gone) {
      port.gone.reset();
      joiner_.end(port.kind);
    }
    port.socket = std::move(client->socket);
    port.from = client->from;
    port.heard = now;
    port.said_nonsense = port.has_begun = port.is_text = false;
    say_("info", fmt::format("{}: a sender has come from {}", port.name, port.from));
    if (port.sound) {
      port.samples = std::make_unique<PcmAssembler>(
          PcmAssembler::Expected{format_of(config_.bits), static_cast<std::size_t>(config_.channels),
                                 config_.sound_rate},
          HopJoiner::kMostFrames);
      joiner_.begin(*port.sound, now);
    } else {
      port.cutter.reset();
      joiner_.begin(port.kind, now);
    }
  }
}

void OdasIntake::read(Port& port) {
  std::vector<char> piece(kPiece);
  for (int i = 0; port.socket && i < 4 && !must_wait(port); ++i) {
    const ssize_t count = ::recv(port.socket->get(), piece.data(), piece.size(), MSG_DONTWAIT);
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (count <= 0) return part(port, count == 0 ? "has gone" : "is lost");
    port.heard = Clock::now();
    const auto bytes = std::span<const char>(piece).first(static_cast<std::size_t>(count));
    if (port.sound) {
      take_sound(port, bytes);
    } else {
      take_text(port, bytes);
    }
  }
}

void OdasIntake::take_text(Port& port, std::span<const char> bytes) {
  port.cutter.push({bytes.data(), bytes.size()});
  while (const auto cut = port.cutter.next()) {
    std::string fault;
    if (cut->fault != nullptr) {
      fault = cut->fault;
    } else {
      const StreamRecord record = read_stream_record(cut->text, port.kind);
      fault = record.fault;
      if (record.is_good()) joiner_.add(record, port.heard);
    }
    if (fault.empty() || std::exchange(port.said_nonsense, true)) continue;
    say_("warning",
         fmt::format("{}: what came {}: \"{}\"; it is passed over", port.name, fault, excerpt(cut->text)));
  }
}

void OdasIntake::take_sound(Port& port, std::span<const char> bytes) {
  Grid<float> block(static_cast<std::size_t>(config_.channels), HopJoiner::kMostFrames);
  const std::string_view beginning(bytes.data(), std::min<std::size_t>(bytes.size(), 64));
  if (!std::exchange(port.has_begun, true) && beginning.starts_with('{') &&
      beginning.find("\"timeStamp\"") != std::string_view::npos) {
    port.is_text = true;
    say_("warning",
         fmt::format("{}: what came is text and no sound: the ports of the sender are mixed up; it is "
                     "passed over",
                     port.name));
  }
  if (port.is_text) return;
  while (!bytes.empty()) {
    bytes = bytes.subspan(port.samples->push(bytes));
    if (const std::string& fault = port.samples->fault(); !fault.empty()) {
      if (!std::exchange(port.said_nonsense, true)) {
        say_("warning", fmt::format("{}: what came {}; it is passed over", port.name, fault));
      }
      return;
    }
    while (port.samples->frames() > 0) {
      const std::size_t frames = std::min(port.samples->frames(), block.cols());
      const GridView<float> part_of(block.data(), block.rows(), frames, block.cols());
      port.samples->pop(part_of);
      joiner_.add(*port.sound, part_of);
    }
  }
}

void OdasIntake::part(Port& port, const char* how) {
  say_("info", fmt::format("{}: the sender from {} {}", port.name, port.from, how));
  port.socket.reset();
  if (port.sound) {
    joiner_.end(*port.sound);
  } else {
    port.gone = Clock::now();
  }
}

}  // namespace odas
