// The plain stage, compiled for each set of instructions: a compiler finds the cells of several particles at
// a time, which takes half as long.
#include "cpu/simd/instructions.hpp"
// clang-format off: not before that
#include "cpu/grid_count.cpp"
