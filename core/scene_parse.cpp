// TOML text to SceneValue. The one place that includes toml++.
#include "core/scene_tree.hpp"

// The parser reports bad text as an error, but before some of these reports it asserts that they aren't
// needed: in a debug build "[+" would end the program, and in others a compiler may take the assertion for a
// fact. So its assertions are switched off in every build.
// clang-format off
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(condition) static_assert(true)
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")
// clang-format on

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace sluice {
namespace {

// A scene needs three. The parser itself recurses without bound over a.a.a.a..., and so does the destructor.
constexpr int max_parts_of_key = 16;

using Locate = std::function<std::string(const toml::source_position&)>;

struct Origin {
  Locate locate;
  uint32_t set = 0;
};

SceneValue convert(const toml::node& node, const Origin& origin) {
  SceneValue value;
  toml::source_position begin = node.source().begin;
  value.where = origin.locate(begin);
  value.order = {origin.set, begin.line, begin.column};
  value.overridden = origin.set > 0;
  using Kind = SceneValue::Kind;
  if (const toml::table* table = node.as_table()) {
    for (auto&& [key, child] : *table)
      value.members.push_back(
          {std::string(key.str()), origin.locate(key.source().begin), convert(child, origin)});
    std::ranges::stable_sort(value.members, {}, [](const auto& member) { return member.value.order; });
  } else if (const toml::array* array = node.as_array()) {
    value.kind = Kind::array;
    for (const toml::node& child : *array) value.items.push_back(convert(child, origin));
  } else if (auto text = node.as_string()) {
    value.kind = Kind::text;
    value.text = text->get();
  } else if (auto integer = node.as_integer()) {
    value.kind = Kind::integer;
    value.integer = integer->get();
    value.number = static_cast<double>(value.integer);
  } else if (auto number = node.as_floating_point()) {
    value.kind = Kind::number;
    value.number = number->get();
  } else if (auto boolean = node.as_boolean()) {
    value.kind = Kind::boolean;
    value.boolean = boolean->get();
  } else {
    value.kind = Kind::date;
  }
  return value;
}

/// Walks over the text, strings and comments skipped, and refuses a key with too many dots.
void refuse_deep_keys(std::string_view text, const Locate& locate) {
  toml::source_position at{1, 1};
  int dots = 0;
  std::string_view quote;  // the quotes that end the string we are in
  bool comment = false;
  for (size_t i = 0; i < text.size(); ++i) {
    char c = text[i];
    std::string_view rest = text.substr(i);
    size_t length = 1;
    if (comment) {
      comment = c != '\n';
    } else if (!quote.empty()) {
      if (c == '\\' && quote.front() == '"') {
        length = std::min<size_t>(2, rest.size());
      } else if (rest.starts_with(quote) || (quote.size() == 1 && c == '\n')) {
        length = c == '\n' ? 1 : quote.size();
        quote = {};
      }
    } else if (c == '"' || c == '\'') {
      quote = rest.substr(0, rest.starts_with("\"\"\"") || rest.starts_with("'''") ? 3 : 1);
      length = quote.size();
    } else if (c == '#') {
      comment = true;
    } else if (c == '.' && ++dots >= max_parts_of_key) {
      throw InputError(fmt::format("{}: found a key of more than {} parts, expected at most {}", locate(at),
                                   max_parts_of_key, max_parts_of_key));
    } else if (std::string_view("\n=,{}[]").find(c) != std::string_view::npos) {
      dots = 0;
    }
    for (char passed : text.substr(i, length)) {
      if (passed == '\n')
        ++at.line, at.column = 1;
      else if ((static_cast<unsigned char>(passed) & 0xC0) != 0x80)
        ++at.column;
    }
    i += length - 1;
  }
}

bool is_utf8(std::string_view text) {
  for (size_t i = 0; i < text.size();) {
    auto byte = [&](size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u; };
    unsigned first = byte(i);
    size_t more = first < 0x80 ? 0 : first >= 0xC2 && first < 0xE0 ? 1 : (first & 0xF0) == 0xE0 ? 2 : 3;
    if (more == 3 && (first < 0xF0 || first > 0xF4)) return false;
    for (size_t k = 1; k <= more; ++k)
      if ((byte(i + k) & 0xC0) != 0x80) return false;
    unsigned second = byte(i + 1);
    if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
        (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F))
      return false;
    i += 1 + more;
  }
  return true;
}

}  // namespace

SceneValue parse_toml(std::string_view text, const std::string& file) {
  Locate locate = [&](const toml::source_position& at) {
    return fmt::format("{}:{}:{}", file, std::max(at.line, 1u), std::max(at.column, 1u));
  };
  refuse_deep_keys(text, locate);
  try {
    SceneValue root = convert(toml::parse(text), {locate, 0});
    root.where = locate({1, 1});
    return root;
  } catch (const toml::parse_error& error) {
    throw InputError(one_line(fmt::format("{}: {}", locate(error.source().begin), error.description())));
  }
}

SceneValue parse_override_value(std::string_view text, const std::string& key, uint32_t number) {
  std::string where = "--set " + key;
  Locate locate = [&](const toml::source_position&) { return where; };
  std::string line = fmt::format("value = {}", text);
  try {
    refuse_deep_keys(line, locate);
    SceneValue root = convert(toml::parse(line), {locate, number});
    if (root.members.size() == 1) return std::move(root.members.front().value);
  } catch (const toml::parse_error&) {  // a bare string, then
  } catch (const InputError&) {         // as well
  }
  if (!is_utf8(text))
    throw InputError(one_line(where + ": found text that is not UTF-8, expected KEY=VALUE in UTF-8"));
  SceneValue value;
  value.kind = SceneValue::Kind::text;
  value.text = text;
  value.where = where;
  value.order.set = number;
  value.overridden = true;
  return value;
}

SceneValue parse_default(std::string_view text, const SceneValue& table) {
  Locate locate = [&](const toml::source_position&) { return table.where; };
  SceneValue root = convert(toml::parse(fmt::format("value = {}", text)), {locate, 0});
  SceneValue value = std::move(root.members.front().value);
  value.order = table.order;
  value.overridden = false;
  value.defaulted = true;
  return value;
}

}  // namespace sluice
