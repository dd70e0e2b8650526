// The reader of length strings.
#include "core/scene/length.hpp"

#include <charconv>
#include <cmath>

namespace sluice {
namespace {

/// Takes a decimal number, which may have one of the signs, from the front of the text.
std::optional<double> take_number(std::string_view& text, std::string_view signs) {
  const bool negative = text.starts_with('-');
  if (!text.empty() && signs.find(text.front()) != signs.npos) text.remove_prefix(1);
  if (text.empty() || text.front() < '0' || text.front() > '9') return {};  // from_chars would take "inf" too
  double number = 0;
  auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || !std::isfinite(number)) return {};
  text.remove_prefix(static_cast<size_t>(end - text.data()));
  return negative ? -number : number;
}

}  // namespace

std::optional<LengthInSpacings> parse_length(std::string_view text) {
  const std::optional<double> first = take_number(text, "-");
  if (!first) return {};
  if (text.empty()) return LengthInSpacings{*first, 0};
  if (text == "h") return LengthInSpacings{0, *first};
  if (text.front() != '+' && text.front() != '-') return {};
  const std::optional<double> second = take_number(text, "+-");
  return second && text == "h" ? std::optional(LengthInSpacings{*first, *second}) : std::nullopt;
}

}  // namespace sluice
