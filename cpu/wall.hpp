// The wall's part in the pressure force; twin of shaders/lib/wall.glsl.
#pragma once

#include "cpu/instructions.hpp"

namespace sluice::cpu::SLUICE_SET {

/// What the pressure force has at the boundary in place of q_i + q_j: q_i + p_i/rho0^2 where samples mirror
/// the pressure.
template <class Real, class Value>
Value wall_pressure_term(const ParamsOf<Real>& params, Value q, Value rho) {
  return q + q * (rho * rho) * params.wall_pressure;
}

}  // namespace sluice::cpu::SLUICE_SET
