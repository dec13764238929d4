// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace odas {

/// Cuts a stream of JSON objects, with or without space between them, that arrives in pieces of any size.
///
/// Method: an object ends where its braces are even (those within strings do not count). A brace opens where
/// no value can stand, or a line ends within a string: the object was cut, and cutting begins anew. What
/// stands outside of braces, and what grows over kLongest, is a fault, and cutting goes on at the next brace.
/// Cost: each byte is looked at once; at most kLongest bytes and the last piece are held.
class JsonCutter {
 public:
  static constexpr std::size_t kLongest = 65536;  // bytes of an object

  /// From brace to brace; or, with a fault, the first bytes of what is no object.
  struct Cut {
    std::string_view text;        // until the next call
    const char* fault = nullptr;  // "is cut off"
  };

  /// A piece of what arrives. Ask `next` until it has no more before the next piece.
  void push(std::string_view piece);
  /// The next cut; none: more bytes are needed.
  [[nodiscard]] std::optional<Cut> next();
  /// Forgets what has arrived: another peer is speaking.
  void reset() { *this = {}; }

 private:
  /// Looks at one byte; true if an object ends with it.
  bool ends_with(char byte);
  void begin();
  [[nodiscard]] Cut fault(const char* what);

  std::string piece_;  // what has been pushed and not been looked at, from at_ on
  std::size_t at_ = 0;
  std::string object_;  // from its opening brace on
  std::string done_;    // what the last cut shows
  int depth_ = 0;       // open braces; 0: between objects
  bool in_string_ = false;
  bool after_backslash_ = false;
  char last_ = 0;            // last byte of the object that is no space, outside of strings
  bool in_garbage_ = false;  // between objects, and it has been said
};

}  // namespace odas
