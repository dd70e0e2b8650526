// What every stage includes first. The stages of cpu/ are compiled once, as they are, for any processor;
// those of cpu/simd/ once for each set of instructions, in a namespace of the set's name. What both use, and
// plain stages that are worth compiling for wide registers too, are written for the namespace SLUICE_SET.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <numeric>
#include <vector>

#include "core/model/larger.hpp"
#include "core/model/stages.hpp"
#include "cpu/state.hpp"
#include "sluice/choices.hpp"

#ifndef SLUICE_SET
#define SLUICE_SET plain
#endif

namespace sluice::cpu {
namespace SLUICE_SET {}
using namespace SLUICE_SET;
}  // namespace sluice::cpu
