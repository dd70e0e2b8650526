// What the series and the summary report, per chunk of 64 particles and in their order: sums of density, compression,
// speed squared, position and force on the walls, the number of lost particles, and the largest compression, speed
// squared and change of velocity squared.

#include "lib/vectors.glsl"
#include "lib/wall.glsl"

bool is_lost(vec2 at) {
  return at.x < 0.0 || at.x > params.extent.x || at.y < 0.0;
}

void run(uint chunk) {
  precise float density = 0.0, compression = 0.0, speed_squared = 0.0, lost = 0.0;
  float max_compression = 0.0, max_speed_squared = 0.0, max_speed_change_squared = 0.0;
  precise vec2 position = vec2(0.0), wall_force = vec2(0.0);
  for (uint i = chunk * chunk_width; i < min((chunk + 1u) * chunk_width, params.n); ++i) {
    vec2 x_i = load(x_in, i), v_i = load(v_in, i);
    float rho_i = load(rho, i);
    precise float above = (rho_i - params.rho0) / params.rho0;
    above = larger(0.0, above);
    float square = dot_of(v_i, v_i);
    density += rho_i;
    compression += above;
    speed_squared += square;
    position += x_i;
    if (needs_boundary) {
      wall_force += (params.m * wall_pressure_term(load(q, i), rho_i)) * load(wall_gradient, i);
    }
    lost += is_lost(x_i) ? 1.0 : 0.0;
    max_compression = larger(max_compression, above);
    max_speed_squared = larger(max_speed_squared, square);
    precise vec2 change = v_i - load(v, i);
    max_speed_change_squared = larger(max_speed_change_squared, dot_of(change, change));
  }
  diagnostic_sums[total_density * count + chunk] = density;
  diagnostic_sums[total_compression * count + chunk] = compression;
  diagnostic_sums[total_speed_squared * count + chunk] = speed_squared;
  diagnostic_sums[total_x * count + chunk] = position.x;
  diagnostic_sums[total_y * count + chunk] = position.y;
  diagnostic_sums[total_wall_force_x * count + chunk] = wall_force.x;
  diagnostic_sums[total_wall_force_y * count + chunk] = wall_force.y;
  diagnostic_sums[total_lost * count + chunk] = lost;
  diagnostic_sums[total_max_compression * count + chunk] = max_compression;
  diagnostic_sums[total_max_speed_squared * count + chunk] = max_speed_squared;
  diagnostic_sums[total_max_speed_change_squared * count + chunk] = max_speed_change_squared;
}
