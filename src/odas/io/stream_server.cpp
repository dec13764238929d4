// SPDX-License-Identifier: MIT
#include "odas/io/stream_server.hpp"

#include <algorithm>
#include <cerrno>
#include <utility>

#include <fmt/format.h>
#include <poll.h>

#include "odas/base/error.hpp"
#include "odas/io/stream_intake.hpp"

namespace odas {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kPieceSize = std::size_t{64} * 1024;
constexpr int kPieces = 8;  // of one port before the others have their turn
constexpr std::chrono::seconds kBetweenRefusals{10};
constexpr std::chrono::seconds kLastCall{1};  // for what has come already

std::size_t index_of(Stream stream) { return static_cast<std::size_t>(stream); }

}  // namespace

/// A port, and who sends to it.
class StreamServer::Port {
 public:
  Port(Stream stream, const std::string& host, int port, StreamServer& server)
      : stream_(stream), name_(kStreamNames[index_of(stream)]), listener_(host, port), server_(server) {}

  [[nodiscard]] Stream stream() const noexcept { return stream_; }
  [[nodiscard]] const TcpListener& listener() const noexcept { return listener_; }
  void ask(std::vector<pollfd>& asked) const {
    asked.push_back({listener_.descriptor(), POLLIN, 0});
    if (sender_) asked.push_back({sender_->socket.get(), POLLIN, 0});
  }

  /// First what the sender says, so that one who has gone makes room for the next.
  IoStatus step() {
    if (IoStatus status = read(); !status.ok()) return status;
    while (std::optional<TcpClient> client = listener_.accept()) {
      if (IoStatus status = admit(std::move(*client)); !status.ok()) return status;
    }
    return {};
  }
  IoStatus flush() { return sender_ ? sender_->intake->flush() : IoStatus(); }
  /// The sender is gone, or sent away.
  IoStatus part(const char* how);

  [[nodiscard]] std::string state() const {
    std::string text = fmt::format("{:<12} {:<21} ", name_, listener_.where());
    if (!sender_) return text + "nobody sends";
    text += sender_->intake->amount() + " from " + sender_->from;
    const auto silent = std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - sender_->heard);
    return silent < kSilence ? text : text + fmt::format(", silent for {} s", silent.count());
  }

 private:
  struct Sender {
    FileDescriptor socket;
    std::string from;
    std::unique_ptr<StreamIntake> intake;
    Clock::time_point heard;
    std::uint64_t bytes = 0;
  };

  IoStatus admit(TcpClient client);
  IoStatus read();
  [[nodiscard]] bool turn_away(const TcpClient& client);
  std::unique_ptr<StreamIntake> make_intake();
  std::unique_ptr<WavWriter> open_wav(const WavWriter::Format& format);
  IoStatus note(const char* what, const Sender& sender, std::string file) const {
    return server_.archive_.note({name_, what, sender.from, std::move(file), sender.bytes},
                                 std::chrono::system_clock::now());
  }
  void say(const std::string& what) const { server_.say(std::string(name_) + ": " + what); }

  Stream stream_;
  const char* name_;
  TcpListener listener_;
  StreamServer& server_;
  std::unique_ptr<Sender> sender_;            // nullptr: nobody sends
  std::optional<Clock::time_point> refused_;  // when it was last said
};

bool StreamServer::Port::turn_away(const TcpClient& client) {
  const Clock::time_point now = Clock::now();
  const bool is_welcome = server_.allowed_.allows(client.address);
  if (is_welcome && (!sender_ || now - sender_->heard > kSilence)) return false;
  if (!refused_ || now - *refused_ > kBetweenRefusals) {
    refused_ = now;
    say(is_welcome ? "another sender, " + client.from + ", is turned away: " + sender_->from + " is sending"
                   : "a sender from " + client.from + " is turned away: allow it by --allow");
  }
  return true;
}

IoStatus StreamServer::Port::admit(TcpClient client) {
  if (turn_away(client)) return {};
  if (IoStatus status = part("is silent, and gives way to another sender"); !status.ok()) return status;
  sender_ = std::make_unique<Sender>(
      Sender{std::move(client.socket), std::move(client.from), make_intake(), Clock::now()});
  say("a sender has come from " + sender_->from);
  return note("begin", *sender_, "");
}

std::unique_ptr<WavWriter> StreamServer::Port::open_wav(const WavWriter::Format& format) {
  auto wav = server_.archive_.open_wav(name_, format);
  const IoStatus noted = note("file", *sender_, std::filesystem::path(wav->where()).filename().string());
  if (!noted.ok()) throw IoError(noted.what());
  return wav;
}

std::unique_ptr<StreamIntake> StreamServer::Port::make_intake() {
  const auto tell = [this](const std::string& what) { say(what); };
  if (stream_ == Stream::separated || stream_ == Stream::postfiltered) {
    const WavWriter::Format& format =
        stream_ == Stream::separated ? server_.config_.separated : server_.config_.postfiltered;
    const auto open = [this](const WavWriter::Format& of) { return open_wav(of); };
    return std::make_unique<AudioIntake>(format, open, tell);
  }
  const StreamKind expected = stream_ == Stream::tracked     ? StreamKind::tracks
                              : stream_ == Stream::potential ? StreamKind::potentials
                                                             : StreamKind::categories;
  const auto receive = [this](const StreamRecord& record, std::string_view text) {
    return server_.receive(record, text);
  };
  return std::make_unique<TextIntake>(expected, receive, tell);
}

IoStatus StreamServer::Port::read() {
  std::array<char, kPieceSize> piece;  // NOLINT(cppcoreguidelines-pro-type-member-init): recv fills it
  for (int i = 0; sender_ && i < kPieces; ++i) {
    const ssize_t count = ::recv(sender_->socket.get(), piece.data(), piece.size(), 0);
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return {};
    if (count <= 0) return part(count == 0 ? "has gone" : "is lost");
    sender_->heard = Clock::now();
    sender_->bytes += static_cast<std::uint64_t>(count);
    IoStatus status = sender_->intake->take(std::span(piece).first(static_cast<std::size_t>(count)));
    if (!status.ok()) return status;
  }
  return {};
}

IoStatus StreamServer::Port::part(const char* how) {
  if (!sender_) return {};
  const std::unique_ptr<Sender> sender = std::move(sender_);
  IoStatus closed = sender->intake->close();
  const std::string file = sender->intake->file();
  say("the sender from " + sender->from + " " + how + ": " + sender->intake->amount() +
      (file.empty() ? "" : " in " + file));
  IoStatus noted = note("end", *sender, file);
  if (stream_ == Stream::tracked) server_.tracks_.clear();
  if (stream_ == Stream::category) server_.categories_.clear();
  return !closed.ok() ? closed : noted;
}

StreamServer::StreamServer(const StreamServerConfig& config, StreamArchive& archive)
    : config_(config), archive_(archive), allowed_(config.allow) {
  for (std::size_t s = 0; s < kStreams; ++s) {
    if (!config.ports[s]) continue;
    ports_.push_back(std::make_unique<Port>(static_cast<Stream>(s), config.listen, *config.ports[s], *this));
  }
}

StreamServer::~StreamServer() = default;

void StreamServer::say(const std::string& what) const {
  if (config_.say) config_.say(what);
}

bool StreamServer::is_asked(std::chrono::milliseconds patience) const {
  std::vector<pollfd> asked;
  for (const auto& port : ports_) port->ask(asked);
  return ::poll(asked.data(), asked.size(), static_cast<int>(patience.count())) > 0;
}

IoStatus StreamServer::step(std::chrono::milliseconds patience) {
  static_cast<void>(is_asked(patience));
  for (const auto& port : ports_) {
    if (IoStatus status = port->step(); !status.ok()) return status;
  }
  if (Clock::now() - told_ > kSilence) tracks_.clear();
  return {};
}

IoStatus StreamServer::receive(const StreamRecord& record, std::string_view text) {
  StreamRecord known = record;
  for (std::size_t slot = 0; slot < known.tracks.size(); ++slot) {
    Track& track = known.tracks[slot];
    const bool is_told = track.category != Category::undefined;
    if (record.kind == StreamKind::tracks) {
      if (!is_told && slot < categories_.size()) track.category = categories_[slot];
    } else if (slot < tracks_.size() && track.id == 0) {
      track.id = tracks_[slot].id;
    }
  }
  if (record.kind == StreamKind::tracks) {
    tracks_ = known.tracks;
    told_ = Clock::now();
    if (config_.heard) config_.heard(tracks_);
  }
  if (record.kind == StreamKind::categories) {
    categories_.clear();
    for (std::size_t slot = 0; slot < known.tracks.size(); ++slot) {
      categories_.push_back(known.tracks[slot].category);
      if (slot < tracks_.size()) tracks_[slot].category = categories_.back();
    }
  }
  return archive_.add(known, text, std::chrono::system_clock::now());
}

IoStatus StreamServer::flush() {
  for (const auto& port : ports_) {
    if (IoStatus status = port->flush(); !status.ok()) return status;
  }
  return {};
}

IoStatus StreamServer::close() {
  IoStatus all;
  for (const auto until = Clock::now() + kLastCall; all.ok() && is_asked({}) && Clock::now() < until;) {
    all = step({});
  }
  for (const auto& port : ports_) {
    IoStatus status = port->part("was still there");
    if (all.ok()) all = std::move(status);
  }
  return all;
}

std::vector<std::string> StreamServer::state() const {
  std::vector<std::string> lines;
  for (const auto& port : ports_) lines.push_back(port->state());
  return lines;
}

std::string StreamServer::where(Stream stream) const {
  for (const auto& port : ports_) {
    if (port->stream() == stream) return port->listener().where();
  }
  return "";
}

}  // namespace odas
