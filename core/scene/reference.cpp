// The key table in words: what a message expects, and the reference of scene files as Markdown.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/scene/keys.hpp"

namespace sluice {
namespace {

constexpr std::string_view introduction = R"(# Scene files

A scene is a [TOML](https://toml.io) file. This page lists every table and key it can hold. It is printed by
`sluice scenes --keys` from the table that also validates scene files; `scenes/template.toml` is an example to
start from.

- **Units** are the scene's own; the columns below say only how they combine. The scenes from [Hunkler 2022] use
  pixels and seconds, with a gravity of 9.81 pixels per second squared.
- **Numbers** are TOML integers or floats and must be finite. An integer must be written without a point.
- **Lengths** are numbers, or strings of the form `"a"`, `"bh"`, `"a+bh"` or `"a-bh"`, where a and b are numbers
  and h is the particle spacing: `"240+3h"` is 264 when h is 8. A point is an array of two lengths, x and y; y
  points up.
- **`[[...]]`** marks an array of tables: write one such table per shape, in any number. Shapes count in the order
  of the file, whatever their kind.
- A key without a default is *required*, or it may be left out when the column is empty.
- Every table is checked, whether it is used or not. A mistake is reported as
  `FILE:LINE:COLUMN: key: what was found, what was expected`, and nothing is run.
- `--set KEY=VALUE` on the command line replaces or adds any key before the check. VALUE is TOML, or else a string
  without quotes. Arrays are indexed from 0, and the index after the last appends:
  `--set 'fluid.rect.0.max=[200, "300+3h"]'`. Setting `time.dt` removes `time.cfl`, `time.dt_min`, `time.dt_max` and
  every method's own `dt`; setting `time.cfl` removes `time.dt` and every method's own `dt`. When both are set, the
  later one wins.

The works in brackets are listed in `docs/model.md`.
)";

std::string range_text(const KeyRange& range) {
  bool low = range.low > -std::numeric_limits<double>::infinity();
  bool high = range.high < std::numeric_limits<double>::infinity();
  if (low && high && !range.low_excluded && !range.high_excluded)
    return fmt::format(" from {} to {}", range.low, range.high);
  std::string text;
  if (low) text += fmt::format(" {} {}", range.low_excluded ? "greater than" : "of at least", range.low);
  if (low && high) text += " and";
  if (high) text += fmt::format(" {} {}", range.high_excluded ? "less than" : "at most", range.high);
  return text;
}

constexpr size_t many = 100'000;

// in the order of KeyType
constexpr std::array types{
    KeyTypeInfo{"string", "a string"},
    KeyTypeInfo{"number", "a number{0}"},
    KeyTypeInfo{"integer", "an integer{0}"},
    KeyTypeInfo{"length", R"(a length{0} (a number, "a", "bh", "a+bh" or "a-bh", with h the spacing))"},
    KeyTypeInfo{"[number, number]", "an array of two numbers", KeyType::number, 2, 2},
    KeyTypeInfo{"point", "an array of two lengths", KeyType::length, 2, 2},
    KeyTypeInfo{"[integer, integer]", "an array of two integers", KeyType::integer, 2, 2},
    KeyTypeInfo{"2 rows of 2 numbers", "two rows of two numbers, [[a, b], [c, d]]", KeyType::numbers, 2, 2},
    KeyTypeInfo{"3 or more points", "an array of three or more points [x, y]", KeyType::lengths, 3, many},
    KeyTypeInfo{"string", "{1}"},
    KeyTypeInfo{"strings", "an array of one or more of {2}, each at most once", KeyType::choice, 1, many},
    KeyTypeInfo{"table", "a table {3}"},
    KeyTypeInfo{"tables", "an array of tables, {3}", KeyType::table, 0, many},
};
static_assert(types.size() == size_t(KeyType::tables) + 1);

std::string allowed_text(const SceneKey& key) {
  std::string text;
  for (const ChoiceInfo& choice : key.choices)
    text += fmt::format("{}`\"{}\"`", text.empty() ? "" : ", ", choice.name);
  if (key.choices.empty()) text = range_text(key.range);
  for (std::string_view lead : {" ", "of "})  // " of at least 1" follows a noun elsewhere
    if (text.starts_with(lead)) text.erase(0, lead.size());
  return text;
}

/// What the key means, and each of its choices.
std::string meaning_text(const SceneKey& key) {
  std::string text(key.meaning);
  std::string_view between = " ";
  for (const ChoiceInfo& choice : key.choices) {
    text += fmt::format("{}\"{}\": {}", between, choice.name, choice.meaning);
    between = "; ";
  }
  return key.choices.empty() ? text : text + '.';
}

std::string default_text(const SceneKey& key) {
  if (key.fallback == required_key) return "*required*";
  return key.fallback.empty() ? "" : fmt::format("`{}`", key.fallback);
}

std::string section_text(const SceneKey& table) {
  std::string text = fmt::format("\n## {}\n\n{}{}\n\n", header(table),
                                 table.fallback == required_key ? "Required. " : "", table.meaning);
  text += "| key | type | unit | default | allowed | meaning |\n|---|---|---|---|---|---|\n";
  for (const SceneKey& key : scene_keys()) {
    if (key.section() != table.path) continue;
    text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", key.name(), type_info(key.type).name, key.unit,
                        default_text(key), allowed_text(key), meaning_text(key));
  }
  return text;
}

size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = std::exchange(row[0], i);
    for (size_t j = 1; j <= b.size(); ++j) {
      size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, substituted}));
    }
  }
  return row.back();
}

}  // namespace

std::string join_choices(std::span<const ChoiceInfo> choices, std::string_view last_word) {
  std::string text;
  for (size_t i = 0; i < choices.size(); ++i) {
    if (i > 0) text += i + 1 == choices.size() ? fmt::format(" {} ", last_word) : ", ";
    text += fmt::format("\"{}\"", choices[i].name);
  }
  return text;
}

const KeyTypeInfo& type_info(KeyType type) { return types.at(size_t(type)); }

std::string header(const SceneKey& table) {
  const std::string_view path = table.path.substr(0, table.path.find('['));
  return fmt::format(fmt::runtime(table.is_array_of_tables() ? "[[{}]]" : "[{}]"), path);
}

std::string expectation(const SceneKey& key, KeyType type) {
  return fmt::format(fmt::runtime(type_info(type).expectation), range_text(key.range),
                     join_choices(key.choices), join_choices(key.choices, "and"), header(key));
}

std::string nearest_key(std::string_view section, std::string_view unknown) {
  unknown = unknown.substr(0, 100);
  std::string nearest, elsewhere;
  size_t least = ~size_t{0};
  for (const SceneKey& row : scene_rows()) {
    size_t distance = edit_distance(unknown, row.name());
    if (row.section() == section && distance < least) least = distance, nearest = row.name();
    if (distance == 0 && elsewhere.empty()) elsewhere = row.path;
  }
  return least > 2 && !elsewhere.empty() ? elsewhere : nearest;
}

std::string key_reference() {
  std::string text(introduction);
  for (const SceneKey& table : scene_tables()) text += section_text(table);
  return text;
}

}  // namespace sluice
