// A scanner that knows of TOML only strings, comments and the points in keys; and the moving of characters.
#include "core/scene/scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

namespace sluice {
namespace {

constexpr int max_parts_of_key = 16;  // a scene needs four
constexpr char32_t shield = 0x100000;

/// Characters of UTF-8 text below `end`, up to the first that is not good.
std::u32string decode(std::string_view text, char32_t end) {
  constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};  // by size: none is longer than needed
  auto byte_at = [&](size_t i) { return i < text.size() ? static_cast<uint8_t>(text[i]) : uint8_t{0}; };
  std::u32string characters;
  for (size_t i = 0, size = 1; i < text.size(); i += size) {
    const auto ones = static_cast<size_t>(std::countl_one(byte_at(i)));
    if (ones == 1 || ones > 4) break;
    size = std::max(ones, size_t{1});
    char32_t c = byte_at(i) & 0xFFu >> ones;
    bool good = true;
    for (size_t k = 1; k < size; ++k) {
      good = good && (byte_at(i + k) & 0xC0) == 0x80;
      c = c << 6 | (byte_at(i + k) & 0x3F);
    }
    if (!good || c < least[size] || c >= end || (c >= 0xD800 && c < 0xE000)) break;
    characters += c;
  }
  return characters;
}

std::string encode(std::u32string_view characters) {
  std::string text;
  for (const char32_t c : characters) {
    const int tails = c < 0x80 ? 0 : c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
    const unsigned mark = tails == 0 ? 0 : 0xF80u >> tails;
    text += static_cast<char>(mark | c >> 6 * tails);
    for (int k = tails - 1; k >= 0; --k) text += static_cast<char>(0x80 | (c >> 6 * k & 0x3F));
  }
  return text;
}

/// Where a string that begins at `at` is over: behind the closing quotes, or at the end of the line that
/// should have them.
size_t end_of_string(std::u32string_view text, size_t at) {
  const char32_t mark = text[at];
  const bool multi = text.substr(at).starts_with(std::u32string(3, mark));
  const std::u32string quotes(multi ? 3 : 1, mark);
  for (at += quotes.size(); at < text.size() && (multi || text[at] != '\n');) {
    if (text.substr(at).starts_with(quotes)) {
      at += quotes.size();
      for (int i = 0; multi && i < 2 && text.substr(at).starts_with(mark); ++i) ++at;  // belong to the string
      return at;
    }
    at += mark == '"' && text[at] == '\\' ? 2 : 1;
  }
  return std::min(at, text.size());
}

/// Index of the point with which a key has too many parts, or the text's size.
size_t find_deep_key(std::u32string_view text) {
  int points = 0;  // since the last character that ends a key
  for (size_t at = 0; at < text.size();) {
    const char32_t c = text[at];
    if (c == '.' && ++points >= max_parts_of_key) return at;
    if (std::u32string_view(U"\n=,{}[]").find(c) != std::u32string_view::npos) points = 0;
    if (c == '#')
      at = std::min(text.find(U'\n', at), text.size());
    else
      at = c == '"' || c == '\'' ? end_of_string(text, at) : at + 1;
  }
  return text.size();
}

}  // namespace

ScannedToml scan_toml(std::string_view text) {
  std::u32string characters = decode(text, shield);
  ScannedToml scanned;
  scanned.utf8 = encode(characters).size() == text.size();
  const size_t at = find_deep_key(characters);
  if (at < characters.size())
    scanned.problem =
        fmt::format("found a key of more than {0} parts, expected at most {0}", max_parts_of_key);
  else if (!scanned.utf8)
    scanned.problem = "found bytes that are not UTF-8, expected TOML text";
  for (const char32_t c : std::u32string_view(characters).substr(0, at)) {
    scanned.line += c == '\n';
    scanned.column = c == '\n' ? 1 : scanned.column + 1;
  }
  for (char32_t& c : characters)
    if (c >= 0x80 && c < 0x10000) c += shield;
  scanned.shielded = encode(characters);
  return scanned;
}

std::string unshield(std::string_view text) {
  std::u32string characters = decode(text, 0x110000);
  for (char32_t& c : characters) {
    const char32_t back = c - shield;  // an escape such as "\U0010D800" may make one that has no way back
    if (c >= shield + 0x80 && !(back >= 0xD800 && back < 0xE000)) c = back;
  }
  return encode(characters);
}

}  // namespace sluice
