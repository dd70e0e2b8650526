// The tree's own functions, and the words of messages.
#include "core/scene/tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace sluice {

const SceneValue* SceneValue::find(std::string_view path_below) const {
  const size_t point = path_below.find('.');
  auto member = std::ranges::find(members, path_below.substr(0, point), &Member::name);
  if (member == members.end()) return nullptr;
  return point == path_below.npos ? &member->value : member->value.find(path_below.substr(point + 1));
}

SceneValue* SceneValue::find(std::string_view path_below) {
  return const_cast<SceneValue*>(std::as_const(*this).find(path_below));
}

const SceneValue& SceneValue::at(std::string_view path_below) const {
  const SceneValue* value = find(path_below);
  if (!value) throw std::logic_error(fmt::format("the scene tree has no \"{}\" here", path_below));
  return *value;
}

void SceneValue::erase(std::string_view name) {
  std::erase_if(members, [&](const Member& member) { return member.name == name; });
}

std::string describe(const SceneValue& value) {
  switch (value.kind) {
    case SceneValue::Kind::integer: return fmt::format("{}", value.integer);
    case SceneValue::Kind::number: {
      std::string text = fmt::format("{}", value.number);
      return text.find_first_not_of("-0123456789") == text.npos ? text + ".0" : text;
    }
    case SceneValue::Kind::boolean: return value.boolean ? "true" : "false";
    case SceneValue::Kind::date: return "a date or time";
    case SceneValue::Kind::array: return fmt::format("an array of {}", value.items.size());
    case SceneValue::Kind::table: return "a table";
    case SceneValue::Kind::text: break;
  }
  constexpr size_t shown = 60;
  if (value.text.size() <= shown) return fmt::format("\"{}\"", value.text);
  size_t end = shown;
  while (end > 0 && (static_cast<unsigned char>(value.text[end]) & 0xC0) == 0x80)
    --end;  // not inside a character
  return fmt::format("\"{}...\"", value.text.substr(0, end));
}

std::string one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  return text;
}

InputError refusal(std::initializer_list<const SceneValue*> parts, const std::string& found,
                   const std::string& expected) {
  auto blamed = std::ranges::find_if(parts, &SceneValue::overridden);
  if (blamed == parts.end()) blamed = std::ranges::find(parts, false, &SceneValue::defaulted);
  if (blamed == parts.end()) blamed = parts.begin();
  return refusal((*blamed)->where, (*parts.begin())->path, found, expected);
}

InputError refusal(const std::string& where, const std::string& key, const std::string& found,
                   const std::string& expected) {
  return InputError(one_line(fmt::format("{}: {}: found {}, expected {}", where, key, found, expected)));
}

}  // namespace sluice
