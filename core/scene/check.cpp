// Validation of single values, driven by the key table.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/scene/keys.hpp"
#include "core/scene/length.hpp"
#include "core/scene/passes.hpp"

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

/// The range of a length is checked when the spacing is known.
bool is_length(const SceneValue& value) {
  return value.is_number() ? std::isfinite(value.number)
                           : value.kind == Kind::text && parse_length(value.text).has_value();
}

/// Whether the value is good as far as its elements do not matter.
bool fits(const SceneValue& value, const SceneKey& key, KeyType type) {
  const size_t size = value.items.size();
  switch (type) {
    case KeyType::text: return value.kind == Kind::text;
    case KeyType::number: return value.is_number() && in_range(value.number, key.range);
    case KeyType::integer: return value.kind == Kind::integer && in_range(value.number, key.range);
    case KeyType::length: return is_length(value);
    case KeyType::choice:
      return value.kind == Kind::text && std::ranges::count(key.choices, value.text, &ChoiceInfo::name) > 0;
    case KeyType::choices:
      if (size > key.choices.size()) return false;
      [[fallthrough]];
    default:
      return value.kind == Kind::array && size >= type_info(type).least && size <= type_info(type).most;
  }
}

void check_value(SceneValue& value, const SceneKey& key, KeyType type) {
  if (!fits(value, key, type)) {
    std::string expected = expectation(key, type);
    if (value.is_number() && !std::isfinite(value.number) && expected.starts_with("a "))
      expected.insert(2, "finite ");
    throw refusal({&value}, describe(value), expected);
  }
  if (!type_info(type).is_array()) return;
  for (size_t i = 0; i < value.items.size(); ++i) {
    value.items[i].path = fmt::format("{}.{}", value.path, i);
    check_value(value.items[i], key, type_info(type).element);
  }
  if (type != KeyType::choices) return;
  for (auto item = value.items.begin(); item != value.items.end(); ++item)
    if (std::ranges::count(value.items.begin(), item, item->text, &SceneValue::text) > 0)
      throw refusal({&*item}, describe(*item) + " a second time", "each name at most once");
}

// ---- tables

void expect(const SceneValue& value, Kind kind, const std::string& expected) {
  if (value.kind != kind) throw refusal({&value}, describe(value), expected);
}

void check_table(SceneValue& table, std::string_view section);

void check_section(SceneValue& value, const SceneSection& section) {
  if (!section.is_array()) {
    expect(value, Kind::table, fmt::format("a table [{}]", value.path));
    return check_table(value, section.path);
  }
  expect(value, Kind::array, fmt::format("an array of tables, [[{}]]", value.path));
  for (size_t i = 0; i < value.items.size(); ++i) {
    value.items[i].path = fmt::format("{}.{}", value.path, i);
    expect(value.items[i], Kind::table, fmt::format("a table [[{}]]", value.path));
    check_table(value.items[i], section.path);
  }
}

/// The new member of a table that was missing there.
SceneValue& add(SceneValue& table, std::string_view name, SceneValue value) {
  value.path = join_path(table.path, name);
  value.where = table.where;
  value.order = table.order;
  value.defaulted = true;
  return table.members.emplace_back(std::string(name), table.where, std::move(value)).value;
}

void add_missing(SceneValue& table, const SceneKey& key) {
  if (key.fallback.empty() || table.find(key.name())) return;
  if (key.fallback == required_key)
    throw refusal(table.where, join_path(table.path, key.name()), "nothing", expectation(key));
  add(table, key.name(), parse_default(key.fallback, table));
}

void add_missing(SceneValue& table, const SceneSection& section) {
  if (section.presence == Presence::optional || table.find(section.name())) return;
  std::string path = join_path(table.path, section.name());
  if (section.presence == Presence::required)
    throw refusal(table.where, path, "nothing", fmt::format("a table [{}]", path));
  check_section(add(table, section.name(), {}), section);
}

/// `section` is the table's path in the key table ("fluid.rect[]").
void check_table(SceneValue& table, std::string_view section) {
  for (SceneValue::Member& member : table.members) {
    SceneValue& value = member.value;
    value.path = join_path(table.path, member.name);
    if (const SceneKey* key = find_key(section, member.name)) {
      check_value(value, *key, key->type);
    } else if (const SceneSection* inner = find_section(section, member.name)) {
      check_section(value, *inner);
    } else {
      throw refusal(
          member.where, value.path.substr(0, 200), "an unknown key",
          fmt::format("one of the known keys; did you mean \"{}\"?", nearest_key(section, member.name)));
    }
  }
  for (const SceneKey& key : scene_keys())
    if (key.section() == section) add_missing(table, key);
  for (const SceneSection& inner : scene_sections())
    if (inner.parent() == section) add_missing(table, inner);
}

}  // namespace

void check_scene(SceneValue& root) { check_table(root, ""); }

}  // namespace sluice
