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

std::string join_path(std::string_view parent, std::string_view name) {
  return parent.empty() ? std::string(name) : fmt::format("{}.{}", parent, name);
}

bool in_range(double number, const KeyRange& range) {
  if (!std::isfinite(number)) return false;
  bool low = range.low_excluded ? number > range.low : number >= range.low;
  bool high = range.high_excluded ? number < range.high : number <= range.high;
  return low && high;
}

/// The range of a length is checked when the spacing is known.
bool is_length(const SceneValue& value) {
  return value.is_number() ? std::isfinite(value.number)
                           : value.kind == SceneValue::Kind::text && parse_length(value.text).has_value();
}

/// Whether the value is good as far as its elements do not matter.
bool fits(const SceneValue& value, const SceneKey& key, KeyType type) {
  const size_t size = value.items.size();
  switch (type) {
    case KeyType::text: return value.kind == SceneValue::Kind::text;
    case KeyType::number: return value.is_number() && in_range(value.number, key.range);
    case KeyType::integer:
      return value.kind == SceneValue::Kind::integer && in_range(value.number, key.range);
    case KeyType::length: return is_length(value);
    case KeyType::table: return value.kind == SceneValue::Kind::table;
    case KeyType::choice:
      return value.kind == SceneValue::Kind::text &&
             std::ranges::count(key.choices, value.text, &ChoiceInfo::name) > 0;
    case KeyType::choices:
      if (size > key.choices.size()) return false;
      [[fallthrough]];
    default:
      return value.kind == SceneValue::Kind::array && size >= type_info(type).least &&
             size <= type_info(type).most;
  }
}

void check_table(SceneValue& table, std::string_view section);

/// Checks a value and what is in it against the key, of whose elements `type` may be.
void check_value(SceneValue& value, const SceneKey& key, KeyType type) {
  if (!fits(value, key, type)) {
    std::string expected = expectation(key, type);
    if (value.is_number() && !std::isfinite(value.number) && expected.starts_with("a "))
      expected.insert(2, "finite ");
    throw refusal({&value}, describe(value), expected);
  }
  if (type == KeyType::table) return check_table(value, key.path);
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

void add_missing(SceneValue& table, const SceneKey& key) {
  if (key.fallback.empty() || table.find(key.name())) return;
  std::string path = join_path(table.path, key.name());
  if (key.fallback == required_key) throw refusal(table.where, path, "nothing", expectation(key));
  table.members.push_back({std::string(key.name()), table.where, parse_default(key.fallback, table)});
  table.members.back().value.path = std::move(path);
  check_value(table.members.back().value, key, key.type);
}

/// Checks all that a table holds and lacks. `section` is the table's path in the key table ("fluid.rect[]").
void check_table(SceneValue& table, std::string_view section) {
  for (SceneValue::Member& member : table.members) {
    member.value.path = join_path(table.path, member.name);
    auto key = std::ranges::find_if(scene_rows(), [&](const SceneKey& row) {
      return row.section() == section && row.name() == member.name;
    });
    if (key == scene_rows().end())
      throw refusal(
          member.where, member.value.path.substr(0, 200), "an unknown key",
          fmt::format("one of the known keys; did you mean \"{}\"?", nearest_key(section, member.name)));
    check_value(member.value, *key, key->type);
  }
  for (const SceneKey& row : scene_rows())
    if (row.section() == section) add_missing(table, row);
}

}  // namespace

void check_scene(SceneValue& root) { check_table(root, ""); }

}  // namespace sluice
