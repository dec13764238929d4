// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "odas/studio/rpc.hpp"

namespace odas {

/// What a request says of who sends it.
struct Visitor {
  std::string_view host{};           // header Host
  std::string_view origin{};         // header Origin; "": none
  std::string_view authorization{};  // header
  std::string_view cookie{};         // header
  std::string_view query{};          // of the target, without '?'
};

/// Who may come in, and as what. Against pages of other sites: `Host` must be an address or a name of ours (a
/// name that its owner points at us is not), `Origin` the place that we are at. Away from this machine, and
/// wherever a token is set, a token is asked for; how much of a wrong one was right cannot be told from the
/// time.
class Gate {
 public:
  struct Tokens {
    std::string operators, viewers;  // "": nobody needs one, there is none
  };
  /// `names`: of this machine, beside numbers and localhost.
  Gate(Tokens tokens, std::vector<std::string> names, bool tls);

  struct Verdict {
    std::optional<Role> role;  // none: turned away
    int status = 200;          // 401, 403
    std::string why;           // one line, for him
    bool by_query = false;     // the token was in the address
  };
  [[nodiscard]] Verdict judge(const Visitor& visitor) const;
  /// The role that a token gives.
  [[nodiscard]] std::optional<Role> role_of(std::string_view token) const;

 private:
  [[nodiscard]] bool is_our_name(std::string_view host) const;

  Tokens tokens_;
  std::vector<std::string> names_;
  bool tls_;
};

/// `c` of `a=b&c=d`, decoded; none: it is not there.
[[nodiscard]] std::optional<std::string> query_value(std::string_view query, std::string_view key);
/// All of them.
[[nodiscard]] std::multimap<std::string, std::string> query_items(std::string_view query);
/// `%41` -> `A`. None: broken, or with a NUL.
[[nodiscard]] std::optional<std::string> percent_decoded(std::string_view text, bool plus_is_space = false);

/// 128 bits that nobody can guess, as 32 hexadecimal digits. Throws IoError where the system has none.
[[nodiscard]] std::string random_token();

}  // namespace odas
