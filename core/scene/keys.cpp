// The rows of the key table. To add a key, add its row here and read it in build.cpp.
#include "core/scene/keys.hpp"

#include <array>

namespace sluice {
namespace {

constexpr KeyRange any{};
constexpr KeyRange positive{.low = 0, .low_excluded = true};
constexpr KeyRange not_negative{.low = 0};

constexpr KeyRange at_least(double low) { return {.low = low}; }
constexpr KeyRange from_to(double low, double high) { return {.low = low, .high = high}; }

using enum KeyType;

constexpr std::array sections{
    SceneSection{"scene", Presence::required, "What the scene is called and where it comes from."},
    SceneSection{"particles", Presence::required, "The discretisation."},
    SceneSection{"domain", Presence::required,
                 "The frame of the picture. A particle left of it, right of it or below it counts as lost."},
    SceneSection{
        "fluid", Presence::required,
        "Forces on the fluid and how it starts. At least one fluid shape is needed. Particles are numbered "
        "shape by shape in the order of the file, in a shape by rows from below, in a row from the left."},
    SceneSection{"fluid.rect[]", Presence::optional,
                 "A rectangle of fluid: particles at `min` + (i, j) h. Takes `max` or `count`, not both."},
    SceneSection{"fluid.disc[]", Presence::optional,
                 "A disc of fluid: the lattice of spacing h through its centre, strictly inside."},
    SceneSection{"fluid.polygon[]", Presence::optional,
                 "A polygon of fluid: the lattice of spacing h through its first point, strictly inside."},
    SceneSection{
        "boundary", Presence::optional,
        "Solid walls that do not move. Leave the table out when there are none. A sample closer than h/2 to "
        "an earlier one is dropped."},
    SceneSection{"boundary.rect[]", Presence::optional,
                 "A rectangle of boundary samples at `min` + (i, j) h. Takes `max` or `count`, not both."},
    SceneSection{"boundary.disc[]", Presence::optional,
                 "A disc of boundary samples, filled as a disc of fluid."},
    SceneSection{"boundary.polygon[]", Presence::optional,
                 "A polygon of boundary samples, filled as a polygon of fluid."},
    SceneSection{"boundary.container[]", Presence::optional,
                 "Walls of a box: from each named side inward, samples at the wall, at h, at 2h, ..."},
    SceneSection{"boundary.segment[]", Presence::optional,
                 "A straight wall: samples every h along `from` -> `to`, further layers to the right of that "
                 "direction."},
    SceneSection{"viscosity", Presence::optional, "Leave the table out for an inviscid fluid."},
    SceneSection{"pressure", Presence::required,
                 "How pressure is computed. The tables of all methods may be present; `method` chooses."},
    SceneSection{"pressure.iisph", Presence::defaulted,
                 "Implicit incompressible SPH, a linear system for the pressure [Ihmsen et al. 2014], "
                 "[Hunkler 2022]."},
    SceneSection{"pressure.ssph", Presence::optional,
                 "Pressure from the state equation p = max(k (rho/rho0 - 1), 0) [Hunkler 2022]. Needed when "
                 "`pressure.method` is \"ssph\"."},
    SceneSection{
        "pressure.wcsph", Presence::optional,
        "Pressure from Tait's equation p = kappa rho0/gamma ((rho/rho0)^gamma - 1) [WCSPH page]. Needed "
        "when `pressure.method` is \"wcsph\"."},
    SceneSection{
        "time", Presence::required,
        "Time step and duration. The step is `dt` of the chosen method's table, else `dt` here; one of the "
        "two is needed."},
    SceneSection{"output", Presence::defaulted, "Pictures of the run."},
};

constexpr std::array keys{
    SceneKey{"scene.title", text, "", required_key, any, "Shown on pictures and in summaries."},
    SceneKey{"scene.source", text, "", "\"\"", any, "Where the scene comes from."},

    SceneKey{"particles.spacing", number, "length", required_key, positive,
             "The particle spacing h. A particle's mass is `rest_density` h²."},
    SceneKey{"particles.rest_density", number, "mass/length²", required_key, positive,
             "The rest density rho0."},
    SceneKey{"particles.smoothing", number, "", "1.0", from_to(1, 1.5),
             "H/h, with H the smoothing length; the kernel reaches 2H."},

    SceneKey{"domain.min", lengths, "length", required_key, any, "Lower left corner."},
    SceneKey{"domain.max", lengths, "length", required_key, any,
             "Upper right corner, beyond `min` both ways."},

    SceneKey{"fluid.gravity", numbers, "length/time²", required_key, any, "Acceleration by gravity."},
    SceneKey{"fluid.central_force", number, "1/time²", "0.0", any,
             "c in the further acceleration -c (x - `centre`)."},
    SceneKey{"fluid.centre", lengths, "length", "[0, 0]", any, "Centre of the central force."},
    SceneKey{"fluid.jitter", number, "h", "0.0", from_to(0, 0.5),
             "Every particle starts displaced, each component uniform in [-`jitter`, `jitter`] h."},
    SceneKey{"fluid.seed", integer, "", "0", not_negative,
             "Seed of the jitter; the same seed, the same bits."},
    SceneKey{"fluid.relax", integer, "", "0", from_to(0, 1000),
             "Number of projections of the start positions on the density."},

    SceneKey{"fluid.rect[].min", lengths, "length", required_key, any, "The first particle."},
    SceneKey{"fluid.rect[].max", lengths, "length", "", any,
             "Excluded upper corner: ceil((`max` - `min`)/h - 1e-6) particles each way."},
    SceneKey{"fluid.rect[].count", integers, "", "", at_least(1), "Columns and rows, in place of `max`."},
    SceneKey{"fluid.rect[].velocity", numbers, "length/time", "[0.0, 0.0]", any, "Initial velocity."},
    SceneKey{"fluid.rect[].velocity_gradient", matrix, "1/time", "[[0.0, 0.0], [0.0, 0.0]]", any,
             "G in the further initial velocity G (x - centre of the shape), as rows."},

    SceneKey{"fluid.disc[].centre", lengths, "length", required_key, any, "Centre, where a particle sits."},
    SceneKey{"fluid.disc[].radius", length, "length", required_key, positive, "Radius."},
    SceneKey{"fluid.disc[].velocity", numbers, "length/time", "[0.0, 0.0]", any, "Initial velocity."},
    SceneKey{"fluid.disc[].velocity_gradient", matrix, "1/time", "[[0.0, 0.0], [0.0, 0.0]]", any,
             "G in the further initial velocity G (x - centre of the shape), as rows."},

    SceneKey{"fluid.polygon[].points", points, "length", required_key, any,
             "Corners, in order; the last is joined to the first."},
    SceneKey{"fluid.polygon[].velocity", numbers, "length/time", "[0.0, 0.0]", any, "Initial velocity."},
    SceneKey{"fluid.polygon[].velocity_gradient", matrix, "1/time", "[[0.0, 0.0], [0.0, 0.0]]", any,
             "G in the further initial velocity G (x - centre of the shape), as rows."},

    SceneKey{"boundary.model", choice, "", required_key, any, "How walls act on the fluid.",
             choices_of(BoundaryModel{}).rows},

    SceneKey{"boundary.rect[].min", lengths, "length", required_key, any, "The first sample."},
    SceneKey{"boundary.rect[].max", lengths, "length", "", any,
             "Excluded upper corner: ceil((`max` - `min`)/h - 1e-6) samples each way."},
    SceneKey{"boundary.rect[].count", integers, "", "", at_least(1), "Columns and rows, in place of `max`."},
    SceneKey{"boundary.rect[].layers", integer, "", "0", from_to(0, 1000),
             "Keeps this many outer layers only; 0 keeps all."},

    SceneKey{"boundary.disc[].centre", lengths, "length", required_key, any, "Centre, where a sample sits."},
    SceneKey{"boundary.disc[].radius", length, "length", required_key, positive, "Radius."},

    SceneKey{"boundary.polygon[].points", points, "length", required_key, any,
             "Corners, in order; the last is joined to the first."},

    SceneKey{"boundary.container[].min", lengths, "length", required_key, any,
             "Lower left corner, on the outermost layer."},
    SceneKey{"boundary.container[].max", lengths, "length", required_key, any,
             "Upper right corner, beyond `min` both ways."},
    SceneKey{"boundary.container[].layers", integer, "", "3", from_to(1, 1000),
             "Thickness of each wall; 1 is enough for an \"akinci\" boundary."},
    SceneKey{"boundary.container[].sides", choices, "", "[\"left\", \"right\", \"bottom\"]", any,
             "The walls there are.", choices_of(Side{}).rows},

    SceneKey{"boundary.segment[].from", lengths, "length", required_key, any, "Start, where a sample sits."},
    SceneKey{"boundary.segment[].to", lengths, "length", required_key, any, "End."},
    SceneKey{"boundary.segment[].layers", integer, "", "3", from_to(1, 1000), "Thickness."},

    SceneKey{"viscosity.model", choice, "", required_key, any, "How velocities are made alike.",
             choices_of(ViscosityModel{}).rows},
    SceneKey{"viscosity.coefficient", number, "length²/time", required_key, not_negative,
             "nu of \"laplacian\"; alpha of \"xsph\", a pure number, up to about 2."},

    SceneKey{"pressure.method", choice, "", required_key, any, "The method of this run.",
             choices_of(PressureMethod{}).rows},

    SceneKey{"pressure.iisph.tolerance", number, "", "1e-3", positive,
             "The iteration stops when its error is less."},
    SceneKey{"pressure.iisph.min_iterations", integer, "", "2", from_to(1, 1e9),
             "Iterations that are always done."},
    SceneKey{"pressure.iisph.max_iterations", integer, "", "1000", from_to(1, 1e9),
             "The iteration ends here, converged or not; not below `min_iterations`."},
    SceneKey{"pressure.iisph.omega", number, "", "0.5",
             KeyRange{.low = 0, .high = 2, .low_excluded = true, .high_excluded = true},
             "Step of the Jacobi iteration, which tends to diverge from 0.9, and of the first and the last "
             "step of the "
             "other."},
    SceneKey{"pressure.iisph.warm_start", number, "", "0.5", from_to(0, 1),
             "The iteration starts from this part of the last step's pressure."},
    SceneKey{"pressure.iisph.solver", choice, "", "\"jacobi\"", any, "How the system is iterated.",
             choices_of(Solver{}).rows},
    SceneKey{"pressure.iisph.wall", choice, "", "\"thesis\"", any, "The wall term of a \"mirror\" boundary.",
             choices_of(Wall{}).rows},
    SceneKey{"pressure.iisph.stop", choice, "", "\"density\"", any, "What `tolerance` bounds.",
             choices_of(Stop{}).rows},
    SceneKey{"pressure.iisph.source_weight", number, "", "1.0",
             KeyRange{.low = 0, .high = 1, .low_excluded = true}, "Weight of rho0 - rho in the source."},
    SceneKey{"pressure.iisph.dt", number, "time", "", positive, "Time step while this method is chosen."},

    SceneKey{"pressure.ssph.stiffness", number, "mass/time²", required_key, positive, "The stiffness k."},
    SceneKey{"pressure.ssph.dt", number, "time", "", positive, "Time step while this method is chosen."},

    SceneKey{"pressure.wcsph.kappa", number, "length²/time²", required_key, positive, "The stiffness kappa."},
    SceneKey{"pressure.wcsph.gamma", number, "", "7.0", from_to(1, 1e6), "The exponent gamma."},
    SceneKey{"pressure.wcsph.dt", number, "time", "", positive, "Time step while this method is chosen."},

    SceneKey{"time.dt", number, "time", "", positive, "The time step."},
    SceneKey{"time.duration", number, "time", required_key, positive, "The time that is simulated."},
    SceneKey{"time.cfl", number, "", "", positive,
             "In place of `dt`: steps adapt so that no particle moves more than `cfl` h in one."},
    SceneKey{"time.dt_min", number, "time", "", positive, "Smallest step; needed with `cfl`."},
    SceneKey{"time.dt_max", number, "time", "", positive, "Largest step; needed with `cfl`."},

    SceneKey{"output.fps", number, "1/time", "25.0", positive, "Pictures per unit of time."},
    SceneKey{"output.size", integers, "pixel", "", from_to(16, 16384),
             "Width and height. Without it the longer side of `domain` is 800 pixels."},
    SceneKey{"output.colour", choice, "", "\"speed\"", any, "What the colour of a particle shows.",
             choices_of(Colour{}).rows},
};

}  // namespace

std::span<const SceneKey> scene_keys() { return keys; }

std::span<const SceneSection> scene_sections() { return sections; }

}  // namespace sluice
