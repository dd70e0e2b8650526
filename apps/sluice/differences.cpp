// A walk through both at once.
#include "apps/sluice/differences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace sluice::app {
namespace {

using Json = nlohmann::ordered_json;

bool counts(const std::string& key) { return key != "output" && key != "scene" && key != "time.duration"; }

std::string text_of(const Json* value) {
  return value == nullptr ? "none" : value->dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// A member of an object or an element of an array, if it is there.
const Json* child(const Json& parent, const std::string& name, size_t place) {
  if (parent.is_array()) return place < parent.size() ? &parent[place] : nullptr;
  const auto found = parent.find(name);
  return found == parent.end() ? nullptr : &*found;
}

std::optional<Difference> differ(const std::string& key, const Json* before, const Json* now);

/// The children that `parent` has, looked up in both.
std::optional<Difference> differ_in(const std::string& key, const Json& parent, const Json& before,
                                    const Json& now) {
  size_t place = 0;
  for (const auto& [name, value] : parent.items()) {
    const std::string inner = key.empty() ? name : fmt::format("{}.{}", key, name);
    if (counts(inner)) {
      if (auto found = differ(inner, child(before, name, place), child(now, name, place))) return found;
    }
    ++place;
  }
  return std::nullopt;
}

/// Points and other lists of plain values are named whole, tables by what is in them.
bool is_tables(const Json& value) {
  return value.is_object() || (value.is_array() && !value.empty() &&
                               std::ranges::all_of(value, [](const Json& one) { return one.is_object(); }));
}

std::optional<Difference> differ(const std::string& key, const Json* before, const Json* now) {
  if (before != nullptr && now != nullptr && is_tables(*before) && is_tables(*now) &&
      before->type() == now->type()) {
    if (auto found = differ_in(key, *before, *before, *now)) return found;
    return differ_in(key, *now, *before, *now);
  }
  if (before != nullptr && now != nullptr && *before == *now) return std::nullopt;
  return Difference{key, text_of(before), text_of(now)};
}

}  // namespace

std::optional<Difference> first_difference(const Json& before, const Json& now) {
  return differ("", &before, &now);
}

}  // namespace sluice::app
