// SPDX-License-Identifier: MIT
#include "odas/io/json_cutter.hpp"

#include <utility>

namespace odas {
namespace {

constexpr std::size_t kExcerpt = 48;  // bytes of a fault that are shown

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\0'; }

}  // namespace

void JsonCutter::push(std::string_view piece) {
  piece_.erase(0, at_);
  at_ = 0;
  piece_ += piece;
}

void JsonCutter::begin() {
  object_.clear();
  depth_ = 0;
  in_string_ = after_backslash_ = false;
  last_ = 0;
}

JsonCutter::Cut JsonCutter::fault(const char* what) {
  done_ = depth_ > 0 ? object_.substr(0, kExcerpt) : piece_.substr(at_, kExcerpt);
  begin();
  return {done_, what};
}

std::optional<JsonCutter::Cut> JsonCutter::next() {
  while (at_ < piece_.size()) {
    const char byte = piece_[at_];
    if (depth_ == 0 && byte != '{') {
      if (!in_garbage_ && !is_space(byte)) {
        in_garbage_ = true;
        return fault("is no JSON object");
      }
      ++at_;
      continue;
    }
    if (in_string_ && byte == '\n') return fault("is cut off");  // JSON has no such strings
    const bool may_open = last_ == 0 || last_ == '[' || last_ == ',' || last_ == ':';
    if (byte == '{' && !in_string_ && !may_open) return fault("is cut off");
    ++at_;
    if (ends_with(byte)) {
      std::swap(done_, object_);
      begin();
      return Cut{done_};
    }
    if (object_.size() >= kLongest) {
      in_garbage_ = true;
      return fault("has more than 65536 bytes");
    }
  }
  return std::nullopt;
}

bool JsonCutter::ends_with(char byte) {
  in_garbage_ = false;
  object_ += byte;
  if (in_string_) {
    if (!after_backslash_ && byte == '"') in_string_ = false;
    after_backslash_ = !after_backslash_ && byte == '\\';
    return false;
  }
  if (is_space(byte)) return false;
  last_ = byte;
  in_string_ = byte == '"';
  if (byte == '{') ++depth_;
  if (byte == '}') --depth_;
  return depth_ == 0;
}

}  // namespace odas
