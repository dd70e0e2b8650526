// Changes to TOML files.
#include <fmt/format.h>

#include <array>

#include "tests/support/mutation.hpp"

namespace sluice::test {
namespace {

using Texts = std::span<const std::string>;

// Extreme ones, and some that a scene may well have, so that part of the mutants is loaded.
constexpr std::array<std::string_view, 52> numbers{"0",
                                                   "-0",
                                                   "-0.0",
                                                   "1e308",
                                                   "-1e308",
                                                   "1.8e308",
                                                   "1e-308",
                                                   "5e-324",
                                                   "1e-400",
                                                   "nan",
                                                   "-nan",
                                                   "inf",
                                                   "-inf",
                                                   "1e30",
                                                   "-1e30",
                                                   "1e15",
                                                   "1e150",
                                                   "1e-150",
                                                   "1e17",
                                                   "9223372036854775807",
                                                   "-9223372036854775808",
                                                   "9223372036854775808",
                                                   "4294967295",
                                                   "4294967296",
                                                   "2147483648",
                                                   "1000000000",
                                                   "123456789012345678901234567890",
                                                   "0x7fffffffffffffff",
                                                   "0b1",
                                                   "1_000",
                                                   "1__0",
                                                   "01",
                                                   "\"1e308h\"",
                                                   "\"1e300+1e300h\"",
                                                   "\"-5h\"",
                                                   "\"nanh\"",
                                                   "\"3h-1e-9\"",
                                                   "true",
                                                   "1979-05-27",
                                                   "[]",
                                                   "{}",
                                                   "[1, 1]",
                                                   "1",
                                                   "2",
                                                   "-1",
                                                   "0.5",
                                                   "1.5",
                                                   "8",
                                                   "100",
                                                   "1e-9",
                                                   "1e6",
                                                   "7.25"};

bool is_in_number(char c) {
  return (c >= '0' && c <= '9') || std::string_view("+-.eE_").find(c) != std::string_view::npos;
}

size_t line_start(const std::string& text, size_t at) {
  const size_t end_before = at == 0 ? text.npos : text.rfind('\n', at - 1);
  return end_before == text.npos ? 0 : end_before + 1;
}

size_t line_end(const std::string& text, size_t at) {
  const size_t end = text.find('\n', at);
  return end == text.npos ? text.size() : end + 1;
}

struct Part {
  size_t begin = 0, end = 0;
};

Part some_line(const std::string& text, Dice& dice) {
  const size_t at = dice.below(text.size());
  return {line_start(text, at), line_end(text, at)};
}

/// A table: from a line that begins with a bracket to the next such line.
Part some_table(const std::string& text, Dice& dice) {
  const size_t at = dice.below(text.size());
  size_t begin = text.starts_with('[') ? 0 : text.size();
  if (const size_t found = text.rfind("\n[", at); found != text.npos) begin = found + 1;
  const size_t next = text.find("\n[", begin);
  return {begin, next == text.npos ? text.size() : next + 1};
}

using Choose = Part (*)(const std::string&, Dice&);

template <Choose choose>
void remove(std::string& text, Dice& dice, Texts) {
  const Part part = choose(text, dice);
  text.erase(part.begin, part.end - part.begin);
}

template <Choose choose>
void repeat(std::string& text, Dice& dice, Texts) {
  const Part part = choose(text, dice);
  const std::string repeated = text.substr(part.begin, part.end - part.begin);
  const size_t to = dice.one_in(2) ? part.end : choose(text, dice).begin;
  text.insert(std::min(to, text.size()), repeated);
}

template <Choose choose>
void move(std::string& text, Dice& dice, Texts) {
  const Part part = choose(text, dice);
  const std::string moved = text.substr(part.begin, part.end - part.begin);
  text.erase(part.begin, part.end - part.begin);
  text.insert(std::min(choose(text, dice).begin, text.size()), moved);
}

template <Choose choose>
void take(std::string& text, Dice& dice, Texts others) {
  const std::string& other = dice.of(others);
  const Part part = choose(other, dice);
  text.insert(std::min(choose(text, dice).begin, text.size()), other, part.begin, part.end - part.begin);
}

void misspell_key(std::string& text, Dice& dice, Texts) {
  const Part line = some_line(text, dice);
  const size_t equals = std::min(text.find('=', line.begin), line.end);
  const size_t at = line.begin + dice.below(equals - line.begin + 1);
  if (dice.one_in(2) && at < text.size()) {
    text.erase(at, 1);
  } else {
    text.insert(at, 1, static_cast<char>('a' + dice.below(26)));
  }
}

void rename_key(std::string& text, Dice& dice, Texts others) {
  const std::string& other = dice.of(others);
  const Part line = some_line(text, dice), from = some_line(other, dice);
  const size_t equals = text.find('=', line.begin), other_equals = other.find('=', from.begin);
  if (equals >= line.end || other_equals >= from.end) return;
  text.replace(line.begin, equals - line.begin, other.substr(from.begin, other_equals - from.begin));
}

/// Puts `value` in the place of some value, or of a part of one.
void put_value(std::string& text, Dice& dice, const std::string& value) {
  const Part line = some_line(text, dice);
  const size_t equals = text.find('=', line.begin);
  if (equals >= line.end) return;
  const size_t end = line.end > equals + 1 && text[line.end - 1] == '\n' ? line.end - 1 : line.end;
  const size_t begin = equals + 1 + dice.below(dice.one_in(2) ? 1 : end - equals - 1);
  text.replace(begin, end - begin, value);
}

void nest_deeply(std::string& text, Dice& dice, Texts) {
  static constexpr std::array<std::string_view, 5> openings{"[", "{a=", "[{a=", "a.", "[["};
  static constexpr std::array<std::string_view, 3> ends{"", "1", "]"};
  std::string nested;
  const std::string_view opening = openings[dice.below(openings.size())];
  for (size_t depth = 1 + dice.below(dice.one_in(4) ? 3000 : 40); depth > 0; --depth) nested += opening;
  nested += ends[dice.below(ends.size())];
  put_value(text, dice, nested);
}

void lengthen(std::string& text, Dice& dice, Texts) {
  static constexpr std::array<std::string_view, 6> letters{"x", "1", "é", "\\u00e9", "9.", " "};
  std::string longer;
  const std::string_view letter = letters[dice.below(letters.size())];
  for (size_t n = dice.below(dice.one_in(8) ? 30'000 : 300); n > 0; --n) longer += letter;
  put_value(text, dice, dice.one_in(2) ? fmt::format("\"{}\"", longer) : longer);
}

void break_utf8(std::string& text, Dice& dice, Texts) {
  static constexpr std::array<std::string_view, 8> bytes{
      "\xff", "\xc3", "\x80", "\xed\xa0\x80", "\xe2\x82", "\xf4\x90\x80\x80", "\xc0\x80", "\xef\xbb\xbf"};
  const std::string_view wrong = bytes[dice.below(bytes.size())];
  text.insert(dice.below(text.size() + 1), wrong);
}

void put_character(std::string& text, Dice& dice, Texts) {
  static constexpr std::array<std::string_view, 16> characters{
      "\"", "'", "\"\"\"", "'''", "[", "]", "{", "}", "=", ".", "\n", "#", ",", "\r", "\\", "\\U0010ffff"};
  const std::string_view put = characters[dice.below(characters.size())];
  text.insert(dice.below(text.size() + 1), put);
}

void change_bytes(std::string& text, Dice& dice, Texts others) {
  dice.of(byte_mutations())(text, dice, others);
}

}  // namespace

void replace_number(std::string& text, Dice& dice, Texts) {
  size_t begin = dice.below(text.size());
  while (begin < text.size() && !(text[begin] >= '0' && text[begin] <= '9')) ++begin;
  while (begin > 0 && begin < text.size() && is_in_number(text[begin - 1])) --begin;
  size_t end = begin;
  while (end < text.size() && is_in_number(text[end])) ++end;
  text.replace(begin, end - begin, numbers[dice.below(numbers.size())]);
}

std::span<const Mutation> scene_mutations() {
  static const std::array<Mutation, 20> all{
      replace_number,  replace_number,     replace_number,     replace_number,    replace_number,
      replace_number,  change_bytes,       misspell_key,       rename_key,        nest_deeply,
      lengthen,        break_utf8,         put_character,      remove<some_line>, repeat<some_line>,
      take<some_line>, remove<some_table>, repeat<some_table>, move<some_table>,  take<some_table>};
  return all;
}

}  // namespace sluice::test
