// The module sluice._sluice: sluice/simulation.hpp and what belongs to it for Python. Arrays are numpy's;
// what takes long lets other threads of Python run. python/sluice/ makes the module `sluice` of it.
#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "sluice/cpu.hpp"
#include "sluice/load.hpp"
#include "sluice/recording.hpp"
#include "sluice/simulation.hpp"
#include "sluice/version.hpp"
#ifdef SLUICE_WITH_GPU
#include "sluice/gpu.hpp"
#include "sluice/pictures.hpp"
#endif

namespace py = pybind11;
using namespace py::literals;

namespace sluice {
namespace {

using Released = py::call_guard<py::gil_scoped_release>;
using Strings = std::vector<std::string>;

/// A run that became invalid.
class InvalidRun : public Error {
 public:
  using Error::Error;
};

py::tuple tuple_of(Vec2 v) { return py::make_tuple(v.x, v.y); }

/// The value that people call `name`, of what Python's users write.
template <class Choice>
Choice chosen(const std::string& key, const std::string& name) {
  if (const auto value = value_named<Choice>(name)) return *value;
  std::string names;
  for (const Choice each : values_of<Choice>())
    names += fmt::format("{}{}", names.empty() ? "" : ", ", name_of(each));
  throw InputError(fmt::format("{}: found {}, expected one of {}", key, name, names));
}

py::array copy_of(std::span<const Vec2> values) {
  return py::array_t<double>({values.size(), size_t{2}}, reinterpret_cast<const double*>(values.data()));
}
py::array copy_of(std::span<const double> values) {
  return py::array_t<double>(values.size(), values.data());
}

py::dtype dtype_of(NumberType type) {
  switch (type) {
    case NumberType::float32: return py::dtype::of<float>();
    case NumberType::uint32: return py::dtype::of<uint32_t>();
    case NumberType::float64: break;
  }
  return py::dtype::of<double>();
}

/// An array of the view's numbers: a copy, or if `owner` is given the memory itself, which it keeps.
py::array array_of(const FieldView& view, py::handle owner = {}) {
  std::vector<size_t> shape{view.rows};
  if (view.columns > 1) shape.push_back(view.columns);
  py::array array(dtype_of(view.type), shape, view.bytes.data(), owner);
  if (owner) array.attr("setflags")("write"_a = false);
  return array;
}

std::vector<Vec2> vectors_of(const py::array_t<double, py::array::c_style | py::array::forcecast>& values) {
  if (values.ndim() != 2 || values.shape(1) != 2)
    throw InputError("found an array of another shape, expected rows of two numbers, one per particle");
  const auto* first = reinterpret_cast<const Vec2*>(values.data());
  return {first, first + values.shape(0)};
}

void set_field(Simulation& simulation, const std::string& name,
               const py::array_t<double, py::array::c_style | py::array::forcecast>& values) {
  const std::vector<Vec2> vectors = vectors_of(values);
  if (name == "position") return simulation.set_positions(vectors);
  if (name == "velocity") return simulation.set_velocities(vectors);
  throw InputError(fmt::format("{}: found no field that can be set, expected position or velocity", name));
}

void refuse_invalid(const Simulation& simulation) {
  if (const auto failure = simulation.failure()) {
    throw InvalidRun(fmt::format("{}: invalid run: {} (step {}, time {:g}, particle {} near ({:g}, {:g}))",
                                 simulation.scene().file, failure->reason, failure->step, failure->time,
                                 failure->id, failure->x.x, failure->x.y));
  }
}

StepReport step(Simulation& simulation, std::optional<double> end) {
  const StepReport report = [&] {
    const py::gil_scoped_release released;
    return simulation.step(end.value_or(std::numeric_limits<double>::infinity()));
  }();
  refuse_invalid(simulation);
  return report;
}

/// Steps up to `time`. After each of them signals are seen to, and `each`, if it is not None, is called.
py::list run(Simulation& simulation, double time, const py::object& each) {
  py::list reports;
  {
    const py::gil_scoped_release released;
    simulation.run(time, [&](const StepReport& report) {
      const py::gil_scoped_acquire acquired;
      reports.append(report);
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      return each.is_none() || !each(report).is(py::bool_(false));
    });
  }
  refuse_invalid(simulation);
  return reports;
}

/// The columns of the series, in its order.
py::dict row_of(const StepReport& report) {
  const Diagnostics& d = report.diagnostics;
  return py::dict("step"_a = report.step, "time"_a = report.time, "dt"_a = report.dt,
                  "iterations"_a = report.iterations, "residual"_a = report.residual,
                  "mean_density"_a = d.mean_density, "mean_compression"_a = d.mean_compression,
                  "max_compression"_a = d.max_compression, "kinetic_energy"_a = d.kinetic_energy,
                  "potential_energy"_a = d.potential_energy, "com_x"_a = d.centre_of_mass.x,
                  "com_y"_a = d.centre_of_mass.y, "max_speed"_a = d.max_speed, "cfl"_a = d.cfl,
                  "wall_force_x"_a = d.wall_force.x, "wall_force_y"_a = d.wall_force.y, "lost"_a = d.lost,
                  "converged"_a = static_cast<int>(report.converged));
}

Device device_for([[maybe_unused]] double particles, const std::string& backend, const std::string& precision,
                  int threads, [[maybe_unused]] std::optional<int> gl_device,
                  [[maybe_unused]] std::optional<std::filesystem::path> shader_dir) {
  const auto its_precision = chosen<Precision>("precision", precision);
  if (backend == "cpu") return cpu::device({.precision = its_precision, .threads = threads});
  if (backend != "gpu") throw InputError(fmt::format("backend: found {}, expected cpu or gpu", backend));
#ifdef SLUICE_WITH_GPU
  if (its_precision == Precision::double_)
    throw InputError("precision: found double with the backend gpu, expected float; double runs on the cpu");
  return gpu::device({.gl_device = gl_device,
                      .shader_dir = std::move(shader_dir),
                      .particles = static_cast<uint64_t>(particles)});
#else
  throw InputError("backend: found gpu, expected cpu: this module was built without OpenGL");
#endif
}

py::handle new_exception(py::module_& module, const char* name, const char* doc, py::handle base,
                         py::handle second = {}) {
  const py::object bases = second ? py::make_tuple(base, second) : py::make_tuple(base);
  py::handle made =
      PyErr_NewExceptionWithDoc(fmt::format("sluice.{}", name).c_str(), doc, bases.ptr(), nullptr);
  module.attr(name) = made;
  return made;
}

/// The errors as exceptions with the same text. They live as long as the interpreter.
void add_errors(py::module_& module) {
  static py::handle error, input, environment, invalid;
  error = new_exception(module, "Error", "What is reported by its message.", PyExc_RuntimeError);
  input = new_exception(module, "InputError", "Bad input: a scene, a setting, a file, an argument.", error,
                        PyExc_ValueError);
  environment = new_exception(module, "EnvironmentError",
                              "The surroundings failed: no OpenGL, a full disk, ...", error);
  invalid =
      new_exception(module, "InvalidRun", "A run that became invalid; Simulation.failure says where.", error);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const InvalidRun& e) {
      PyErr_SetString(invalid.ptr(), e.what());
    } catch (const InputError& e) {
      PyErr_SetString(input.ptr(), e.what());
    } catch (const EnvironmentError& e) {
      PyErr_SetString(environment.ptr(), e.what());
    } catch (const Error& e) {
      PyErr_SetString(error.ptr(), e.what());
    }
  });
}

void add_scene(py::module_& module) {
  py::class_<Scene>(module, "Scene")
      .def_readonly("name", &Scene::name)
      .def_readonly("file", &Scene::file)
      .def_readonly("title", &Scene::title)
      .def_readonly("spacing", &Scene::spacing)
      .def_readonly("rest_density", &Scene::rest_density)
      .def_readonly("dt", &Scene::dt)
      .def_readonly("duration", &Scene::duration)
      .def_property_readonly("smoothing_length", &Scene::smoothing_length)
      .def_property_readonly("mass", &Scene::mass)
      .def_property_readonly("gravity", [](const Scene& scene) { return tuple_of(scene.gravity); })
      .def_property_readonly("domain",
                             [](const Scene& scene) {
                               return py::make_tuple(tuple_of(scene.domain_min), tuple_of(scene.domain_max));
                             })
      .def_property_readonly("_settings", [](const Scene& scene) { return scene.record.settings; })
      .def("_changed", [](const Scene& scene, const Strings& overrides) { return changed(scene, overrides); })
      .def("__repr__",
           [](const Scene& scene) { return fmt::format("<sluice.Scene {}: {}>", scene.name, scene.title); });
  module.def("_load",
             [](const std::string& scene, const Strings& overrides) { return load_scene(scene, overrides); });
  module.def("_parse", [](const std::string& text, const std::string& file, const Strings& overrides) {
    return parse_scene(text, file, overrides);
  });
  module.def("_shipped_scenes", &shipped_scenes);
}

void add_reports(py::module_& module) {
  py::class_<StepReport> report(module, "StepReport");
  report.def_readonly("step", &StepReport::step)
      .def_readonly("time", &StepReport::time)
      .def_readonly("dt", &StepReport::dt)
      .def_readonly("repeats", &StepReport::repeats)
      .def_readonly("iterations", &StepReport::iterations)
      .def_readonly("residual", &StepReport::residual)
      .def_readonly("converged", &StepReport::converged)
      .def_property_readonly(
          "sweeps",
          [](const StepReport& r) {
            py::list sweeps;
            for (const SweepReport& sweep : r.sweeps)
              sweeps.append(py::dict("mean_compression"_a = sweep.mean_compression,
                                     "residual"_a = sweep.residual, "step_length"_a = sweep.step_length));
            return sweeps;
          })
      .def("row", &row_of)
      .def("__repr__", [](const StepReport& r) {
        return fmt::format("<sluice.StepReport step {}, time {:g}, {} iterations{}>", r.step, r.time,
                           r.iterations, r.converged ? "" : ", not converged");
      });
#define DIAGNOSTIC(name) \
  report.def_property_readonly(#name, [](const StepReport& r) { return r.diagnostics.name; })
  DIAGNOSTIC(mean_density);
  DIAGNOSTIC(mean_compression);
  DIAGNOSTIC(max_compression);
  DIAGNOSTIC(kinetic_energy);
  DIAGNOSTIC(potential_energy);
  DIAGNOSTIC(max_speed);
  DIAGNOSTIC(cfl);
  DIAGNOSTIC(lost);
#undef DIAGNOSTIC
  report
      .def_property_readonly("centre_of_mass",
                             [](const StepReport& r) { return tuple_of(r.diagnostics.centre_of_mass); })
      .def_property_readonly("wall_force",
                             [](const StepReport& r) { return tuple_of(r.diagnostics.wall_force); });
  py::class_<Failure>(module, "Failure")
      .def_readonly("step", &Failure::step)
      .def_readonly("time", &Failure::time)
      .def_readonly("id", &Failure::id)
      .def_readonly("reason", &Failure::reason)
      .def_property_readonly("position", [](const Failure& failure) { return tuple_of(failure.x); })
      .def("__repr__", [](const Failure& failure) {
        return fmt::format("<sluice.Failure step {}: {}>", failure.step, failure.reason);
      });
}

void add_simulation(py::module_& module) {
  py::class_<Simulation>(module, "Simulation")
      .def(py::init([](const Scene& scene, const std::string& backend, const std::string& precision,
                       int threads, std::optional<int> gl_device,
                       std::optional<std::filesystem::path> shader_dir) {
             return Simulation(scene, device_for(sample_bounds(scene).fluid, backend, precision, threads,
                                                 gl_device, shader_dir));
           }),
           Released())
      .def(py::init([](const std::filesystem::path& checkpoint, const std::string& backend,
                       const std::string& precision, int threads, std::optional<int> gl_device,
                       std::optional<std::filesystem::path> shader_dir) {
             return Simulation::resume(checkpoint,
                                       device_for(0, backend, precision, threads, gl_device, shader_dir));
           }),
           Released())
      .def("step", &step, "end"_a = py::none())
      .def("_run", &run)
      .def_property_readonly("scene", [](const Simulation& simulation) { return simulation.scene(); })
      .def_property_readonly("particles", &Simulation::particles)
      .def_property_readonly("boundary", [](const Simulation& s) { return copy_of(s.samples().boundary); })
      .def_property_readonly("steps", &Simulation::steps)
      .def_property_readonly("time", &Simulation::time)
      .def_property_readonly("dt", &Simulation::dt)
      .def_property_readonly("failure", &Simulation::failure)
      .def_property_readonly("backend", [](const Simulation& s) { return s.device().name(); })
      .def_property_readonly("device", [](const Simulation& s) { return s.device().description(); })
      .def_property_readonly("precision",
                             [](const Simulation& s) { return std::string(name_of(s.device().precision())); })
      .def_property_readonly("threads", [](const Simulation& s) { return s.device().threads(); })
      .def_property_readonly("warnings", &Simulation::warnings)
      .def_property_readonly("fields",
                             [](const Simulation& simulation) {
                               py::dict fields;
                               for (const auto& [name, unit, meaning] : simulation.fields())
                                 fields[py::str(std::string(name))] = fmt::format("{} [{}]", meaning, unit);
                               return fields;
                             })
      .def("_field", [](const Simulation& s, const std::string& name) { return array_of(s.field(name)); })
      .def("_field_in_memory",
           [](py::object self, const std::string& name) {
             const FieldView view = self.cast<const Simulation&>().field_in_memory(name);
             return view.in_place ? array_of(view, self) : array_of(view);
           })
      .def(
          "values_at",
          [](const Simulation& simulation, std::pair<double, double> point) {
            const PointValues there = simulation.values_at({point.first, point.second});
            return py::dict("pressure"_a = there.pressure, "density"_a = there.density,
                            "velocity"_a = tuple_of(there.velocity));
          },
          "point"_a)
      .def("probes",
           [](const Simulation& simulation) {
             py::dict probes;
             for (const auto& [name, value] : simulation.probes()) probes[py::str(name)] = value;
             return probes;
           })
      .def("wall_forces",
           [](const Simulation& simulation) {
             py::dict forces;
             for (const auto& [name, wall] : simulation.wall_forces())
               forces[py::str(name)] = py::dict("force"_a = tuple_of(wall.force), "torque"_a = wall.torque);
             return forces;
           })
      .def("report_sweeps", &Simulation::report_sweeps)
      .def("set_field", &set_field, "name"_a, "values"_a)
      .def("write_state", &Simulation::write_state, "path"_a)
      .def("write_checkpoint", &Simulation::write_checkpoint, "path"_a)
      .def("_summary", &Simulation::summary)
      .def("_snapshot", &Simulation::snapshot);
}

void add_recording(py::module_& module) {
  using media::Moment;
  using media::Recording;
  py::class_<Snapshot>(module, "_Snapshot");
  py::class_<Moment>(module, "Moment")
      .def_readonly("report", &Moment::report)
      .def_property_readonly("step", [](const Moment& m) { return m.report.step; })
      .def_property_readonly("time", [](const Moment& m) { return m.report.time; })
      .def_readonly("_snapshot", &Moment::state)
      .def_property_readonly("position", [](const Moment& m) { return copy_of(m.state.x); })
      .def_property_readonly("velocity", [](const Moment& m) { return copy_of(m.state.v); })
      .def_property_readonly("density", [](const Moment& m) { return copy_of(m.state.density); })
      .def_property_readonly("pressure", [](const Moment& m) { return copy_of(m.state.pressure); });
  py::class_<Recording>(module, "Recording")
      .def(py::init([](const std::filesystem::path& path) { return Recording(path); }))
      .def_property_readonly("scene", [](const Recording& recording) { return recording.scene(); })
      .def_property_readonly("precision",
                             [](const Recording& r) { return std::string(name_of(r.precision())); })
      .def_property_readonly("boundary", [](const Recording& r) { return copy_of(r.samples().boundary); })
      .def("__len__", &Recording::frames)
      .def("_moment", &Recording::moment);
}

#ifdef SLUICE_WITH_GPU
void add_pictures(py::module_& module) {
  using media::Pictures;
  py::class_<Pictures>(module, "_Pictures")
      .def(py::init([](const Scene& scene, std::optional<std::pair<uint32_t, uint32_t>> size,
                       std::optional<std::string> colour) {
        media::PictureOptions options;
        if (size) options.size = glm::uvec2(size->first, size->second);
        if (colour) options.colour = chosen<Colour>("colour", *colour);
        return Pictures(scene, options);
      }))
      .def("draw", [](Pictures& pictures, const Snapshot& state, double dt) {
        const draw::Image image = pictures.draw(state, dt);
        return py::array_t<uint8_t>({size_t{image.height}, size_t{image.width}, size_t{3}}, image.rgb.data());
      });
}
#endif

}  // namespace
}  // namespace sluice

PYBIND11_MODULE(_sluice, module) {
  module.doc() = "The compiled part of sluice.";
  module.attr("__version__") = sluice::version();
  module.attr("commit") = sluice::commit();
  sluice::add_errors(module);
  sluice::add_scene(module);
  sluice::add_reports(module);
  sluice::add_simulation(module);
  sluice::add_recording(module);
#ifdef SLUICE_WITH_GPU
  sluice::add_pictures(module);
#endif
}
