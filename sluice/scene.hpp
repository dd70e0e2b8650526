// A scene: what is simulated, with which models, for how long. Made by load_scene (sluice/load.hpp) from
// a TOML file, whole and validated, and never changed afterwards. Lengths and times are in the scene's own
// units.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sluice/choices.hpp"

namespace sluice {

using Vec2 = glm::dvec2;

/// Samples min + (i, j) h with i < count.x and j < count.y; `layers` keeps only that many outer ones (0:
/// all).
struct Rect {
  Vec2 min{};
  glm::uvec2 count{};
  uint32_t layers = 0;
};

/// Lattice through the centre, strictly inside the circle.
struct Disc {
  Vec2 centre{};
  double radius = 0;
};

/// Lattice through the first point, strictly inside the closed polygon.
struct Polygon {
  std::vector<Vec2> points;
};

/// Particles one by one, as a file has them.
struct Points {
  std::vector<Vec2> at, velocity;  ///< as many of both
};

/// Walls of an axis-parallel box, `layers` samples thick from each named wall inward.
struct Container {
  Vec2 min{};
  Vec2 max{};
  uint32_t layers = 3;
  bool left = false, right = false, bottom = false, top = false;
};

/// A straight wall: samples every h along from -> to, further layers to the right of that direction.
struct Segment {
  Vec2 from{};
  Vec2 to{};
  uint32_t layers = 3;
};

/// One table of [[fluid.*]]; `key` is its place in the scene ("fluid.rect.0"), `where` its FILE:LINE:COLUMN.
struct FluidShape {
  std::variant<Rect, Disc, Polygon, Points> geometry;
  Vec2 velocity{};
  glm::dmat2 velocity_gradient{0.0};  ///< G in v += G (x - centre of the shape); column-major as in GLM
  std::string key, where;
};

/// One table of [[boundary.*]]; `key` and `where` as for FluidShape.
struct BoundaryShape {
  std::variant<Rect, Disc, Polygon, Container, Segment> geometry;
  std::string key, where;
  std::string name;  ///< that the scene gives it; may be empty
};

/// One table of [[probe]]: a point, or a line x = const or y = const; one of the three is there.
struct Probe {
  std::string name;
  std::optional<Vec2> at;
  std::optional<double> x, y;
};

struct Ssph {
  double stiffness = 0;  ///< k
};

struct Wcsph {
  double kappa = 0;
  double gamma = 7;
};

struct Iisph {
  double tolerance = 1e-3;
  uint32_t min_iterations = 2;
  uint32_t max_iterations = 1000;
  double omega = 0.5;
  double warm_start = 0.5;
  double source_weight = 1;
  Solver solver = Solver::jacobi;
  Wall wall = Wall::thesis;  ///< of a mirror boundary
  Stop stop = Stop::density;
};

/// Time steps that follow the fluid.
struct AdaptiveStep {
  double cfl = 0;  ///< spacings that a particle may move in a step
  double dt_min = 0, dt_max = 0;
};

/// What a run says of its scene, and another run can be made from.
struct SceneRecord {
  std::string text;                    ///< what was in the file
  std::vector<std::string> overrides;  ///< KEY=VALUE changes that were made to it
  std::string settings;                ///< core/scene/settings.hpp reads it
};

struct Scene {
  std::string name;  ///< file name without folder and ending
  std::string file;  ///< as it was given or found, for messages
  std::string title;
  std::string source;

  double spacing = 0;    ///< h
  double smoothing = 1;  ///< H/h
  double rest_density = 0;

  Vec2 domain_min{}, domain_max{};

  Vec2 gravity{};
  double central_force = 0;  ///< c in a = -c (x - centre)
  Vec2 centre{};
  double jitter = 0;  ///< in units of h
  uint64_t seed = 0;
  uint32_t relax = 0;  ///< projections of the positions on the density before the first step
  std::vector<FluidShape> fluid;

  BoundaryModel boundary_model = BoundaryModel::none;
  std::vector<BoundaryShape> boundary;

  std::vector<Probe> probes;

  ViscosityModel viscosity_model = ViscosityModel::none;
  double viscosity = 0;  ///< nu (laplacian) or alpha (xsph)

  PressureMethod method = PressureMethod::iisph;
  std::optional<Ssph> ssph;
  std::optional<Wcsph> wcsph;
  Iisph iisph;

  double dt = 0;       ///< already that of the chosen method; dt_max where it adapts
  std::string dt_key;  ///< of the smallest step: "time.dt", "pressure.iisph.dt", "time.dt_min"
  std::optional<AdaptiveStep> adaptive;  ///< with time.cfl
  double duration = 0;

  double fps = 25;
  glm::uvec2 image_size{};
  Colour colour = Colour::speed;

  std::string
      spacing_where;  ///< FILE:LINE:COLUMN of particles.spacing, for "needs more memory than there is"
  SceneRecord record;

  double smoothing_length() const { return smoothing * spacing; }   ///< H
  double mass() const { return rest_density * spacing * spacing; }  ///< m = rho0 h^2
};

}  // namespace sluice
