// Validation of single values, driven by the key table.
#include "core/scene/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/scene/keys.hpp"
#include "core/scene/length.hpp"

namespace sluice {
namespace {

using Kind = SceneValue::Kind;

std::string join_path(std::string_view parent, std::string_view name) {
  return parent.empty() ? std::string(name) : fmt::format("{}.{}", parent, name);
}

const SceneKey* find_key(std::string_view section, std::string_view name) {
  for (const SceneKey& key : scene_keys())
    if (key.section() == section && key.name() == name) return &key;
  return nullptr;
}

const SceneSection* find_section(std::string_view parent, std::string_view name) {
  for (const SceneSection& section : scene_sections())
    if (section.parent() == parent && section.name() == name) return &section;
  return nullptr;
}

// ---- values

bool in_range(double number, const KeyRange& range) {
  if (!std::isfinite(number)) return false;
  bool low = range.low_excluded ? number > range.low : number >= range.low;
  bool high = range.high_excluded ? number < range.high : number <= range.high;
  return low && high;
}

bool is_choice(const SceneValue& value, std::span<const ChoiceInfo> choices) {
  return value.kind == Kind::text &&
         std::ranges::find(choices, value.text, &ChoiceInfo::name) != choices.end();
}

/// The range of a length is checked when the spacing is known.
bool is_length(const SceneValue& value) {
  return value.is_number() ? std::isfinite(value.number)
                           : value.kind == Kind::text && parse_length(value.text).has_value();
}

[[noreturn]] void refuse(const SceneValue& value, const std::string& path, std::string expected) {
  if (value.is_number() && !std::isfinite(value.number) && expected.starts_with("a "))
    expected.insert(2, "finite ");
  throw refusal(value.where, path, describe(value), expected);
}

void check_array(const SceneValue& value, const std::string& path, size_t least, size_t most,
                 const SceneKey& key) {
  if (value.kind != Kind::array || value.items.size() < least || value.items.size() > most)
    refuse(value, path, expectation(key));
}

/// Checks every element of an array value with `good`; the place and path of a bad one name the element.
void check_items(const SceneValue& value, const std::string& path, const std::string& expected,
                 const auto& good) {
  for (size_t i = 0; i < value.items.size(); ++i)
    if (!good(value.items[i])) refuse(value.items[i], fmt::format("{}.{}", path, i), expected);
}

void check_choices(const SceneValue& value, const std::string& path, const SceneKey& key) {
  check_array(value, path, 1, key.choices.size(), key);
  check_items(value, path, element_expectation(key),
              [&](const SceneValue& item) { return is_choice(item, key.choices); });
  for (size_t i = 0; i < value.items.size(); ++i)
    for (size_t before = 0; before < i; ++before)
      if (value.items[before].text == value.items[i].text)
        throw refusal(value.items[i].where, fmt::format("{}.{}", path, i),
                      describe(value.items[i]) + " a second time", "each name at most once");
}

/// Rows of a matrix or points of a polygon: pairs of numbers or of lengths.
void check_pairs(const SceneValue& value, const std::string& path, const SceneKey& key, const auto& good,
                 const std::string& expected) {
  for (size_t i = 0; i < value.items.size(); ++i) {
    const SceneValue& pair = value.items[i];
    std::string pair_path = fmt::format("{}.{}", path, i);
    if (pair.kind != Kind::array || pair.items.size() != 2) refuse(pair, pair_path, element_expectation(key));
    check_items(pair, pair_path, expected, good);
  }
}

void check_value(const SceneValue& value, const std::string& path, const SceneKey& key) {
  constexpr size_t many = 100'000;
  auto number = [&](const SceneValue& v) { return v.is_number() && in_range(v.number, key.range); };
  auto integer = [&](const SceneValue& v) {
    return v.kind == Kind::integer && in_range(v.number, key.range);
  };
  auto only_if = [&](bool good) {
    if (!good) refuse(value, path, expectation(key));
  };
  switch (key.type) {
    case KeyType::text: return only_if(value.kind == Kind::text);
    case KeyType::number: return only_if(number(value));
    case KeyType::integer: return only_if(integer(value));
    case KeyType::length: return only_if(is_length(value));
    case KeyType::choice: return only_if(is_choice(value, key.choices));
    case KeyType::choices: return check_choices(value, path, key);
    case KeyType::numbers:
      check_array(value, path, 2, 2, key);
      return check_items(value, path, element_expectation(key), number);
    case KeyType::integers:
      check_array(value, path, 2, 2, key);
      return check_items(value, path, element_expectation(key), integer);
    case KeyType::lengths:
      check_array(value, path, 2, 2, key);
      return check_items(value, path, element_expectation(key), is_length);
    case KeyType::matrix:
      check_array(value, path, 2, 2, key);
      return check_pairs(value, path, key, number, "a number");
    case KeyType::points:
      check_array(value, path, 3, many, key);
      return check_pairs(value, path, key, is_length, length_expectation());
  }
}

// ---- tables

void check_table(SceneValue& table, std::string_view section, const std::string& path);

void check_section(SceneValue& value, const SceneSection& section, const std::string& path) {
  if (!section.is_array()) {
    if (value.kind != Kind::table) refuse(value, path, fmt::format("a table [{}]", path));
    return check_table(value, section.path, path);
  }
  std::string expected = fmt::format("an array of tables, [[{}]]", path);
  if (value.kind != Kind::array) refuse(value, path, expected);
  for (size_t i = 0; i < value.items.size(); ++i) {
    std::string item_path = fmt::format("{}.{}", path, i);
    if (value.items[i].kind != Kind::table)
      refuse(value.items[i], item_path, fmt::format("a table [[{}]]", path));
    check_table(value.items[i], section.path, item_path);
  }
}

void add_missing_key(SceneValue& table, const SceneKey& key, const std::string& path) {
  if (key.fallback.empty() || table.find(key.name())) return;
  if (key.fallback == required_key)
    throw refusal(table.where, join_path(path, key.name()), "nothing", expectation(key));
  table.members.push_back({std::string(key.name()), table.where, parse_default(key.fallback, table)});
}

void add_missing_section(SceneValue& table, const SceneSection& section, const std::string& path) {
  if (section.presence == Presence::optional || table.find(section.name())) return;
  std::string full = join_path(path, section.name());
  if (section.presence == Presence::required)
    throw refusal(table.where, full, "nothing", fmt::format("a table [{}]", full));
  SceneValue made;
  made.where = table.where;
  made.order = table.order;
  made.defaulted = true;
  table.members.push_back({std::string(section.name()), table.where, std::move(made)});
  check_section(table.members.back().value, section, full);
}

/// `section` is the table's path in the key table ("fluid.rect[]"), `path` in this scene ("fluid.rect.0").
void check_table(SceneValue& table, std::string_view section, const std::string& path) {
  for (SceneValue::Member& member : table.members) {
    std::string member_path = join_path(path, member.name);
    if (const SceneKey* key = find_key(section, member.name)) {
      check_value(member.value, member_path, *key);
    } else if (const SceneSection* inner = find_section(section, member.name)) {
      check_section(member.value, *inner, member_path);
    } else {
      throw InputError(one_line(
          fmt::format("{}: {}: found an unknown key, expected one of the known keys; did you mean \"{}\"?",
                      member.where, member_path.substr(0, 200), nearest_key(section, member.name))));
    }
  }
  if (!section.empty())
    for (const SceneKey& key : scene_keys())
      if (key.section() == section) add_missing_key(table, key, path);
  for (const SceneSection& inner : scene_sections())
    if (inner.parent() == section) add_missing_section(table, inner, path);
}

}  // namespace

void check_scene(SceneValue& root) { check_table(root, "", ""); }

}  // namespace sluice
