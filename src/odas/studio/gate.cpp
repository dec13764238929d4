// SPDX-License-Identifier: MIT
#include "odas/studio/gate.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>

#include <arpa/inet.h>
#include <fmt/format.h>
#include <sys/random.h>

#include "odas/base/error.hpp"

namespace odas {
namespace {

constexpr std::string_view kBearer = "Bearer ";
constexpr std::string_view kCookie = "odas_token=";

/// Takes as long whatever is wrong with it.
bool same(std::string_view given, std::string_view secret) noexcept {
  unsigned difference = given.size() == secret.size() ? 0U : 1U;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const char expected = secret.empty() ? '\0' : secret[i % secret.size()];
    difference |= static_cast<unsigned char>(given[i]) ^ static_cast<unsigned char>(expected);
  }
  return difference == 0 && !secret.empty();
}

std::string_view cookie_token(std::string_view cookie) {
  while (!cookie.empty()) {
    const std::size_t end = std::min(cookie.find(';'), cookie.size());
    std::string_view one = cookie.substr(0, end);
    while (!one.empty() && one.front() == ' ') one.remove_prefix(1);
    if (one.starts_with(kCookie)) return one.substr(kCookie.size());
    cookie.remove_prefix(std::min(end + 1, cookie.size()));
  }
  return {};
}

/// `[::1]:8080` -> `::1`, `robot.local:8080` -> `robot.local`.
std::string host_name(std::string_view host) {
  std::string_view name = host;
  if (name.starts_with('[')) {
    name = name.substr(1, name.find(']') - 1);
  } else if (const std::size_t colon = name.find(':'); colon != std::string_view::npos) {
    name = name.substr(0, colon);
  }
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

bool is_number(const std::string& name) {
  std::array<unsigned char, sizeof(in6_addr)> address{};
  return ::inet_pton(AF_INET, name.c_str(), address.data()) == 1 ||
         ::inet_pton(AF_INET6, name.c_str(), address.data()) == 1;
}

int hex_digit(char c) noexcept {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

Gate::Gate(Tokens tokens, std::vector<std::string> names, bool tls)
    : tokens_(std::move(tokens)), names_(std::move(names)), tls_(tls) {}

bool Gate::is_our_name(std::string_view host) const {
  const std::string name = host_name(host);
  return name == "localhost" || is_number(name) ||
         std::any_of(names_.begin(), names_.end(),
                     [&](const std::string& ours) { return host_name(ours) == name; });
}

std::optional<Role> Gate::role_of(std::string_view token) const {
  if (same(token, tokens_.operators)) return Role::operator_;
  if (same(token, tokens_.viewers)) return Role::viewer;
  return std::nullopt;
}

Gate::Verdict Gate::judge(const Visitor& visitor) const {
  if (!is_our_name(visitor.host)) {
    return {std::nullopt, 403,
            "this name is not known here: use the address, or add the name to studio.hosts"};
  }
  const std::string own = std::string(tls_ ? "https://" : "http://") + std::string(visitor.host);
  if (!visitor.origin.empty() && visitor.origin != own) {
    return {std::nullopt, 403, "requests of other pages are refused"};
  }
  if (tokens_.operators.empty()) return {Role::operator_, 200, "", false};
  if (const auto token = query_value(visitor.query, "token")) {
    if (const auto role = role_of(*token)) return {role, 200, "", true};
  } else if (visitor.authorization.starts_with(kBearer)) {
    if (const auto role = role_of(visitor.authorization.substr(kBearer.size())))
      return {role, 200, "", false};
  } else if (const auto role = role_of(cookie_token(visitor.cookie))) {
    return {role, 200, "", false};
  }
  return {std::nullopt, 401, "a token is needed: open the link that was printed at the start", false};
}

std::multimap<std::string, std::string> query_items(std::string_view query) {
  std::multimap<std::string, std::string> items;
  while (!query.empty()) {
    const std::size_t end = std::min(query.find('&'), query.size());
    const std::string_view one = query.substr(0, end);
    const std::size_t equals = std::min(one.find('='), one.size());
    auto value = percent_decoded(one.substr(std::min(equals + 1, one.size())), true);
    if (value) items.emplace(one.substr(0, equals), std::move(*value));
    query.remove_prefix(std::min(end + 1, query.size()));
  }
  return items;
}

std::optional<std::string> query_value(std::string_view query, std::string_view key) {
  const auto items = query_items(query);
  const auto found = items.find(std::string(key));
  return found == items.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::string> percent_decoded(std::string_view text, bool plus_is_space) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char c = text[i];
    if (c == '%') {
      if (i + 2 >= text.size()) return std::nullopt;
      const int high = hex_digit(text[i + 1]), low = hex_digit(text[i + 2]);
      if (high < 0 || low < 0 || high + low == 0) return std::nullopt;
      c = static_cast<char>(high * 16 + low);
      i += 2;
    } else if (c == '+' && plus_is_space) {
      c = ' ';
    }
    decoded += c;
  }
  return decoded;
}

std::string random_token() {
  std::array<unsigned char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw IoError(std::string("the system gives no random numbers for a token: ") + std::strerror(errno));
  }
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

}  // namespace odas
