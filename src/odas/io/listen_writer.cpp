// SPDX-License-Identifier: MIT
#include "odas/io/listen_writer.hpp"

#include <array>
#include <cerrno>

#include <sys/socket.h>

namespace odas {

ListenWriter::ListenWriter(const std::string& host, int port, std::string token, PeerManners manners)
    : listener_(host, port), token_(std::move(token)), manners_(std::move(manners)) {}

IoStatus ListenWriter::write(std::span<const char> record) {
  admit();
  for (Client& client : clients_) put(client, record);
  send_all();
  return {};
}

IoStatus ListenWriter::flush() {
  admit();
  send_all();
  return {};
}

void ListenWriter::admit() {
  while (auto come = listener_.accept()) {
    if (clients_.size() == kMostClients) {
      say(come->from + " was sent away: " + std::to_string(kMostClients) + " clients read already");
      continue;
    }
    clients_.push_back({PeerLink(std::move(come->socket)), TokenGate(token_), std::move(come->from), 0});
  }
  std::erase_if(clients_, [this](Client& client) { return !let_in(client); });
}

bool ListenWriter::let_in(Client& client) const {
  std::array<char, 512> said{};
  while (client.gate.state() == TokenGate::State::waiting) {
    const ssize_t count = ::recv(client.link.descriptor(), said.data(), said.size(), MSG_DONTWAIT);
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return true;
    if (count <= 0) return false;
    std::size_t used = 0;
    client.gate.push({said.data(), static_cast<std::size_t>(count)}, used);
  }
  if (client.gate.state() == TokenGate::State::granted) return true;
  say(client.from + " did not give the token first, and was sent away");
  return false;
}

void ListenWriter::put(Client& client, std::span<const char> record) {
  if (client.gate.state() != TokenGate::State::granted) return;
  if (manners_.patience.count() > 0 && !client.link.make_room(record.size(), manners_)) return;
  const bool was_behind = client.behind > 0;
  const bool taken = client.link.put(record);
  if (!taken && !was_behind) say(client.from + " does not read: whole hops are lost for it until it does");
  if (taken && was_behind) {
    say(client.from + " reads again; " + std::to_string(client.behind) + " hops are lost");
  }
  client.behind = client.link.behind();
}

void ListenWriter::send_all() {
  std::erase_if(clients_, [this](Client& client) {
    if (client.gate.state() != TokenGate::State::granted || client.link.send_some()) return false;
    client.link.lose_the_rest();
    lost_ += client.link.lost();
    return true;
  });
}

IoStatus ListenWriter::close() {
  for (Client& client : clients_) {
    client.link.finish(kFarewell);
    lost_ += client.link.lost();
  }
  clients_.clear();
  return {};
}

std::uint64_t ListenWriter::lost_records() const noexcept {
  std::uint64_t all = lost_;
  for (const Client& client : clients_) all += client.link.lost();
  return all;
}

void ListenWriter::say(const std::string& what) const {
  if (manners_.say) manners_.say(what);
}

}  // namespace odas
