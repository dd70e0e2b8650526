// A scanner that knows of TOML only strings, comments and the points in keys.
#include "core/scene_scan.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace sluice {
namespace {

constexpr int max_parts_of_key = 16;  // a scene needs four

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);  // a byte order mark takes no column
  }

  std::optional<ScanProblem> run() {
    while (at_ < text_.size() && problem_.message.empty()) {
      if (peek() == '#') {
        while (at_ < text_.size() && peek() != '\n') skip(1);
      } else if (peek() == '"' || peek() == '\'') {
        string();
      } else {
        outside();
      }
    }
    return problem_.message.empty() ? std::nullopt : std::optional(problem_);
  }

 private:
  char peek() const { return text_[at_]; }
  bool ahead(std::string_view what) const { return text_.substr(at_).starts_with(what); }

  void skip(size_t bytes) {
    for (char c : text_.substr(at_, bytes)) {
      if (c == '\n') {
        ++problem_.line;
        problem_.column = 1;
      } else if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) {
        ++problem_.column;
      }
    }
    at_ = std::min(at_ + bytes, text_.size());
  }

  void outside() {
    if (!is_ascii(peek())) {
      problem_.message =
          "found a character beyond ASCII, expected such characters in strings and comments only";
    } else if (peek() == '.' && ++points_ >= max_parts_of_key) {
      problem_.message =
          fmt::format("found a key of more than {0} parts, expected at most {0}", max_parts_of_key);
    } else {
      if (std::string_view("\n=,{}[]").find(peek()) != std::string_view::npos) points_ = 0;
      skip(1);
    }
  }

  /// From the opening to behind the closing quotes, or to the end of the line that should have them.
  void string() {
    char mark = peek();
    bool multi = ahead("\"\"\"") || ahead("'''");
    std::string quotes(multi ? 3 : 1, mark);
    skip(quotes.size());
    while (at_ < text_.size() && problem_.message.empty() && (multi || peek() != '\n')) {
      if (ahead(quotes)) {
        skip(quotes.size());
        for (int i = 0; multi && i < 2 && ahead({&mark, 1}); ++i) skip(1);  // up to two belong to the string
        return;
      }
      if (mark == '"' && peek() == '\\') {
        escape(multi);
      } else {
        skip(1);
      }
    }
  }

  /// A backslash with the character behind it, or with all white space behind it at the end of a line.
  void escape(bool multi) {
    skip(1);
    auto is_white = [&] {
      return at_ < text_.size() && std::string_view(" \t\r\n").find(peek()) != std::string_view::npos;
    };
    bool line_end = multi && is_white();
    while (line_end && is_white()) skip(1);
    if (at_ < text_.size() && !is_ascii(peek())) {
      problem_.message = "found a character beyond ASCII after a backslash, expected it as \\uXXXX there";
    } else if (!line_end) {
      skip(1);
    }
  }

  std::string_view text_;
  size_t at_ = 0;
  int points_ = 0;       // since the last character that ends a key
  ScanProblem problem_;  // its place is where the scanner is
};

}  // namespace

std::optional<ScanProblem> scan_toml(std::string_view text) { return Scanner(text).run(); }

bool is_utf8(std::string_view text) {
  auto byte = [&](size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  for (size_t i = 0; i < text.size();) {
    unsigned first = byte(i), second = byte(i + 1);
    size_t more = first < 0x80 ? 0 : first >= 0xC2 && first < 0xE0 ? 1 : (first & 0xF0) == 0xE0 ? 2 : 3;
    if (more == 3 && (first < 0xF0 || first > 0xF4)) return false;
    for (size_t k = 1; k <= more; ++k)
      if ((byte(i + k) & 0xC0) != 0x80) return false;
    bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
    bool surrogate = first == 0xED && second > 0x9F;
    bool beyond = first == 0xF4 && second > 0x8F;
    if (overlong || surrogate || beyond) return false;
    i += 1 + more;
  }
  return true;
}

}  // namespace sluice
