// The text of scene files, part by part.
#include "studies/hard_scenes.hpp"

namespace sluice::study {
namespace {

std::string text_of(Vec2 a) { return fmt::format("[{}, {}]", a.x, a.y); }

}  // namespace

Method iisph() {
  return {"IISPH", "iisph",
          "method = \"iisph\"\n[pressure.iisph]\nsolver = \"barzilai-borwein\"\nwall = \"symmetric\"\n"
          "warm_start = 1.0\n"};
}

Method iisph_of_the_thesis() { return {"IISPH, thesis", "thesis", "method = \"iisph\"\n[pressure.iisph]\n"}; }

Method at_tolerance(const Method& method, double tolerance) {
  return {fmt::format("{}, tolerance {:g}", method.label, tolerance), fmt::format("{}_tight", method.suffix),
          fmt::format("{}tolerance = {:g}\n", method.text, tolerance)};
}

Method gentle(const Method& method) {
  return {fmt::format("{}, source weight 0.1", method.label), fmt::format("{}_gentle", method.suffix),
          fmt::format("{}source_weight = 0.1\n", method.text)};
}

Method ssph(double stiffness) {
  return {"SSPH", "ssph", fmt::format("method = \"ssph\"\n[pressure.ssph]\nstiffness = {:.6g}\n", stiffness)};
}

Method wcsph(double kappa) {
  return {"WCSPH", "wcsph", fmt::format("method = \"wcsph\"\n[pressure.wcsph]\nkappa = {:.6g}\n", kappa)};
}

std::string block(Vec2 min, uint32_t columns, uint32_t rows, Vec2 velocity, Vec2 origin) {
  return fmt::format("[[fluid.rect]]\nmin = {}\ncount = [{}, {}]\nvelocity = {}\n", text_of(origin + min),
                     columns, rows, text_of(velocity));
}

std::string shrinking_block(Vec2 min, uint32_t columns, uint32_t rows, double within) {
  return fmt::format("{}velocity_gradient = [[{}, 0], [0, {}]]\n", block(min, columns, rows), -1 / within,
                     -1 / within);
}

std::string container(const SceneParts& parts, uint32_t layers, bool closed) {
  return fmt::format("[[boundary.container]]\nmin = {}\nmax = {}\nlayers = {}\n{}", text_of(parts.origin),
                     text_of(parts.origin + parts.size), layers,
                     closed ? "sides = [\"left\", \"right\", \"bottom\", \"top\"]\n" : "");
}

std::string fixed(double dt, double duration) {
  return fmt::format("dt = {:.6g}\nduration = {:g}\n", dt, duration);
}

std::string adaptive(double duration, double dt_max, double dt_min, double cfl) {
  return fmt::format("cfl = {:g}\ndt_min = {:g}\ndt_max = {:.6g}\nduration = {:g}\n", cfl, dt_min, dt_max,
                     duration);
}

std::string scene_text(const SceneParts& parts) {
  std::string text = fmt::format(
      "[scene]\ntitle = \"{}\"\n\n[particles]\nspacing = {:g}\nrest_density = 1\n\n[domain]\nmin = {}\nmax = "
      "{}\n\n[fluid]\ngravity = [0, {}]\n{}\n",
      parts.title, h, text_of(parts.origin), text_of(parts.origin + parts.size), -parts.gravity, parts.fluid);
  if (!parts.boundary.empty())
    text += fmt::format("[boundary]\nmodel = \"{}\"\n{}\n", parts.boundary_model, parts.boundary);
  if (parts.nu > 0)
    text += fmt::format("[viscosity]\nmodel = \"laplacian\"\ncoefficient = {:g}\n\n", parts.nu);
  return text + fmt::format("[pressure]\n{}\n[time]\n{}", parts.method.text, parts.time);
}

SceneParts full_tank(const std::string& title, uint32_t columns, uint32_t rows, const Method& method) {
  SceneParts tank;
  tank.title = title;
  tank.size = {(columns + 5) * h, (1.2 * rows + 20) * h};
  tank.fluid = block({3 * h, 3 * h}, columns, rows);
  tank.boundary = container(tank);
  tank.method = method;
  return tank;
}

SceneParts dam(const std::string& title, const Method& method, double length, Vec2 origin) {
  SceneParts dam;
  dam.title = title;
  dam.origin = origin;
  dam.size = {length, 600};
  dam.fluid = block({3 * h, 3 * h}, 22, 30, {}, origin);
  dam.boundary = container(dam);
  dam.method = method;
  return dam;
}

}  // namespace sluice::study
