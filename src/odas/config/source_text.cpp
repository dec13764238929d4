// SPDX-License-Identifier: MIT
#include "odas/config/source_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <limits>
#include <optional>

#include "odas/config/array_library.hpp"

namespace odas {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxBytes = 4U << 20U;  // what is larger is no configuration
constexpr std::size_t kMaxDepth = 64;         // of brackets; the parser's stack is bounded too
constexpr int kMaxIncludes = 10;              // one in the other, as in libconfig

std::optional<std::string> read_bytes(const fs::path& path, std::string& why) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    why = "there is no such file";
    return std::nullopt;
  }
  if (fs::is_directory(status)) {
    why = "is a folder; a configuration file is wanted";
    return std::nullopt;
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    why = "cannot be opened: is it readable for you?";
    return std::nullopt;
  }
  std::string bytes;
  std::array<char, 1U << 16U> block{};
  while (bytes.size() <= kMaxBytes && (file.read(block.data(), block.size()) || file.gcount() > 0)) {
    bytes.append(block.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) {
    why = "cannot be read";
    return std::nullopt;
  }
  if (bytes.size() > kMaxBytes) {
    why = "is larger than 4 MiB: this is no configuration";
    return std::nullopt;
  }
  if (bytes.find('\0') != std::string::npos) {
    why = "holds zero bytes: this is no text file";
    return std::nullopt;
  }
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
  return bytes;
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '*'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A number as libconfig reads it rightly: whole numbers beyond 32 bits become floats.
std::string safe_number(const std::string& token) {
  std::string digits = token;
  while (digits.ends_with('L')) digits.pop_back();
  const std::size_t sign = !digits.empty() && (digits[0] == '-' || digits[0] == '+') ? 1 : 0;
  const bool hex = digits.size() > 2 && digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'X');
  const auto is_hex = [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; };
  if (hex ? !std::all_of(digits.begin() + 2, digits.end(), is_hex)
          : sign == digits.size() ||
                !std::all_of(digits.begin() + static_cast<std::ptrdiff_t>(sign), digits.end(), is_digit)) {
    return token;
  }
  double value = 0;
  for (std::size_t i = hex ? 2 : sign; i < digits.size(); ++i) {
    const char c = digits[i];
    const int digit = is_digit(c) ? c - '0' : std::tolower(static_cast<unsigned char>(c)) - 'a' + 10;
    value = value * (hex ? 16 : 10) + digit;
  }
  if (value <= std::numeric_limits<int>::max()) return token;
  return hex ? std::to_string(value) : digits + ".0";
}

/// Beside the including file, in the working directory, or with the arrays that come with the program, so
/// that a copy of one of these finds what it includes. Where there is none, beside the including file.
fs::path find_included(const fs::path& beside, const std::string& name) {
  std::vector<fs::path> folders{beside, {}};
  for (fs::path& folder : array_folders()) folders.push_back(std::move(folder));
  for (const fs::path& folder : folders) {
    std::error_code error;
    if (fs::exists(folder / name, error)) return folder / name;
  }
  return beside / name;
}

}  // namespace

/// Walks over the text as libconfig's own scanner does: strings, comments, brackets, numbers.
class SourceScanner {
 public:
  SourceScanner(SourceText& out, std::vector<Fault>& faults) : out_(out), faults_(faults) {}

  void add(const std::string& bytes, const std::string& file, int depth) {
    std::size_t begin = 0;
    for (int number = 1; begin < bytes.size(); ++number) {
      const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
      std::string line = bytes.substr(begin, end - begin);
      begin = end + 1;
      if (line.ends_with('\r')) line.pop_back();
      const Location here{file, number};
      if (const auto name = included(line)) {
        include(*name, here, depth);
      } else {
        scan(line, here);
      }
    }
  }

  void finish() {
    const auto unclosed = [&](const char* what, const Location& where) {
      fault(where, std::string(what) + " that is opened here is never closed");
    };
    if (in_comment_) unclosed("the comment", opened_);
    if (in_string_) unclosed("the quote", opened_);
    if (!brackets_.empty()) {
      const char text[] = {'\'', brackets_.back().open, '\'', '\0'};
      unclosed(text, brackets_.back().where);
    }
  }

 private:
  struct Bracket {
    char open;
    Location where;
  };

  void fault(const Location& where, std::string what) {
    faults_.push_back({Fault::Severity::error, "", std::move(what), where.file, where.line});
  }

  /// The file named by a line `@include "file"`.
  [[nodiscard]] std::optional<std::string> included(const std::string& line) const {
    if (in_comment_ || in_string_) return std::nullopt;
    constexpr std::string_view kWord = "@include";
    std::size_t at = line.find_first_not_of(" \t");
    if (at == std::string::npos || line.compare(at, kWord.size(), kWord) != 0) return std::nullopt;
    at = line.find_first_not_of(" \t", at + kWord.size());
    if (at == std::string::npos || line[at] != '"') return std::nullopt;
    const std::size_t end = line.find('"', at + 1);
    if (end == std::string::npos) return std::nullopt;
    return line.substr(at + 1, end - at - 1);
  }

  void include(const std::string& name, const Location& here, int depth) {
    if (depth >= kMaxIncludes) {
      return fault(here, "\"" + name + "\" is included too deep: do the files include each other?");
    }
    const fs::path path = find_included(fs::path(here.file).parent_path(), name);
    std::string why;
    const auto bytes = read_bytes(path, why);
    if (!bytes) return fault(here, "@include \"" + path.string() + "\": " + why);
    if (out_.text_.size() + bytes->size() > kMaxBytes) return fault(here, "the included files are too large");
    add(*bytes, path.string(), depth + 1);
  }

  void scan(const std::string& line, const Location& here) {
    out_.lines_.push_back({here, line});
    for (std::size_t i = 0; i < line.size();) {
      const std::string_view rest = std::string_view(line).substr(i);
      i += in_comment_ || in_string_ ? skip(rest) : take(rest, here);
    }
    out_.text_ += '\n';
  }

  std::size_t write(std::string_view text) {
    out_.text_ += text;
    return text.size();
  }

  /// The next piece of a comment or string; its length.
  std::size_t skip(std::string_view rest) {
    if (in_comment_ && rest.starts_with("*/")) {
      in_comment_ = false;
      return write("*/");
    }
    if (in_string_ && rest[0] == '"') in_string_ = false;
    return write(rest.substr(0, in_string_ && rest[0] == '\\' ? 2 : 1));
  }

  /// The next token outside of comments and strings; its length.
  std::size_t take(std::string_view rest, const Location& here) {
    if (std::isspace(static_cast<unsigned char>(rest[0])) != 0) return write(rest.substr(0, 1));
    if (rest[0] == '#' || rest.starts_with("//")) return write(rest);
    if (rest.starts_with("/*")) {
      in_comment_ = true, opened_ = here;
      return write("/*");
    }
    if (rest[0] == '"') check_quote(here);
    last_ = rest[0];
    if (rest[0] == '"') {
      in_string_ = true, opened_ = here;
    } else if (std::string_view("([{)]}").find(rest[0]) != std::string_view::npos) {
      out_.text_ += bracket(rest[0], here);
      return 1;
    } else if (const std::size_t digits = number_length(rest); digits > 0) {
      write(safe_number(std::string(rest.substr(0, digits))));
      return digits;
    } else if (is_word(rest[0])) {
      std::size_t length = 1;
      while (length < rest.size() && (is_word(rest[length]) || rest[length] == '-')) ++length;
      return write(rest.substr(0, length));
    }
    return write(rest.substr(0, 1));
  }

  /// A text stands after '=' or ':', in a list after '(' or ',', or after another text, which it continues.
  /// Elsewhere libconfig would find a syntax error, and lose the memory of the text.
  void check_quote(const Location& here) {
    const bool in_list = !brackets_.empty() && brackets_.back().open != '{';
    const std::string_view before = in_list ? "([,\"" : "=:\"";
    if (before.find(last_) != std::string_view::npos) return;
    fault(here, std::string("a text in quotes cannot stand here; ") +
                    (in_list ? "is a ',' missing before it?" : "is a '=' missing before it?"));
  }

  /// Of the number that the text begins with; 0 where it begins with none.
  static std::size_t number_length(std::string_view rest) {
    const std::size_t sign = rest[0] == '-' || rest[0] == '+' ? 1 : 0;
    const std::size_t point = sign < rest.size() && rest[sign] == '.' ? 1 : 0;
    if (sign + point >= rest.size() || !is_digit(rest[sign + point])) return 0;
    std::size_t n = sign + point + 1;
    while (n < rest.size()) {
      const bool exponent_sign =
          (rest[n] == '-' || rest[n] == '+') && (rest[n - 1] == 'e' || rest[n - 1] == 'E');
      if (!is_word(rest[n]) && rest[n] != '.' && !exponent_sign) break;
      ++n;
    }
    return n;
  }

  /// What stands for a bracket in libconfig's text. Follows the nesting.
  char bracket(char c, const Location& here) {
    if (c == '(' || c == '[' || c == '{') {
      if (brackets_.size() == kMaxDepth) fault(here, "brackets are nested deeper than 64");
      brackets_.push_back({c, here});
      return c == '[' ? '(' : c;
    }
    const char open = c == ')' ? '(' : c == ']' ? '[' : '{';
    if (brackets_.empty()) {
      fault(here, std::string("'") + c + "' closes nothing");
    } else {
      const Bracket& last = brackets_.back();
      if (last.open != open) {
        fault(here, std::string("'") + c + "' closes the '" + last.open + "' of line " +
                        std::to_string(last.where.line));
      }
      brackets_.pop_back();
    }
    return c == ']' ? ')' : c;
  }

  SourceText& out_;
  std::vector<Fault>& faults_;
  std::vector<Bracket> brackets_;
  bool in_comment_ = false;
  bool in_string_ = false;
  Location opened_;  // the comment or string
  char last_ = ';';  // first character of the last token
};

SourceText SourceText::from_file(const fs::path& path, std::vector<Fault>& faults) {
  std::string why;
  const auto bytes = read_bytes(path, why);
  if (bytes) return from_text(*bytes, path.string(), faults);
  faults.push_back({Fault::Severity::error, "", why, path.string(), 0});
  SourceText none;
  none.name_ = path.string();
  return none;
}

SourceText SourceText::from_text(std::string_view text, const std::string& name, std::vector<Fault>& faults) {
  SourceText out;
  out.name_ = name;
  SourceScanner scanner(out, faults);
  std::string bytes(text);
  if (bytes.find('\0') != std::string::npos) {
    faults.push_back({Fault::Severity::error, "", "holds zero bytes: this is no text", name, 0});
    return out;
  }
  scanner.add(bytes, name, 0);
  scanner.finish();
  return out;
}

Location SourceText::location(int line) const {
  if (lines_.empty()) return {name_, 0};
  const auto last = static_cast<int>(lines_.size());
  return lines_[static_cast<std::size_t>(std::clamp(line, 1, last) - 1)].location;
}

std::string SourceText::written() const {
  std::string text;
  for (const Line& line : lines_) text += line.written + '\n';
  return text;
}

std::string SourceText::excerpt(int line) const {
  if (lines_.empty()) return "";
  const auto last = static_cast<int>(lines_.size());
  const std::string& written = lines_[static_cast<std::size_t>(std::clamp(line, 1, last) - 1)].written;
  const std::size_t begin = written.find_first_not_of(" \t");
  if (begin == std::string::npos) return "";
  return written.substr(begin, std::min<std::size_t>(written.find_last_not_of(" \t") + 1 - begin, 60));
}

}  // namespace odas
