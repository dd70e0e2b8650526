// The reader of length strings.
#include "core/scene/length.hpp"

#include <charconv>
#include <cmath>

namespace sluice {
namespace {

/// Takes a decimal number without sign from the front of `text`.
std::optional<double> take_number(std::string_view& text) {
  if (text.empty() || text.front() < '0' || text.front() > '9') return {};  // from_chars would take "inf" too
  double number = 0;
  auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || !std::isfinite(number)) return {};
  text.remove_prefix(static_cast<size_t>(end - text.data()));
  return number;
}

double take_sign(std::string_view& text, std::string_view signs) {
  if (text.empty() || signs.find(text.front()) == signs.npos) return 1;
  double sign = text.front() == '-' ? -1 : 1;
  text.remove_prefix(1);
  return sign;
}

}  // namespace

std::optional<LengthInSpacings> parse_length(std::string_view text) {
  double sign = take_sign(text, "-");
  std::optional<double> first = take_number(text);
  if (!first) return {};
  if (text.empty()) return LengthInSpacings{sign * *first, 0};
  if (text == "h") return LengthInSpacings{0, sign * *first};
  if (text.front() != '+' && text.front() != '-') return {};
  double second_sign = take_sign(text, "+-");
  std::optional<double> second = take_number(text);
  if (!second || text != "h") return {};
  return LengthInSpacings{sign * *first, second_sign * *second};
}

}  // namespace sluice
