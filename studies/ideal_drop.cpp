// The classical method of Runge and Kutta.
#include "studies/ideal_drop.hpp"

#include <algorithm>
#include <cmath>

namespace sluice::study {
namespace {

using State = IdealDrop::State;

constexpr double angle_per_step = 1e-3;

State moved(const State& state, const State& by, double times) {
  return {state.rate + times * by.rate, state.a + times * by.a, state.b + times * by.b};
}

State derivative(const State& now, double omega_squared) {
  const double a = now.a * now.a, b = now.b * now.b;
  return {(now.rate * now.rate + omega_squared) * (b - a) / (b + a), now.rate * now.a, -now.rate * now.b};
}

State step(const State& now, double omega_squared, double dt) {
  const State k1 = derivative(now, omega_squared);
  const State k2 = derivative(moved(now, k1, dt / 2), omega_squared);
  const State k3 = derivative(moved(now, k2, dt / 2), omega_squared);
  const State k4 = derivative(moved(now, k3, dt), omega_squared);
  return moved(moved(moved(moved(now, k1, dt / 6), k2, dt / 3), k3, dt / 3), k4, dt / 6);
}

/// A rate at which the drop changes: of no step it is a large part.
double quickness(const IdealDrop& drop) {
  return std::max(std::abs(drop.rate), std::sqrt(drop.omega_squared));
}

}  // namespace

State IdealDrop::at(double time) const {
  const double steps = std::max(1.0, std::ceil(time * quickness(*this) / angle_per_step));
  State state{rate, radius, radius};
  for (double done = 0; done < steps; ++done) state = step(state, omega_squared, time / steps);
  return state;
}

double IdealDrop::period() const {
  // Round, and moving as at the start, for the first time: with A - B of the sign of s just behind it.
  const double dt = angle_per_step / quickness(*this);
  const auto lead = [&](const State& state) { return std::copysign(1.0, rate) * (state.a - state.b); };
  State state{rate, radius, radius};
  double time = 0;
  bool has_turned = false;
  for (;;) {
    const State next = step(state, omega_squared, dt);
    if (lead(next) < 0) has_turned = true;
    if (has_turned && lead(next) >= 0) break;
    state = next;
    time += dt;
  }
  double low = 0, high = dt;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (low + high) / 2;
    (lead(step(state, omega_squared, middle)) < 0 ? low : high) = middle;
  }
  return time + low;
}

}  // namespace sluice::study
