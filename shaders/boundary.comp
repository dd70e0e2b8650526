// All that a particle needs of the boundary in this step, summed once [Hunkler 2022, section 5.2; Akinci et al. 2012].
// With m_b the mass of a sample, m with a mirror boundary, else Psi_b:
//   wall_density = sum_b m_b W_ib        B_i = sum_b m_b dW_ib
//   wall_gradient_squares = sum_b |m dW_ib|^2, with the thesis's wall term of the linear system
//   wall_viscosity = sum_b m_b dW_ib x_ib^T / (x_ib.x_ib + 0.01 H^2)
// With the symmetric wall term of the linear system B_i is twice that.

#include "lib/grid.glsl"
#include "lib/kernel.glsl"

void run(uint i) {
  vec2 x_i = load(x, i);
  uint middle = cell_of(x_i);
  precise float W = 0.0, squares = 0.0;
  precise vec2 gradient = vec2(0.0);
  precise vec4 tensor = vec4(0.0);
  for (uint row = 0u; row < 3u; ++row) {
    uint first = load(C_boundary, middle + row * params.columns - params.columns - 1u);
    uint last = load(C_boundary, middle + row * params.columns - params.columns + 2u);
    for (uint b = first; b < last; ++b) {
      precise vec2 x_ib = x_i - load(x_boundary, b);
      precise float r_squared = dot_of(x_ib, x_ib);
      if (!(r_squared < params.support_squared)) continue;
      precise float r = sqrt(r_squared);
      vec2 dW = kernel_gradient(x_ib, r);
      float mass = needs_pseudo_mass ? load(Psi, b) : 1.0;  // in units of params.wall_mass
      W += mass * kernel(r);
      gradient += mass * dW;
      squares += dot_of(dW, dW);
      if (needs_wall_viscosity) {
        precise vec2 y = (mass * x_ib) / (r_squared + params.viscosity_floor);
        tensor += vec4(dW.x * y.x, dW.x * y.y, dW.y * y.x, dW.y * y.y);
      }
    }
  }
  W *= params.wall_mass;
  gradient *= params.wall_gradient_mass;
  squares *= params.m * params.m;
  tensor *= params.wall_mass;
  wall_density[i] = W;
  wall_gradient[i] = gradient;
  if (needs_thesis_wall) wall_gradient_squares[i] = squares;
  if (needs_wall_viscosity) wall_viscosity[i] = tensor;
}
