// A TOML document as a plain tree in which every value knows where it came from: a place in the file or a
// --set override. The passes (passes.hpp) work on it; only parse.cpp knows the parser.
#pragma once

#include <compare>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "sluice/error.hpp"

namespace sluice {

/// Order of appearance: the file from top to bottom, then the overrides as they were given.
struct SceneOrder {
  uint32_t set = 0;  ///< 0 in the file, else the number of the override, from 1
  uint32_t line = 0;
  uint32_t column = 0;
  auto operator<=>(const SceneOrder&) const = default;
};

struct SceneValue {
  enum class Kind { text, integer, number, boolean, date, array, table };
  struct Member;

  Kind kind = Kind::table;
  std::string text;
  int64_t integer = 0;
  double number = 0;  ///< also set for an integer
  bool boolean = false;
  std::vector<SceneValue> items;  ///< of an array
  std::vector<Member> members;    ///< of a table, in order of appearance

  std::string path;   ///< in this scene, "fluid.rect.0.min"; set by check_scene
  std::string where;  ///< "FILE:LINE:COLUMN" or "--set KEY"
  SceneOrder order;
  bool overridden = false;  ///< from --set
  bool defaulted = false;   ///< from the key table; `where` is then that of the table it was missing from

  bool is_number() const { return kind == Kind::integer || kind == Kind::number; }
  /// The member of a table with this name, or in tables below it ("iisph.omega"), or null; null too when
  /// this is no table.
  const SceneValue* find(std::string_view path_below) const;
  SceneValue* find(std::string_view path_below);
  /// The member that is known to be there: for a tree that check_scene has been through.
  const SceneValue& at(std::string_view path_below) const;
  /// Removes the member with this name, if there is one.
  void erase(std::string_view name);
};

struct SceneValue::Member {
  std::string name;
  std::string where;  ///< of the name
  SceneValue value;
};

/// Reads a whole TOML document. `file` stands in messages.
/// Throws InputError "FILE:LINE:COLUMN: what is wrong" when the text isn't TOML.
SceneValue parse_toml(std::string_view text, const std::string& file);

/// The VALUE of --set KEY=VALUE: TOML if it is that, else a bare string. `number` counts the overrides
/// from 1. Throws InputError when the text isn't UTF-8.
SceneValue parse_override_value(std::string_view text, const std::string& key, uint32_t number);

/// A value from the key table's own TOML text, placed where the table is in which it was missing.
SceneValue parse_default(std::string_view text, const SceneValue& table);

/// A value in a message: 3, 2.5, true, "text" (shortened when long), an array of 2, a table.
std::string describe(const SceneValue& value);

/// A message on one line: control characters are replaced by spaces.
std::string one_line(std::string text);

/// The error for a value, the first of those that take part in the mistake. It names the place of the first
/// that was overridden, else of the first that was written, else of the first.
InputError refusal(std::initializer_list<const SceneValue*> parts, const std::string& found,
                   const std::string& expected);

/// The error "WHERE: KEY: found FOUND, expected EXPECTED".
InputError refusal(const std::string& where, const std::string& key, const std::string& found,
                   const std::string& expected);

}  // namespace sluice
