// SPDX-License-Identifier: MIT
#include <array>
#include <charconv>
#include <cmath>
#include <iostream>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "commands.hpp"
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <poll.h>

#include "odas/base/error.hpp"
#include "odas/io/tcp_dialer.hpp"

namespace odas {
namespace {

using nlohmann::json;

constexpr int kPatienceMs = 5000;

struct TargetsArguments {
  std::string address;
  std::string token;
  std::vector<std::string> set, add, remove;
  bool clear = false;
};

[[noreturn]] void refuse(const std::string& text, const char* form) {
  throw ConfigError("", "\"" + text + "\" is not " + form);
}

/// "fan=90,0" or "fan=0,1,0".
json target_of(const std::string& text) {
  constexpr const char* kForm = "TAG=AZIMUTH,ELEVATION (degrees) or TAG=X,Y,Z";
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos || equals == 0) refuse(text, kForm);
  std::vector<double> numbers;
  const char* at = text.data() + equals + 1;
  const char* const end = text.data() + text.size();
  for (;;) {
    double number = 0;
    const auto [stop, error] = std::from_chars(at, end, number);
    if (error != std::errc() || !std::isfinite(number)) refuse(text, kForm);
    numbers.push_back(number);
    if (stop == end) break;
    if (*stop != ',') refuse(text, kForm);
    at = stop + 1;
  }
  if (numbers.size() == 2) {
    const double azimuth = numbers[0] * std::numbers::pi / 180,
                 elevation = numbers[1] * std::numbers::pi / 180;
    numbers = {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
               std::sin(elevation)};
  }
  if (numbers.size() != 3) refuse(text, kForm);
  return {{"tag", text.substr(0, equals)}, {"x", numbers[0]}, {"y", numbers[1]}, {"z", numbers[2]}};
}

json targets_of(const std::vector<std::string>& texts) {
  json list = json::array();
  for (const std::string& text : texts) list.push_back(target_of(text));
  return list;
}

std::string message_of(const TargetsArguments& arguments) {
  if (arguments.clear || !arguments.set.empty()) return json{{"targets", targets_of(arguments.set)}}.dump();
  return json{{"add", targets_of(arguments.add)}, {"remove", arguments.remove}}.dump();
}

/// "9010", "robot:9010", "[::1]:9010".
TcpDialer dialer_of(const std::string& address) {
  const std::size_t colon = address.rfind(':');
  std::string host = colon == std::string::npos ? "127.0.0.1" : address.substr(0, colon);
  if (host.size() > 2 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
  const std::string digits = colon == std::string::npos ? address : address.substr(colon + 1);
  int port = 0;
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), port);
  if (error != std::errc() || stop != digits.data() + digits.size() || port < 1 || port > 65535) {
    refuse(address, "PORT or HOST:PORT");
  }
  return {host, port};
}

FileDescriptor dial(TcpDialer& dialer) {
  const auto until = TcpDialer::Clock::now() + std::chrono::milliseconds(kPatienceMs);
  for (;;) {
    if (auto socket = dialer.poll()) return std::move(*socket);
    if (!dialer.fault().empty() || TcpDialer::Clock::now() > until) {
      throw IoError("nobody takes targets at " + dialer.where() + ": " +
                    (dialer.fault().empty() ? "no answer" : dialer.fault()) +
                    "; a run does whose sst.control.interface is a socket_listen");
    }
    ::poll(nullptr, 0, 5);
  }
}

std::string answer_from(const FileDescriptor& socket, const std::string& where) {
  std::string line;
  std::array<char, 4096> piece{};
  while (line.find('\n') == std::string::npos) {
    pollfd asked{socket.get(), POLLIN, 0};
    if (::poll(&asked, 1, kPatienceMs) <= 0) throw IoError(where + " does not answer: is it a run of odas?");
    const ssize_t count = ::recv(socket.get(), piece.data(), piece.size(), 0);
    if (count <= 0) throw IoError(where + " has hung up without an answer");
    line.append(piece.data(), static_cast<std::size_t>(count));
  }
  return line.substr(0, line.find('\n'));
}

void change_targets(const TargetsArguments& arguments) {
  const std::string message = message_of(arguments);
  TcpDialer dialer = dialer_of(arguments.address);
  const FileDescriptor socket = dial(dialer);
  const std::string bytes = (arguments.token.empty() ? "" : arguments.token + "\n") + message + "\n";
  if (::send(socket.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(bytes.size())) {
    throw IoError(dialer.where() + " has hung up");
  }
  const std::string answer = answer_from(socket, dialer.where());
  const json heard = json::parse(answer, nullptr, false);
  if (heard.is_object() && heard.contains("error"))
    throw IoError(dialer.where() + ": " + heard["error"].dump());
  std::cout << answer << '\n';
}

}  // namespace

void add_targets(CLI::App& app) {
  CLI::App* targets = app.add_subcommand("targets", "Add, move and remove the fixed directions of a run");
  auto arguments = std::make_shared<TargetsArguments>();
  targets->add_option("ADDRESS", arguments->address, "PORT or HOST:PORT of the run's sst.control.interface")
      ->type_name("")
      ->required();
  targets
      ->add_option("--add", arguments->add,
                   "TAG=AZIMUTH,ELEVATION in degrees, or TAG=X,Y,Z; a known tag moves")
      ->type_name("TARGET");
  targets->add_option("--remove", arguments->remove, "Let this one go")->type_name("TAG");
  CLI::Option* set = targets->add_option("--set", arguments->set, "As --add, in place of all that there are")
                         ->type_name("TARGET");
  CLI::Option* clear = targets->add_flag("--clear", arguments->clear, "Let all go");
  targets->add_option("--token", arguments->token, "That of sst.control.interface, where it has one")
      ->type_name("TOKEN");
  for (CLI::Option* all : {set, clear}) {
    for (const char* part : {"--add", "--remove"}) all->excludes(part);
  }
  targets->footer(
      "Prints the targets that hold afterwards, as JSON; without options, those that hold now.\n\n"
      "Examples:\n"
      "  odas targets 9010 --add door=90,0 --add fan=0,0,1\n"
      "  odas targets robot.local:9010 --token s3cret --remove door\n");
  targets->callback([arguments] { change_targets(*arguments); });
}

}  // namespace odas
