// Limits of a scene that are known before its first step.
#pragma once

#include <string>
#include <vector>

#include "sluice/sampling.hpp"
#include "sluice/scene.hpp"

namespace sluice {

/// Largest alpha with which XSPH smooths; beyond it, it overshoots.
inline constexpr double largest_alpha = 2;

/// Time step of the scene, or the smallest one where steps adapt.
double least_dt(const Scene& scene);

/// Key of the scene that holds a state equation's stiffness.
std::string stiffness_key(PressureMethod method);

/// What tends to go wrong and is known before the first step: an explicit viscosity, a state equation, the
/// pressure of deep fluid or XSPH beyond its limit, sound slower than the fluid, mirror walls of too few
/// layers.
std::vector<std::string> beyond_limits(const Scene& scene, const Samples& samples);

}  // namespace sluice
