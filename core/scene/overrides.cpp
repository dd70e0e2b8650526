// --set KEY=VALUE: changes to a scene made before it is checked.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "core/scene/passes.hpp"

namespace sluice {
namespace {

constexpr size_t max_parts = 16;

struct Override {
  std::string key;
  std::vector<std::string> parts;
  SceneValue value;
};

bool is_index(std::string_view part) {
  return !part.empty() && part.find_first_not_of("0123456789") == part.npos;
}

Override parse_override(const std::string& text, uint32_t number) {
  size_t equals = text.find('=');
  if (equals == text.npos || equals == 0)
    throw InputError(
        one_line(fmt::format("--set {}: found no KEY=VALUE, expected one such as time.dt=0.01", text)));
  Override made{text.substr(0, equals), {}, {}};
  for (size_t begin = 0; begin <= made.key.size();) {
    size_t end = std::min(made.key.find('.', begin), made.key.size());
    made.parts.push_back(made.key.substr(begin, end - begin));
    begin = end + 1;
  }
  if (std::ranges::find(made.parts, "") != made.parts.end() || made.parts.size() > max_parts)
    throw refusal("--set " + made.key, made.key, "no such key", "names and indices with points between them");
  made.value = parse_override_value(std::string_view(text).substr(equals + 1), made.key, number);
  return made;
}

/// The place for `part` inside `holder`, made when it is missing; `next` is the part after it, or empty.
SceneValue& step(SceneValue& holder, const Override& set, size_t index) {
  using Kind = SceneValue::Kind;
  const std::string& part = set.parts[index];
  std::string where = "--set " + set.key;
  SceneValue made;
  made.where = where;
  made.order = {set.value.order.set, 0, 0};
  made.overridden = true;
  if (index + 1 < set.parts.size() && is_index(set.parts[index + 1])) made.kind = Kind::array;

  if (holder.kind == Kind::table) {
    if (SceneValue* found = holder.find(part)) return *found;
    holder.members.push_back({part, where, std::move(made)});
    return holder.members.back().value;
  }
  std::string path = fmt::format("{}", fmt::join(set.parts.begin(), set.parts.begin() + long(index), "."));
  if (holder.kind != Kind::array) throw refusal(where, path, describe(holder), "a table");
  uint64_t at = holder.items.size() + 1;
  if (is_index(part)) std::from_chars(part.data(), part.data() + part.size(), at);
  if (at > holder.items.size())
    throw refusal(where, path, fmt::format("index \"{}\"", part),
                  holder.items.empty()
                      ? std::string("0, which appends")
                      : fmt::format("0 to {}, where {} appends", holder.items.size(), holder.items.size()));
  if (at == holder.items.size()) holder.items.push_back(std::move(made));
  return holder.items[at];
}

void apply(SceneValue& root, const Override& set) {
  SceneValue* place = &root;
  for (size_t i = 0; i < set.parts.size(); ++i) place = &step(*place, set, i);
  SceneOrder order = place->order;
  bool replaces = !place->where.empty() && place->kind == SceneValue::Kind::table;
  *place = set.value;
  if (replaces) place->order = order;  // a shape that is replaced keeps its place among the shapes
}

/// Whether this override gives time.`name` a value, by itself or with the whole table.
bool sets_time(const Override& set, std::string_view name) {
  if (set.parts.front() != "time") return false;
  if (set.parts.size() == 1) return set.value.find(name) != nullptr;
  return set.parts.size() == 2 && set.parts[1] == name;
}

void settle_time_step(SceneValue& root, std::span<const Override> sets) {
  std::optional<size_t> dt, cfl;
  for (size_t i = 0; i < sets.size(); ++i) {
    if (sets_time(sets[i], "dt")) dt = i;
    if (sets_time(sets[i], "cfl")) cfl = i;
  }
  if (!dt && !cfl) return;
  if (SceneValue* pressure = root.find("pressure"))
    for (SceneValue::Member& method : pressure->members) method.value.erase("dt");
  SceneValue* time = root.find("time");
  if (dt > cfl) {  // an empty optional is less than any
    for (const char* name : {"cfl", "dt_min", "dt_max"}) time->erase(name);
  } else if (cfl > dt) {
    time->erase("dt");
  }
}

}  // namespace

void apply_overrides(SceneValue& root, std::span<const std::string> overrides) {
  std::vector<Override> sets;
  for (const std::string& text : overrides) sets.push_back(parse_override(text, uint32_t(sets.size() + 1)));
  for (const Override& set : sets) apply(root, set);
  settle_time_step(root, sets);
}

}  // namespace sluice
