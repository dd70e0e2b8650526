// The rows of the key table. To add a key, add its row here and read it in build.cpp.
#include "core/scene/keys.hpp"

#include <algorithm>
#include <array>

namespace sluice {
namespace {

using enum KeyType;

constexpr KeyRange positive{.low = 0, .low_excluded = true};
constexpr KeyRange not_negative{.low = 0};

constexpr KeyRange at_least(double low) { return {.low = low}; }
constexpr KeyRange from_to(double low, double high) { return {.low = low, .high = high}; }
constexpr KeyRange between(double low, double high) { return {low, high, true, true}; }
constexpr KeyRange above_to(double low, double high) { return {low, high, true, false}; }

/// A key whose values are names.
constexpr SceneKey named(std::string_view path, std::string_view fallback, std::string_view meaning,
                         ChoiceTable names, KeyType type = choice) {
  return {path, type, "", fallback, meaning, {}, names.rows};
}

/// The keys, and then the tables.
constexpr auto rows = std::to_array<SceneKey>({
    {"scene.title", text, "", required_key, "Shown on pictures and in summaries."},
    {"scene.source", text, "", "\"\"", "Where the scene comes from."},

    {"particles.spacing", number, "length", required_key,
     "The particle spacing h. A particle's mass is `rest_density` h².", positive},
    {"particles.rest_density", number, "mass/length²", required_key, "The rest density rho0.", positive},
    {"particles.smoothing", number, "", "1.0", "H/h, with H the smoothing length; the kernel reaches 2H.",
     from_to(1, 1.5)},

    {"domain.min", lengths, "length", required_key, "Lower left corner."},
    {"domain.max", lengths, "length", required_key, "Upper right corner, beyond `min` both ways."},

    {"fluid.gravity", numbers, "length/time²", required_key, "Acceleration by gravity."},
    {"fluid.central_force", number, "1/time²", "0.0", "c in the further acceleration -c (x - `centre`)."},
    {"fluid.centre", lengths, "length", "[0, 0]", "Centre of the central force."},
    {"fluid.jitter", number, "h", "0.0",
     "Every particle starts displaced, each component uniform in [-`jitter`, `jitter`] h.", from_to(0, 0.5)},
    {"fluid.seed", integer, "", "0", "Seed of the jitter; the same seed, the same bits.", not_negative},
    {"fluid.relax", integer, "", "0", "Number of projections of the start positions on the density.",
     from_to(0, 1000)},

    {"fluid.rect[].min", lengths, "length", required_key, "The first particle."},
    {"fluid.rect[].max", lengths, "length", "",
     "Excluded upper corner: ceil((`max` - `min`)/h - 1e-6) particles each way."},
    {"fluid.rect[].count", integers, "", "", "Columns and rows, in place of `max`.", at_least(1)},
    {"fluid.rect[].velocity", numbers, "length/time", "[0.0, 0.0]", "Initial velocity."},
    {"fluid.rect[].velocity_gradient", matrix, "1/time", "[[0.0, 0.0], [0.0, 0.0]]",
     "G in the further initial velocity G (x - centre of the shape), as rows."},

    {"fluid.disc[].centre", lengths, "length", required_key, "Centre, where a particle sits."},
    {"fluid.disc[].radius", length, "length", required_key, "Radius.", positive},
    {"fluid.disc[].velocity", numbers, "length/time", "[0.0, 0.0]", "Initial velocity."},
    {"fluid.disc[].velocity_gradient", matrix, "1/time", "[[0.0, 0.0], [0.0, 0.0]]",
     "G in the further initial velocity G (x - centre of the shape), as rows."},

    {"fluid.polygon[].points", points, "length", required_key,
     "Corners, in order; the last is joined to the first."},
    {"fluid.polygon[].velocity", numbers, "length/time", "[0.0, 0.0]", "Initial velocity."},
    {"fluid.polygon[].velocity_gradient", matrix, "1/time", "[[0.0, 0.0], [0.0, 0.0]]",
     "G in the further initial velocity G (x - centre of the shape), as rows."},

    named("boundary.model", required_key, "How walls act on the fluid.", choices_of(BoundaryModel{})),

    {"boundary.rect[].min", lengths, "length", required_key, "The first sample."},
    {"boundary.rect[].max", lengths, "length", "",
     "Excluded upper corner: ceil((`max` - `min`)/h - 1e-6) samples each way."},
    {"boundary.rect[].count", integers, "", "", "Columns and rows, in place of `max`.", at_least(1)},
    {"boundary.rect[].layers", integer, "", "0", "Keeps this many outer layers only; 0 keeps all.",
     from_to(0, 1000)},

    {"boundary.disc[].centre", lengths, "length", required_key, "Centre, where a sample sits."},
    {"boundary.disc[].radius", length, "length", required_key, "Radius.", positive},

    {"boundary.polygon[].points", points, "length", required_key,
     "Corners, in order; the last is joined to the first."},

    {"boundary.container[].min", lengths, "length", required_key,
     "Lower left corner, on the outermost layer."},
    {"boundary.container[].max", lengths, "length", required_key,
     "Upper right corner, beyond `min` both ways."},
    {"boundary.container[].layers", integer, "", "3",
     "Thickness of each wall; 1 is enough for an \"akinci\" boundary.", from_to(1, 1000)},
    named("boundary.container[].sides", "[\"left\", \"right\", \"bottom\"]", "The walls there are.",
          choices_of(Side{}), choices),

    {"boundary.segment[].from", lengths, "length", required_key, "Start, where a sample sits."},
    {"boundary.segment[].to", lengths, "length", required_key, "End."},
    {"boundary.segment[].layers", integer, "", "3", "Thickness.", from_to(1, 1000)},

    named("viscosity.model", required_key, "How velocities are made alike.", choices_of(ViscosityModel{})),
    {"viscosity.coefficient", number, "length²/time", required_key,
     "nu of \"laplacian\"; alpha of \"xsph\", a pure number, up to about 2.", not_negative},

    named("pressure.method", required_key, "The method of this run.", choices_of(PressureMethod{})),

    {"pressure.iisph.tolerance", number, "", "1e-3", "The iteration stops when its error is less.", positive},
    {"pressure.iisph.min_iterations", integer, "", "2", "Iterations that are always done.", from_to(1, 1e9)},
    {"pressure.iisph.max_iterations", integer, "", "1000",
     "The iteration ends here, converged or not; not below `min_iterations`.", from_to(1, 1e9)},
    {"pressure.iisph.omega", number, "", "0.5",
     "Step of the Jacobi iteration, which tends to diverge from 0.9, and of the first and the last step of "
     "the other.",
     between(0, 2)},
    {"pressure.iisph.warm_start", number, "", "0.5",
     "The iteration starts from this part of the last step's pressure.", from_to(0, 1)},
    named("pressure.iisph.solver", "\"jacobi\"", "How the system is iterated.", choices_of(Solver{})),
    named("pressure.iisph.wall", "\"thesis\"", "The wall term of a \"mirror\" boundary.", choices_of(Wall{})),
    named("pressure.iisph.stop", "\"density\"", "What `tolerance` bounds.", choices_of(Stop{})),
    {"pressure.iisph.source_weight", number, "", "1.0", "Weight of rho0 - rho in the source.",
     above_to(0, 1)},
    {"pressure.iisph.dt", number, "time", "", "Time step while this method is chosen.", positive},

    {"pressure.ssph.stiffness", number, "mass/time²", required_key, "The stiffness k.", positive},
    {"pressure.ssph.dt", number, "time", "", "Time step while this method is chosen.", positive},

    {"pressure.wcsph.kappa", number, "length²/time²", required_key, "The stiffness kappa.", positive},
    {"pressure.wcsph.gamma", number, "", "7.0", "The exponent gamma.", from_to(1, 1e6)},
    {"pressure.wcsph.dt", number, "time", "", "Time step while this method is chosen.", positive},

    {"time.dt", number, "time", "", "The time step.", positive},
    {"time.duration", number, "time", required_key, "The time that is simulated.", positive},
    {"time.cfl", number, "", "",
     "In place of `dt`: steps adapt so that no particle moves more than `cfl` h in one.", positive},
    {"time.dt_min", number, "time", "", "Smallest step; needed with `cfl`.", positive},
    {"time.dt_max", number, "time", "", "Largest step; needed with `cfl`.", positive},

    {"output.fps", number, "1/time", "25.0", "Pictures per unit of time.", positive},
    {"output.size", integers, "pixel", "",
     "Width and height. Without it the longer side of `domain` is 800 pixels.", from_to(16, 16384)},
    named("output.colour", "\"speed\"", "What the colour of a particle shows.", choices_of(Colour{})),

    {"scene", table, "", required_key, "What the scene is called and where it comes from."},
    {"particles", table, "", required_key, "The discretisation."},
    {"domain", table, "", required_key,
     "The frame of the picture. A particle left of it, right of it or below it counts as lost."},
    {"fluid", table, "", required_key,
     "Forces on the fluid and how it starts. At least one fluid shape is needed. Particles are numbered "
     "shape by shape in the order of the file, in a shape by rows from below, in a row from the left."},
    {"fluid.rect[]", tables, "", "",
     "A rectangle of fluid: particles at `min` + (i, j) h. Takes `max` or `count`, not both."},
    {"fluid.disc[]", tables, "", "",
     "A disc of fluid: the lattice of spacing h through its centre, strictly inside."},
    {"fluid.polygon[]", tables, "", "",
     "A polygon of fluid: the lattice of spacing h through its first point, strictly inside."},
    {"boundary", table, "", "",
     "Solid walls that do not move. Leave the table out when there are none. A sample closer than h/2 to "
     "an earlier one is dropped."},
    {"boundary.rect[]", tables, "", "",
     "A rectangle of boundary samples at `min` + (i, j) h. Takes `max` or `count`, not both."},
    {"boundary.disc[]", tables, "", "", "A disc of boundary samples, filled as a disc of fluid."},
    {"boundary.polygon[]", tables, "", "", "A polygon of boundary samples, filled as a polygon of fluid."},
    {"boundary.container[]", tables, "", "",
     "Walls of a box: from each named side inward, samples at the wall, at h, at 2h, ..."},
    {"boundary.segment[]", tables, "", "",
     "A straight wall: samples every h along `from` -> `to`, further layers to the right of that "
     "direction."},
    {"viscosity", table, "", "", "Leave the table out for an inviscid fluid."},
    {"pressure", table, "", required_key,
     "How pressure is computed. The tables of all methods may be present; `method` chooses."},
    {"pressure.iisph", table, "", "{}",
     "Implicit incompressible SPH, a linear system for the pressure [Ihmsen et al. 2014], "
     "[Hunkler 2022]."},
    {"pressure.ssph", table, "", "",
     "Pressure from the state equation p = max(k (rho/rho0 - 1), 0) [Hunkler 2022]. Needed when "
     "`pressure.method` is \"ssph\"."},
    {"pressure.wcsph", table, "", "",
     "Pressure from Tait's equation p = kappa rho0/gamma ((rho/rho0)^gamma - 1) [WCSPH page]. Needed "
     "when `pressure.method` is \"wcsph\"."},
    {"time", table, "", required_key,
     "Time step and duration. The step is `dt` of the chosen method's table, else `dt` here; one of the "
     "two is needed."},
    {"output", table, "", "{}", "Pictures of the run."},
});

constexpr size_t key_count =
    std::ranges::count_if(rows, [](const SceneKey& row) { return row.type != table && row.type != tables; });

}  // namespace

std::span<const SceneKey> scene_rows() { return rows; }

std::span<const SceneKey> scene_keys() { return scene_rows().first(key_count); }

std::span<const SceneKey> scene_tables() { return scene_rows().subspan(key_count); }

}  // namespace sluice
