// A scanner that knows of TOML only strings, comments and the points in keys; and the moving of characters.
#include "core/scene/scan.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace sluice {
namespace {

constexpr int max_parts_of_key = 16;  // a scene needs four
constexpr uint32_t shielded = 0x100000;

unsigned byte_at(std::string_view text, size_t i) {
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
}

/// Bytes of the character at the start of the text; 0 if it isn't one.
size_t character_size(std::string_view text) {
  unsigned first = byte_at(text, 0), second = byte_at(text, 1);
  if (first < 0x80) return 1;
  if (first < 0xC2 || first > 0xF3) return 0;
  size_t size = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  for (size_t i = 1; i < size; ++i)
    if ((byte_at(text, i) & 0xC0) != 0x80) return 0;
  bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  bool surrogate = first == 0xED && second > 0x9F;
  return overlong || surrogate ? 0 : size;
}

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::optional<ScanProblem> run() {
    while (going()) {
      if (peek() == '#') {
        while (going() && peek() != '\n') skip();
      } else if (peek() == '"' || peek() == '\'') {
        string();
      } else {
        outside();
      }
    }
    return problem_.message.empty() ? std::nullopt : std::optional(problem_);
  }

 private:
  bool going() const { return at_ < text_.size() && problem_.message.empty(); }
  char peek() const { return text_[at_]; }
  bool ahead(std::string_view what) const { return text_.substr(at_).starts_with(what); }

  /// Goes past some characters, as far as there are any.
  void skip(size_t characters = 1) {
    for (; characters > 0 && going(); --characters) {
      size_t size = character_size(text_.substr(at_));
      if (size == 0) {
        problem_.message = "found bytes that are not UTF-8, expected TOML text";
      } else if (peek() == '\n') {
        ++problem_.line;
        problem_.column = 1;
      } else {
        ++problem_.column;
      }
      at_ += size;
    }
  }

  void outside() {
    if (peek() == '.' && ++points_ >= max_parts_of_key) {
      problem_.message =
          fmt::format("found a key of more than {0} parts, expected at most {0}", max_parts_of_key);
      return;
    }
    if (std::string_view("\n=,{}[]").find(peek()) != std::string_view::npos) points_ = 0;
    skip();
  }

  /// From the opening to behind the closing quotes, or to the end of the line that should have them.
  void string() {
    char mark = peek();
    bool multi = ahead("\"\"\"") || ahead("'''");
    std::string quotes(multi ? 3 : 1, mark);
    skip(quotes.size());
    while (going() && (multi || peek() != '\n')) {
      if (ahead(quotes)) {
        skip(quotes.size());
        for (int i = 0; multi && i < 2 && ahead({&mark, 1}); ++i) skip();  // up to two belong to the string
        return;
      }
      skip(mark == '"' && peek() == '\\' ? 2 : 1);
    }
  }

  std::string_view text_;
  size_t at_ = 0;
  int points_ = 0;       // since the last character that ends a key
  ScanProblem problem_;  // its place is where the scanner is
};

/// Good UTF-8 with `move` applied to each code point.
std::string move_characters(std::string_view text, const auto& move) {
  std::string moved;
  moved.reserve(text.size());
  for (size_t i = 0; i < text.size();) {
    unsigned first = byte_at(text, i);
    size_t size = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    uint32_t code = size == 1 ? first : first & (0x7Fu >> size);
    for (size_t k = 1; k < size; ++k) code = code << 6 | (byte_at(text, i + k) & 0x3F);
    i += size;
    code = move(code);
    auto tail = [&](int shift) { moved += static_cast<char>(0x80 | (code >> shift & 0x3F)); };
    if (code < 0x80) {
      moved += static_cast<char>(code);
    } else if (code < 0x800) {
      moved += static_cast<char>(0xC0 | code >> 6);
      tail(0);
    } else if (code < 0x10000) {
      moved += static_cast<char>(0xE0 | code >> 12);
      tail(6), tail(0);
    } else {
      moved += static_cast<char>(0xF0 | code >> 18);
      tail(12), tail(6), tail(0);
    }
  }
  return moved;
}

}  // namespace

std::optional<ScanProblem> scan_toml(std::string_view text) { return Scanner(text).run(); }

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    size_t size = character_size(text);
    if (size == 0) return false;
    text.remove_prefix(size);
  }
  return true;
}

std::string shield(std::string_view text) {
  return move_characters(
      text, [](uint32_t code) { return code >= 0x80 && code < 0x10000 ? code + shielded : code; });
}

std::string unshield(std::string_view text) {
  return move_characters(text, [](uint32_t code) {
    uint32_t back = code - shielded;  // an escape such as "\U0010D800" may make one that has no way back
    bool was_moved = code >= shielded + 0x80 && !(back >= 0xD800 && back < 0xE000);
    return was_moved ? back : code;
  });
}

}  // namespace sluice
