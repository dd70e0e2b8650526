// What the pressure force has at the boundary in place of q_i + q_j: q_i + p_i/rho0^2 where samples mirror the pressure;
// twin of cpu/wall.hpp.

float wall_pressure_term(float q_i, float rho_i) {
  precise float term = q_i + q_i * (rho_i * rho_i) * params.wall_pressure;
  return term;
}
