// The plain stage, compiled for each set of instructions: a compiler makes wide registers of it by itself.
#include "cpu/simd/instructions.hpp"
// clang-format off: not before that
#include "cpu/predict.cpp"
