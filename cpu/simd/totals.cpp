// The plain stage, compiled for each set of instructions: three-operand instructions shorten the sums.
#include "cpu/simd/instructions.hpp"
// clang-format off: not before that
#include "cpu/totals.cpp"
