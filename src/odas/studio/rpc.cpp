// SPDX-License-Identifier: MIT
#include "odas/studio/rpc.hpp"

#include <utility>

namespace odas {

using nlohmann::json;

void RpcRegistry::add(std::string name, Role least, std::string meaning, Method method) {
  methods_.insert_or_assign(std::move(name), Entry{least, std::move(meaning), std::move(method)});
}

json RpcRegistry::list() const {
  json all = json::array();
  for (const auto& [name, entry] : methods_) {
    all.push_back({{"name", name}, {"operator", entry.least == Role::operator_}, {"meaning", entry.meaning}});
  }
  return all;
}

json RpcRegistry::call(std::string_view name, const json& params, Role role) const {
  if (name == "methods") return list();
  const auto found = methods_.find(name);
  if (found == methods_.end()) {
    throw RpcError("unknown_method", "there is no method '" + std::string(name) + "'; 'methods' lists them");
  }
  if (found->second.least == Role::operator_ && role != Role::operator_) {
    throw RpcError("forbidden", std::string(name) + " is for operators; you are a viewer");
  }
  try {
    return found->second.method(params.is_null() ? json::object() : params);
  } catch (const json::exception& error) {
    throw RpcError("bad_request", std::string(name) + ": " + error.what());
  } catch (const RpcError&) { throw; } catch (const std::exception& error) {
    throw RpcError("failed", error.what());
  }
}

}  // namespace odas
