// SPDX-License-Identifier: MIT
#include "odas/studio/web_policy.hpp"

#include <array>

#include <unistd.h>

#include "odas/base/host.hpp"
#include "odas/studio/gate.hpp"
#include "odas/studio/own_address.hpp"

namespace odas {
namespace {

/// `http://camera:8080`, of any address there.
std::string origin_of(const std::string& url) {
  const std::size_t slashes = url.find("://");
  if (slashes == std::string::npos) return "";
  const std::string origin = url.substr(0, url.find('/', slashes + 3));
  const bool clean = origin.find_first_of(" ;,'\"\r\n") == std::string::npos;
  return clean ? origin : "";
}

}  // namespace

std::string operator_token(const StudioConfig& config) {
  if (!config.token.empty() || is_loopback_host(config.ip)) return config.token;
  return random_token();
}

std::vector<std::string> server_names(const StudioConfig& config) {
  std::vector<std::string> names = config.hosts;
  if (!config.ip.empty()) names.push_back(config.ip);
  std::array<char, 256> own{};
  if (::gethostname(own.data(), own.size() - 1) == 0 && own[0] != '\0') {
    names.insert(names.end(), {own.data(), std::string(own.data()) + ".local"});
  }
  return names;
}

std::string link_host(const StudioConfig& config) {
  std::string host = config.ip;
  if (host == "0.0.0.0" || host == "::") host = own_address();
  if (host.empty()) host = "127.0.0.1";
  return host.find(':') == std::string::npos ? host : "[" + host + "]";
}

std::string content_policy(const StudioConfig& config) {
  return "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: "
         "blob: " +
         origin_of(config.camera.url) +
         "; connect-src 'self'; media-src 'self' blob:; font-src 'self'; worker-src 'self'; manifest-src "
         "'self'; "
         "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
}

}  // namespace odas
