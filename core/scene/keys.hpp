// The table of everything a scene file can say: one row per key and per table. It is pure data;
// validation (check.cpp), the defaults, the settings of a run and docs/scene_keys.md are all made from it.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "sluice/choices.hpp"

namespace sluice {

/// What a key's value looks like in TOML; rows of `type_info`.
enum class KeyType {
  text,
  number,  ///< integer or float
  integer,
  length,    ///< number or a string such as "240+3h"
  numbers,   ///< [x, y]
  lengths,   ///< [x, y]
  integers,  ///< [x, y]
  matrix,    ///< [[a, b], [c, d]], rows of numbers
  points,    ///< [[x, y], [x, y], [x, y], ...]
  choice,    ///< one of the names in `choices`
  choices,   ///< array of names in `choices`, each at most once
  table,
  tables  ///< array of tables
};

struct KeyTypeInfo {
  std::string_view name;         ///< in the reference
  std::string_view expectation;  ///< to follow "expected"; {0} is the range, {1} and {2} the choices (or,
                                 ///< and), {3} the header
  KeyType element = {};          ///< of an array
  size_t least = 0, most = 0;    ///< elements; 0 at most: no array

  bool is_array() const { return most > 0; }
};

const KeyTypeInfo& type_info(KeyType type);

/// Bounds of a number, or of every number in an array. Infinite bounds are none.
struct KeyRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_excluded = false;
  bool high_excluded = false;
};

/// The fallback of a key that has none and must be given.
inline constexpr std::string_view required_key = "required";

struct Scene;
struct SceneValue;

/// A key, or a table that holds keys.
struct SceneKey {
  std::string_view path;  ///< section and name, arrays of tables marked: "fluid.rect[].min", "fluid.rect[]"
  KeyType type;
  std::string_view unit;      ///< in the scene's own units; empty: a pure number or no number
  std::string_view fallback;  ///< default as TOML text, `required_key`, or empty: has none, may be absent
  std::string_view meaning;   ///< one line of Markdown
  KeyRange range = {};
  std::span<const ChoiceInfo> choices = {};  ///< that there are; their meanings follow that of the key
  void (*read)(const SceneValue&, Scene&) = nullptr;  ///< puts a checked value into its member of the Scene

  bool is_array_of_tables() const { return type == KeyType::tables; }
  /// Path of the table that holds this; empty for a table at the top of the file.
  std::string_view section() const {
    return path.substr(0, path.find('.') == path.npos ? 0 : path.rfind('.'));
  }
  /// Last part of the path, without brackets.
  std::string_view name() const {
    std::string_view last = path.substr(path.rfind('.') + 1);
    return last.substr(0, last.find('['));
  }
};

/// All keys, grouped by section, in the order of the documentation and of Scene::settings.
std::span<const SceneKey> scene_keys();

/// All tables; a table comes before the tables inside it.
std::span<const SceneKey> scene_tables();

/// All keys and then all tables.
std::span<const SceneKey> scene_rows();

/// A table's header in a file: "[pressure.iisph]", "[[fluid.rect]]".
std::string header(const SceneKey& table);

/// What a value of this key has to be, to follow "expected": "a number greater than 0". `type` may be that of
/// the key's elements instead.
std::string expectation(const SceneKey& key, KeyType type);
inline std::string expectation(const SceneKey& key) { return expectation(key, key.type); }

/// Names as a list in a sentence: "a", "b" or "c", quoted.
std::string join_choices(std::span<const ChoiceInfo> choices, std::string_view last_word = "or");

/// The known name nearest to an unknown one in the table `section` (a path as in SceneKey, empty for the
/// top): of the same table if one is close, else the full path of a key or table of this very name elsewhere,
/// else whatever is least far in the same table.
std::string nearest_key(std::string_view section, std::string_view unknown);

/// The reference of scene files as Markdown: docs/scene_keys.md, and the output of `sluice scenes --keys`.
std::string key_reference();

}  // namespace sluice
