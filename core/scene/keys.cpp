// The rows of the key table. To add a key, add its row here: its value goes to the member of Scene that the
// row names. What is read by hand, with h, as a shape or by several keys together, has no member in its row.
#include "core/scene/keys.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

#include "core/scene/passes.hpp"

namespace sluice {
namespace {

using enum KeyType;

constexpr KeyRange positive{.low = 0, .low_excluded = true};
constexpr KeyRange not_negative{.low = 0};

constexpr KeyRange at_least(double low) { return {.low = low}; }
constexpr KeyRange from_to(double low, double high) { return {.low = low, .high = high}; }
constexpr KeyRange between(double low, double high) { return {low, high, true, true}; }
constexpr KeyRange above_to(double low, double high) { return {low, high, true, false}; }

/// A member of Scene, or of a member of it, which is made when it is optional.
template <auto member, auto... inner>
constexpr auto& place(auto& holder) {
  auto& here = holder.*member;
  if constexpr (sizeof...(inner) == 0)
    return here;
  else if constexpr (requires { here.has_value(); })
    return place<inner...>(here ? *here : here.emplace());
  else
    return place<inner...>(here);
}

template <class Value>
constexpr KeyType type_of = std::is_enum_v<Value>             ? choice
                            : std::is_integral_v<Value>       ? integer
                            : std::is_floating_point_v<Value> ? number
                            : std::is_same_v<Value, Vec2>     ? numbers
                                                              : text;

template <auto... members>
void read(const SceneValue& value, Scene& scene) {
  auto& to = place<members...>(scene);
  using Value = std::remove_reference_t<decltype(to)>;
  constexpr KeyType type = type_of<Value>;
  if constexpr (type == choice) to = value_named<Value>(value.text).value();
  if constexpr (type == integer) to = static_cast<Value>(value.integer);
  if constexpr (type == number) to = value.number;
  if constexpr (type == numbers) to = vector_of(value);
  if constexpr (type == text) to = value.text;
}

/// The row of a key whose value goes to a member of Scene, and has its type.
template <auto... members>
constexpr SceneKey key(std::string_view path, std::string_view unit, std::string_view fallback,
                       std::string_view meaning, KeyRange range = {}) {
  using Value = std::remove_cvref_t<decltype(place<members...>(std::declval<Scene&>()))>;
  SceneKey row{path, type_of<Value>, unit, fallback, meaning, range, {}, read<members...>};
  if constexpr (std::is_enum_v<Value>) row.choices = choices_of(Value{}).rows;
  return row;
}

constexpr std::string_view no_gradient = "[[0.0, 0.0], [0.0, 0.0]]";
constexpr std::string_view gradient_meaning =
    "G in the further initial velocity G (x - centre of the shape), as rows.";

// clang-format off
/// The keys, and then the tables.
constexpr auto rows = std::to_array<SceneKey>({
    key<&Scene::title>("scene.title", "", required_key, "Shown on pictures and in summaries."),
    key<&Scene::source>("scene.source", "", "\"\"", "Where the scene comes from."),

    key<&Scene::spacing>("particles.spacing", "length", required_key,
     "The particle spacing h. A particle's mass is `rest_density` h².", positive),
    key<&Scene::rest_density>("particles.rest_density", "mass/length²", required_key, "The rest density rho0.", positive),
    key<&Scene::smoothing>("particles.smoothing", "", "1.0",
     "H/h, with H the smoothing length; the kernel reaches 2H.", from_to(1, 1.5)),

    {"domain.min", lengths, "length", required_key, "Lower left corner."},
    {"domain.max", lengths, "length", required_key, "Upper right corner, beyond `min` both ways."},

    key<&Scene::gravity>("fluid.gravity", "length/time²", required_key, "Acceleration by gravity."),
    key<&Scene::central_force>("fluid.central_force", "1/time²", "0.0", "c in the further acceleration -c (x - `centre`)."),
    {"fluid.centre", lengths, "length", "[0, 0]", "Centre of the central force."},
    key<&Scene::jitter>("fluid.jitter", "h", "0.0",
     "Every particle starts displaced, each component uniform in [-`jitter`, `jitter`] h.", from_to(0, 0.5)),
    key<&Scene::seed>("fluid.seed", "", "0", "Seed of the jitter; the same seed, the same bits.", not_negative),
    key<&Scene::relax>("fluid.relax", "", "0",
     "Number of projections of the start positions on the density.", from_to(0, 1000)),

    {"fluid.rect[].min", lengths, "length", required_key, "The first particle."},
    {"fluid.rect[].max", lengths, "length", "", "Excluded upper corner: ceil((`max` - `min`)/h - 1e-6) particles each way."},
    {"fluid.rect[].count", integers, "", "", "Columns and rows, in place of `max`.", at_least(1)},
    {"fluid.rect[].velocity", numbers, "length/time", "[0.0, 0.0]", "Initial velocity."},
    {"fluid.rect[].velocity_gradient", matrix, "1/time", no_gradient, gradient_meaning},

    {"fluid.disc[].centre", lengths, "length", required_key, "Centre, where a particle sits."},
    {"fluid.disc[].radius", length, "length", required_key, "Radius.", positive},
    {"fluid.disc[].velocity", numbers, "length/time", "[0.0, 0.0]", "Initial velocity."},
    {"fluid.disc[].velocity_gradient", matrix, "1/time", no_gradient, gradient_meaning},

    {"fluid.polygon[].points", points, "length", required_key, "Corners, in order; the last is joined to the first."},
    {"fluid.polygon[].velocity", numbers, "length/time", "[0.0, 0.0]", "Initial velocity."},
    {"fluid.polygon[].velocity_gradient", matrix, "1/time", no_gradient, gradient_meaning},

    {"fluid.particles[].file", text, "", required_key,
     "A CSV file with the columns x and y, and vx and vy if it has them, as `--state` writes it; beside the scene's file."},
    {"fluid.particles[].velocity", numbers, "length/time", "[0.0, 0.0]", "Initial velocity, added to that in the file."},

    key<&Scene::boundary_model>("boundary.model", "", required_key, "How walls act on the fluid."),

    {"boundary.rect[].min", lengths, "length", required_key, "The first sample."},
    {"boundary.rect[].max", lengths, "length", "", "Excluded upper corner: ceil((`max` - `min`)/h - 1e-6) samples each way."},
    {"boundary.rect[].count", integers, "", "", "Columns and rows, in place of `max`.", at_least(1)},
    {"boundary.rect[].layers", integer, "", "0", "Keeps this many outer layers only; 0 keeps all.", from_to(0, 1000)},
    {"boundary.rect[].name", text, "", "", "What `--wall-forces` calls it; its place in the file if not given."},

    {"boundary.disc[].centre", lengths, "length", required_key, "Centre, where a sample sits."},
    {"boundary.disc[].radius", length, "length", required_key, "Radius.", positive},
    {"boundary.disc[].name", text, "", "", "What `--wall-forces` calls it; its place in the file if not given."},

    {"boundary.polygon[].points", points, "length", required_key, "Corners, in order; the last is joined to the first."},
    {"boundary.polygon[].name", text, "", "", "What `--wall-forces` calls it; its place in the file if not given."},

    {"boundary.container[].min", lengths, "length", required_key, "Lower left corner, on the outermost layer."},
    {"boundary.container[].max", lengths, "length", required_key, "Upper right corner, beyond `min` both ways."},
    {"boundary.container[].layers", integer, "", "3",
     "Thickness of each wall; 1 is enough for an \"akinci\" boundary.", from_to(1, 1000)},
    {"boundary.container[].sides", choices, "", "[\"left\", \"right\", \"bottom\"]",
     "The walls there are.", {}, choices_of(Side{}).rows},
    {"boundary.container[].name", text, "", "", "What `--wall-forces` calls it; its place in the file if not given."},

    {"boundary.segment[].from", lengths, "length", required_key, "Start, where a sample sits."},
    {"boundary.segment[].to", lengths, "length", required_key, "End."},
    {"boundary.segment[].layers", integer, "", "3", "Thickness.", from_to(1, 1000)},
    {"boundary.segment[].name", text, "", "", "What `--wall-forces` calls it; its place in the file if not given."},

    key<&Scene::viscosity_model>("viscosity.model", "", required_key, "How velocities are made alike."),
    key<&Scene::viscosity>("viscosity.coefficient", "length²/time", required_key,
     "nu of \"laplacian\"; alpha of \"xsph\", a pure number, up to about 2.", not_negative),

    key<&Scene::method>("pressure.method", "", required_key, "The method of this run."),

    key<&Scene::iisph, &Iisph::tolerance>("pressure.iisph.tolerance", "", "1e-3",
     "The iteration stops when its error is less.", positive),
    key<&Scene::iisph, &Iisph::min_iterations>("pressure.iisph.min_iterations", "", "2",
     "Iterations that are always done.", from_to(1, 1e9)),
    key<&Scene::iisph, &Iisph::max_iterations>("pressure.iisph.max_iterations", "", "1000",
     "The iteration ends here, converged or not; not below `min_iterations`.", from_to(1, 1e9)),
    key<&Scene::iisph, &Iisph::omega>("pressure.iisph.omega", "", "0.5",
     "Step of the Jacobi iteration, which tends to diverge from 0.9, and of the first and the last step of the "
     "other.", between(0, 2)),
    key<&Scene::iisph, &Iisph::warm_start>("pressure.iisph.warm_start", "", "0.5",
     "The iteration starts from this part of the last step's pressure.", from_to(0, 1)),
    key<&Scene::iisph, &Iisph::solver>("pressure.iisph.solver", "", "\"jacobi\"", "How the system is iterated."),
    key<&Scene::iisph, &Iisph::wall>("pressure.iisph.wall", "", "\"thesis\"", "The wall term of a \"mirror\" boundary."),
    key<&Scene::iisph, &Iisph::stop>("pressure.iisph.stop", "", "\"density\"", "What `tolerance` bounds."),
    key<&Scene::iisph, &Iisph::source_weight>("pressure.iisph.source_weight", "", "1.0",
     "Weight of rho0 - rho in the source.", above_to(0, 1)),
    {"pressure.iisph.dt", number, "time", "", "Time step while this method is chosen.", positive},

    key<&Scene::ssph, &Ssph::stiffness>("pressure.ssph.stiffness", "mass/time²", required_key, "The stiffness k.", positive),
    {"pressure.ssph.dt", number, "time", "", "Time step while this method is chosen.", positive},

    key<&Scene::wcsph, &Wcsph::kappa>("pressure.wcsph.kappa", "length²/time²", required_key, "The stiffness kappa.", positive),
    key<&Scene::wcsph, &Wcsph::gamma>("pressure.wcsph.gamma", "", "7.0", "The exponent gamma.", from_to(1, 1e6)),
    {"pressure.wcsph.dt", number, "time", "", "Time step while this method is chosen.", positive},

    {"time.dt", number, "time", "", "The time step.", positive},
    key<&Scene::duration>("time.duration", "time", required_key, "The time that is simulated.", positive),
    key<&Scene::adaptive, &AdaptiveStep::cfl>("time.cfl", "", "",
     "In place of `dt`: steps adapt so that no particle moves more than `cfl` h in one.", positive),
    key<&Scene::adaptive, &AdaptiveStep::dt_min>("time.dt_min", "time", "", "Smallest step; needed with `cfl`.", positive),
    key<&Scene::adaptive, &AdaptiveStep::dt_max>("time.dt_max", "time", "", "Largest step; needed with `cfl`.", positive),

    {"probe[].name", text, "", required_key, "Name of its columns; no two are the same."},
    {"probe[].at", lengths, "length", "", "A point: pressure, density and velocity there."},
    {"probe[].x", length, "length", "", "A vertical line in place of `at`: the height of the surface on it."},
    {"probe[].y", length, "length", "", "A horizontal line in place of `at`: the front of the fluid on it, its largest x."},

    key<&Scene::fps>("output.fps", "1/time", "25.0", "Pictures per unit of time.", positive),
    {"output.size", integers, "pixel", "",
     "Width and height. Without it the longer side of `domain` is 800 pixels.", from_to(16, 16384)},
    key<&Scene::colour>("output.colour", "", "\"speed\"", "What the colour of a particle shows."),

    {"scene", table, "", required_key, "What the scene is called and where it comes from."},
    {"particles", table, "", required_key, "The discretisation."},
    {"domain", table, "", required_key,
     "The frame of the picture. A particle left of it, right of it or below it counts as lost."},
    {"fluid", table, "", required_key,
     "Forces on the fluid and how it starts. At least one fluid shape is needed. Particles are numbered shape by shape in the "
     "order of the file, in a shape by rows from below, in a row from the left."},
    {"fluid.rect[]", tables, "", "", "A rectangle of fluid: particles at `min` + (i, j) h. Takes `max` or `count`, not both."},
    {"fluid.disc[]", tables, "", "", "A disc of fluid: the lattice of spacing h through its centre, strictly inside."},
    {"fluid.polygon[]", tables, "", "",
     "A polygon of fluid: the lattice of spacing h through its first point, strictly inside."},
    {"fluid.particles[]", tables, "", "",
     "Particles from a file, where and as fast as they are there. They may be closer than h/2, as in a run."},
    {"boundary", table, "", "",
     "Solid walls that do not move. Leave the table out when there are none. A sample closer than h/2 to an earlier one is "
     "dropped."},
    {"boundary.rect[]", tables, "", "",
     "A rectangle of boundary samples at `min` + (i, j) h. Takes `max` or `count`, not both."},
    {"boundary.disc[]", tables, "", "", "A disc of boundary samples, filled as a disc of fluid."},
    {"boundary.polygon[]", tables, "", "", "A polygon of boundary samples, filled as a polygon of fluid."},
    {"boundary.container[]", tables, "", "",
     "Walls of a box: from each named side inward, samples at the wall, at h, at 2h, ..."},
    {"boundary.segment[]", tables, "", "",
     "A straight wall: samples every h along `from` -> `to`, further layers to the right of that direction."},
    {"viscosity", table, "", "", "Leave the table out for an inviscid fluid."},
    {"pressure", table, "", required_key,
     "How pressure is computed. The tables of all methods may be present; `method` chooses."},
    {"pressure.iisph", table, "", "{}",
     "Implicit incompressible SPH, a linear system for the pressure [Ihmsen et al. 2014], [Hunkler 2022]."},
    {"pressure.ssph", table, "", "",
     "Pressure from the state equation p = max(k (rho/rho0 - 1), 0) [Hunkler 2022]. Needed when `pressure.method` is "
     "\"ssph\"."},
    {"pressure.wcsph", table, "", "",
     "Pressure from Tait's equation p = kappa rho0/gamma ((rho/rho0)^gamma - 1) [WCSPH page]. Needed when `pressure.method` is "
     "\"wcsph\"."},
    {"time", table, "", required_key,
     "Time step and duration. The step is `dt` of the chosen method's table, else `dt` here; one of the two is needed."},
    {"probe[]", tables, "", "", "A probe, for `--probes`: takes one of `at`, `x` and `y`."},
    {"output", table, "", "{}", "Pictures of the run."},
});
// clang-format on

constexpr size_t key_count =
    std::ranges::count_if(rows, [](const SceneKey& row) { return row.type != table && row.type != tables; });

}  // namespace

std::span<const SceneKey> scene_rows() { return rows; }

std::span<const SceneKey> scene_keys() { return scene_rows().first(key_count); }

std::span<const SceneKey> scene_tables() { return scene_rows().subspan(key_count); }

}  // namespace sluice
