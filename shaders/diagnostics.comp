// What the series and the summary report, per chunk of 64 particles and in their order: sums of density, compression,
// speed squared, position and force on the walls, the number of lost particles, and the largest compression and speed
// squared. The invocations first put their particle's values side by side, then each of a few sums one quantity.

#include "lib/vectors.glsl"

shared float values[group_size * total_count];

bool is_lost(vec2 at) {
  return at.x < params.domain_min.x || at.x > params.domain_max.x || at.y < params.domain_min.y;
}

void put(uint total, float value) {
  values[total * group_size + gl_LocalInvocationIndex] = value;
}

void put_particle(uint i) {
  vec2 at = x_in[i], v_i = v_in[i];
  precise float relative = rho[i] / params.rho0 - 1.0;
  float compression = relative < 0.0 ? 0.0 : relative;
  float speed_squared = dot_of(v_i, v_i);
  precise vec2 force = vec2(0.0);
  if (walls) {
    precise float pressure = q[i] + p[i] * params.wall_pressure;
    force = (params.m * pressure) * wall_gradient[i];
  }
  put(total_density, rho[i]);
  put(total_compression, compression);
  put(total_speed_squared, speed_squared);
  put(total_x, at.x);
  put(total_y, at.y);
  put(total_wall_force_x, force.x);
  put(total_wall_force_y, force.y);
  put(total_lost, is_lost(at) ? 1.0 : 0.0);
  put(total_max_compression, compression);
  put(total_max_speed_squared, speed_squared);
}

void run_group(uint group) {
  uint lane = gl_LocalInvocationIndex;
  uint i = group * group_size + lane;
  if (i < count) put_particle(i);
  barrier();
  uint total = lane % chunk_width, first = lane - total;
  uint first_particle = group * group_size + first;
  if (total >= total_count || first_particle >= count) return;
  uint last = min(first + chunk_width, count - group * group_size);
  precise float result = 0.0;
  for (uint k = first; k < last; ++k) {
    float value = values[total * group_size + k];
    if (total >= first_max_total)
      result = larger(result, value);
    else
      result += value;
  }
  uint chunks = (count + chunk_width - 1u) / chunk_width;
  diagnostic_sums[total * chunks + first_particle / chunk_width] = result;
}
