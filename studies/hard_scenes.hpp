// Scenes of the hard cases, as the text of scene files: made of a few parts, so that cases differ only in
// what they are about.
#pragma once

#include <fmt/format.h>

#include <string>

#include "sluice/scene.hpp"

namespace sluice::study {

/// A method with its settings: what a table calls it, the end of a case's name, and the [pressure] tables.
struct Method {
  std::string label, suffix, text;
};

Method iisph();                ///< the recommended settings
Method iisph_of_the_thesis();  ///< the defaults of the keys
/// With another pressure.iisph.tolerance.
Method at_tolerance(const Method& method, double tolerance);
/// With a source_weight of 0.1: compression is undone within some ten steps instead of one.
Method gentle(const Method& method);
Method ssph(double stiffness);
Method wcsph(double kappa);

/// The spacing of all hard cases, their gravity and a viscosity that suits both.
inline constexpr double h = 8, g = 9.81, usual_nu = 200;

/// What a scene is made of. Coordinates count from the lower left corner of the domain, which is at `origin`.
struct SceneParts {
  std::string title;
  Vec2 origin{};
  Vec2 size{};
  std::string fluid, boundary;  ///< tables of shapes, as the functions below make them
  std::string boundary_model = "mirror";
  double gravity = g;
  double nu = usual_nu;
  Method method = iisph();
  std::string time;
};

/// The scene file.
std::string scene_text(const SceneParts& parts);

/// A [[fluid.rect]] of `columns` by `rows` particles from `min` on; `origin` is that of the scene.
std::string block(Vec2 min, uint32_t columns, uint32_t rows, Vec2 velocity = {}, Vec2 origin = {});
/// The same, which shrinks to its middle within the time `within`.
std::string shrinking_block(Vec2 min, uint32_t columns, uint32_t rows, double within);
/// A [[boundary.container]] round the whole domain.
std::string container(const SceneParts& parts, uint32_t layers = 3, bool closed = false);

/// Time steps of one length, and such that follow the fluid.
std::string fixed(double dt, double duration);
std::string adaptive(double duration, double dt_max = 0.1, double dt_min = 1e-4, double cfl = 0.4);

/// A tank with three layers of walls that `columns` by `rows` particles fill.
SceneParts full_tank(const std::string& title, uint32_t columns, uint32_t rows, const Method& method);
/// The breaking dam of the thesis, 22 by 30 particles, in a tank so long.
SceneParts dam(const std::string& title, const Method& method, double length = 400, Vec2 origin = {});

}  // namespace sluice::study
