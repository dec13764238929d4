// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace odas {

/// Why a command is not carried out; docs/protocol.md lists the codes.
class RpcError : public std::runtime_error {
 public:
  RpcError(std::string code, const std::string& message, nlohmann::json data = nullptr)
      : std::runtime_error(message), code_(std::move(code)), data_(std::move(data)) {}
  [[nodiscard]] const std::string& code() const noexcept { return code_; }
  [[nodiscard]] const nlohmann::json& data() const noexcept { return data_; }

 private:
  std::string code_;
  nlohmann::json data_;
};

enum class Role { viewer, operator_ };

/// The commands that a client may give, by name. Filled before the server starts; `call` is used by one
/// thread, the commands', so that a command may take its time and sees no other beside it.
class RpcRegistry {
 public:
  using Method = std::function<nlohmann::json(const nlohmann::json& params)>;

  /// `least`: who may. `meaning`: one line for `methods`.
  void add(std::string name, Role least, std::string meaning, Method method);

  /// The result. Throws RpcError: no such method, not for this role, or as the method does; a parameter that
  /// is missing or of the wrong kind is `bad_request`, any other exception `failed`.
  [[nodiscard]] nlohmann::json call(std::string_view name, const nlohmann::json& params, Role role) const;

 private:
  struct Entry {
    Role least;
    std::string meaning;
    Method method;
  };
  [[nodiscard]] nlohmann::json list() const;
  std::map<std::string, Entry, std::less<>> methods_;
};

}  // namespace odas
