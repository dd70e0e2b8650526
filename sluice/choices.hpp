// The choices of scenes, each declared once: an enum, and for each of its values the name that people write
// and what it means. Files, options, messages, documentation and shaders take them from here. Choices of the
// program's options only are declared in the same way where they belong.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sluice {

struct ChoiceInfo {
  std::string_view identifier;  ///< in C++ and in shaders
  std::string_view name;        ///< in files and options
  std::string_view meaning;     ///< to follow "NAME: "
};

/// The choices of an enum; its value number `first` is the first row's.
struct ChoiceTable {
  std::span<const ChoiceInfo> rows;
  uint32_t first = 0;
};

/// Whether every row says what it is called and what it means.
template <size_t count>
constexpr bool is_complete(const std::array<ChoiceInfo, count>& rows) {
  for (const ChoiceInfo& row : rows)
    if (row.name.empty() || row.meaning.empty()) return false;
  return true;
}

// clang-format off
#define SLUICE_CHOICE_ENUMERATOR(value, name, meaning) value,
#define SLUICE_CHOICE_ROW(value, name, meaning) ChoiceInfo{#value, name, meaning},
/// Declares an enum with these rows: CHOICE(value, name, meaning).
#define SLUICE_DECLARE_CHOICES(Enum, ROWS)                                                     \
  enum class Enum : uint32_t { ROWS(SLUICE_CHOICE_ENUMERATOR) };                               \
  inline constexpr auto Enum##_rows = std::to_array<ChoiceInfo>({ROWS(SLUICE_CHOICE_ROW)});    \
  static_assert(is_complete(Enum##_rows));                                                     \
  constexpr ChoiceTable choices_of(Enum) { return {Enum##_rows, 0}; }
/// Declares an enum with these rows after a value `none`, which nobody can write.
#define SLUICE_DECLARE_CHOICES_OR_NONE(Enum, ROWS)                                             \
  enum class Enum : uint32_t { none, ROWS(SLUICE_CHOICE_ENUMERATOR) };                         \
  inline constexpr auto Enum##_rows = std::to_array<ChoiceInfo>({ROWS(SLUICE_CHOICE_ROW)});    \
  static_assert(is_complete(Enum##_rows));                                                     \
  constexpr ChoiceTable choices_of(Enum) { return {Enum##_rows, 1}; }

#define SLUICE_BOUNDARY_MODELS(CHOICE)                                                                                 \
  CHOICE(mirror, "mirror", "samples of full mass with the pressure of the particle that looks at them [Hunkler 2022]") \
  CHOICE(akinci, "akinci", "samples weighted by their own spacing [Akinci et al. 2012]")
SLUICE_DECLARE_CHOICES_OR_NONE(BoundaryModel, SLUICE_BOUNDARY_MODELS)

#define SLUICE_VISCOSITY_MODELS(CHOICE)                                                                     \
  CHOICE(laplacian, "laplacian", "a discrete Laplacian of the velocity, also at walls [Hunkler 2022]")      \
  CHOICE(xsph, "xsph", "velocities smoothed over the neighbours, fluid only [WCSPH page]")
SLUICE_DECLARE_CHOICES_OR_NONE(ViscosityModel, SLUICE_VISCOSITY_MODELS)

#define SLUICE_PRESSURE_METHODS(CHOICE)                      \
  CHOICE(iisph, "iisph", "a linear system")                  \
  CHOICE(ssph, "ssph", "a linear state equation")            \
  CHOICE(wcsph, "wcsph", "Tait's state equation")
SLUICE_DECLARE_CHOICES(PressureMethod, SLUICE_PRESSURE_METHODS)

#define SLUICE_SOLVERS(CHOICE)                                                                                         \
  CHOICE(jacobi, "jacobi", "relaxed Jacobi steps, as in [Hunkler 2022]")                                               \
  CHOICE(barzilai_borwein, "barzilai-borwein", "steps of its own choice, and up to six times fewer of them")
SLUICE_DECLARE_CHOICES(Solver, SLUICE_SOLVERS)

#define SLUICE_WALLS(CHOICE)                                                                                    \
  CHOICE(thesis, "thesis", "as in [Hunkler 2022]")                                                              \
  CHOICE(symmetric, "symmetric", "counts twice in the divergence too, which makes the system symmetric")
SLUICE_DECLARE_CHOICES(Wall, SLUICE_WALLS)

#define SLUICE_STOPS(CHOICE)                                                                           \
  CHOICE(density, "density", "the mean density error")                                                 \
  CHOICE(residual, "residual", "the residual relative to the source, for which 1e-2 is tight")
SLUICE_DECLARE_CHOICES(Stop, SLUICE_STOPS)

#define SLUICE_COLOURS(CHOICE)                                             \
  CHOICE(speed, "speed", "how many spacings it moves in a step")           \
  CHOICE(density, "density", "density over rest density")                  \
  CHOICE(pressure, "pressure", "pressure")
SLUICE_DECLARE_CHOICES(Colour, SLUICE_COLOURS)

#define SLUICE_SIDES(CHOICE)                      \
  CHOICE(left, "left", "at `min` x")              \
  CHOICE(right, "right", "at `max` x")            \
  CHOICE(bottom, "bottom", "at `min` y")          \
  CHOICE(top, "top", "at `max` y")
SLUICE_DECLARE_CHOICES(Side, SLUICE_SIDES)

#define SLUICE_PRECISIONS(CHOICE)                                     \
  CHOICE(single_, "float", "32 bits a number")                        \
  CHOICE(double_, "double", "64 bits a number, on the CPU only")
SLUICE_DECLARE_CHOICES(Precision, SLUICE_PRECISIONS)
// clang-format on

/// The name that people write for a value; empty for `none`.
template <class Enum>
constexpr std::string_view name_of(Enum value) {
  const ChoiceTable table = choices_of(value);
  const auto number = static_cast<uint32_t>(value);
  return number < table.first ? std::string_view{} : table.rows[number - table.first].name;
}

/// The value with this name, if there is one.
template <class Enum>
constexpr std::optional<Enum> value_named(std::string_view name) {
  const ChoiceTable table = choices_of(Enum{});
  for (uint32_t i = 0; i < table.rows.size(); ++i)
    if (table.rows[i].name == name) return static_cast<Enum>(table.first + i);
  return std::nullopt;
}

/// Every value that has a name, in the order of the table.
template <class Enum>
std::vector<Enum> values_of() {
  const ChoiceTable table = choices_of(Enum{});
  std::vector<Enum> values;
  for (uint32_t i = 0; i < table.rows.size(); ++i) values.push_back(static_cast<Enum>(table.first + i));
  return values;
}

}  // namespace sluice
