// TOML text to SceneValue. The one place that includes toml++.
#include "core/scene/scan.hpp"
#include "core/scene/tree.hpp"

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
#include <utility>

namespace sluice {
namespace {

/// Where values come from: a file, in which they have places, or something else with a name.
struct Origin {
  std::string name;
  bool file = false;
  uint32_t set = 0;

  std::string where(toml::source_position at) const {
    return file ? fmt::format("{}:{}:{}", name, std::max(at.line, 1u), std::max(at.column, 1u)) : name;
  }
};

SceneValue convert(const toml::node& node, const Origin& origin) {
  SceneValue value;
  toml::source_position begin = node.source().begin;
  value.where = origin.where(begin);
  value.order = {origin.set, begin.line, begin.column};
  value.overridden = origin.set > 0;
  using Kind = SceneValue::Kind;
  if (const toml::table* table = node.as_table()) {
    for (auto&& [key, child] : *table)
      value.members.push_back(
          {unshield(key.str()), origin.where(key.source().begin), convert(child, origin)});
    std::ranges::stable_sort(value.members, {}, [](const auto& member) { return member.value.order; });
  } else if (const toml::array* array = node.as_array()) {
    value.kind = Kind::array;
    for (const toml::node& child : *array) value.items.push_back(convert(child, origin));
  } else if (auto text = node.as_string()) {
    value.kind = Kind::text;
    value.text = unshield(text->get());
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

}  // namespace

SceneValue parse_toml(std::string_view text, const std::string& file) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark takes no column
  const Origin origin{one_line(file), true};
  const ScannedToml scanned = scan_toml(text);
  if (!scanned.problem.empty())
    throw InputError(fmt::format("{}: {}", origin.where({scanned.line, scanned.column}), scanned.problem));
  try {
    SceneValue root = convert(toml::parse(scanned.shielded), origin);
    root.where = origin.where({1, 1});
    return root;
  } catch (const toml::parse_error& error) {
    throw InputError(
        one_line(fmt::format("{}: {}", origin.where(error.source().begin), unshield(error.description()))));
  }
}

SceneValue parse_override_value(std::string_view text, const std::string& key, uint32_t number) {
  const Origin origin{"--set " + key, false, number};
  const ScannedToml scanned = scan_toml(fmt::format("value = {}", text));
  if (scanned.problem.empty()) {
    try {
      SceneValue root = convert(toml::parse(scanned.shielded), origin);
      if (root.members.size() == 1) return std::move(root.members.front().value);
    } catch (const toml::parse_error&) {  // a bare string, then
    }
  }
  if (!scanned.utf8)
    throw InputError(one_line(origin.name + ": found text that is not UTF-8, expected KEY=VALUE in UTF-8"));
  return convert(toml::value<std::string>(std::string(text)), origin);
}

SceneValue parse_default(std::string_view text, const SceneValue& table) {
  SceneValue root = convert(toml::parse(fmt::format("value = {}", text)), {table.where});
  SceneValue value = std::move(root.members.front().value);
  value.order = table.order;
  value.defaulted = true;
  return value;
}

}  // namespace sluice
