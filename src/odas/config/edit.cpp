// SPDX-License-Identifier: MIT
#include "odas/config/edit.hpp"

#include <cctype>
#include <optional>
#include <vector>

namespace odas {
namespace {

bool is_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '*';
}

struct Span {
  std::size_t begin, end;
};

/// Walks over libconfig's text, past comments and strings, and notes where a setting's value stands.
class Finder {
 public:
  Finder(std::string_view text, std::string_view group, std::string_view name)
      : text_(text), group_(group), name_(name) {}

  struct Found {
    std::optional<Span> value;          // of the setting
    std::optional<std::size_t> inside;  // just behind the group's opening bracket
  };

  Found find() {
    while (at_ < text_.size()) {
      if (skip_comment_or_string()) continue;
      const char c = text_[at_];
      if (is_name(c)) {
        take_word();
        continue;
      }
      if (c == '=' || c == ':') begin_value();
      if (c == '{' || c == '(' || c == '[') open(c);
      if (c == '}' || c == ')' || c == ']') close();
      if (c == ';' || c == ',') end_value(at_);
      ++at_;
    }
    end_value(text_.size());
    return found_;
  }

 private:
  bool skip_comment_or_string() {
    const std::string_view rest = text_.substr(at_);
    std::size_t length = 0;
    if (rest.starts_with('#') || rest.starts_with("//")) {
      length = std::min(rest.find('\n'), rest.size());
    } else if (rest.starts_with("/*")) {
      length = std::min(rest.find("*/", 2), rest.size() - 2) + 2;
    } else if (rest.starts_with('"')) {
      length = 1;
      while (length < rest.size() && rest[length] != '"') length += rest[length] == '\\' ? 2 : 1;
      ++length;
      last_ = at_ + length;
    } else {
      return false;
    }
    at_ += std::min(length, rest.size());
    return true;
  }

  void take_word() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_name(text_[at_])) ++at_;
    const std::string_view word = text_.substr(begin, at_ - begin);
    // Without ';' a word that another setting follows ends the value before it.
    if (in_value_ && path_.size() == value_depth_ && last_ > value_begin_ && next_is_assignment())
      end_value(last_);
    word_ = word;
    last_ = at_;
  }

  [[nodiscard]] bool next_is_assignment() const {
    const std::size_t next = text_.find_first_not_of(" \t\r\n", at_);
    return next != std::string_view::npos && (text_[next] == '=' || text_[next] == ':');
  }

  void begin_value() {
    if (path_.size() != 1 || path_[0] != group_ || word_ != name_ || found_.value) return;
    in_value_ = true;
    value_begin_ = text_.find_first_not_of(" \t\r\n", at_ + 1);
    value_depth_ = path_.size();
    last_ = 0;
  }

  void open(char bracket) {
    path_.push_back(bracket == '{' ? word_ : std::string_view());
    word_ = {};
    if (path_.size() == 1 && bracket == '{' && path_[0] == group_) found_.inside = at_ + 1;
  }

  void close() {
    if (in_value_ && path_.size() == value_depth_) end_value(last_);
    if (!path_.empty()) path_.pop_back();
    word_ = {};
    last_ = at_ + 1;
    if (in_value_ && path_.size() == value_depth_) end_value(at_ + 1);
  }

  void end_value(std::size_t end) {
    if (!in_value_ || path_.size() != value_depth_) return;
    in_value_ = false;
    found_.value = Span{value_begin_, end};
  }

  std::string_view text_, group_, name_;
  std::size_t at_ = 0;
  std::vector<std::string_view> path_;  // names of the open groups; empty for lists
  std::string_view word_;               // the last name
  std::size_t last_ = 0;                // behind the last word, string or bracket
  bool in_value_ = false;
  std::size_t value_begin_ = 0, value_depth_ = 0;
  Found found_;
};

}  // namespace

std::string with_setting(std::string_view text, std::string_view group, std::string_view name,
                         std::string_view value) {
  const Finder::Found found = Finder(text, group, name).find();
  const auto put = [&](Span at, const std::string& what) {
    return std::string(text.substr(0, at.begin)).append(what).append(text.substr(at.end));
  };
  if (found.value) return put(*found.value, std::string(value));
  const std::string setting = std::string(name) + " = " + std::string(value) + ";";
  if (found.inside) return put({*found.inside, *found.inside}, "\n  " + setting);
  return put({text.size(), text.size()}, "\n" + std::string(group) + ": {\n  " + setting + "\n};\n");
}

std::string without_setting(std::string_view text, std::string_view group, std::string_view name) {
  const auto value = Finder(text, group, name).find().value;
  if (!value) return std::string(text);
  // Back over '=' or ':' to the name, and on over what ends the setting.
  std::size_t begin = text.find_last_of("=:", value->begin - 1);
  begin = text.rfind(name, begin);
  std::size_t end = value->end;
  const std::size_t next = text.find_first_not_of(" \t", end);
  if (next != std::string_view::npos && (text[next] == ';' || text[next] == ',')) end = next + 1;
  // A line of which nothing is left goes as a whole.
  const std::size_t line = text.find_last_not_of(" \t", begin - 1);
  const std::size_t rest = text.find_first_not_of(" \t", end);
  if (line != std::string_view::npos && text[line] == '\n' && rest != std::string_view::npos &&
      text[rest] == '\n') {
    begin = line;
    end = rest;
  }
  return std::string(text.substr(0, begin)).append(text.substr(end));
}

}  // namespace odas
