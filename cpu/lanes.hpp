// Particles side by side: the same arithmetic for as many reals as fit into 16 bytes, a register that every
// x86-64 processor has. Each lane belongs to one particle and rounds as a plain real does.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>
#include <type_traits>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace sluice::cpu {

inline constexpr uint32_t vector_bytes = 16;
template <class Real>
inline constexpr uint32_t lane_count = vector_bytes / sizeof(Real);

template <class T>
struct VectorOf {
  typedef T type __attribute__((vector_size(vector_bytes)));
};
/// Operators work lane by lane; comparisons give masks, all bits of a lane or none.
template <class T>
using Vector = typename VectorOf<T>::type;

/// What comparing two vectors of reals gives: integers of the same size.
template <class Real>
using Mask = decltype(Vector<Real>{} < Vector<Real>{});
template <class Real>
using MaskElement = std::remove_cvref_t<decltype(Mask<Real>{}[0])>;

/// Coordinates of particles side by side.
template <class Value>
struct Pair {
  Value x, y;
};

template <class Value>
Pair<Value> operator-(const Pair<Value>& a, const Pair<Value>& b) {
  return {a.x - b.x, a.y - b.y};
}

template <class Value>
Value dot(const Pair<Value>& a, const Pair<Value>& b) {
  return a.x * b.x + a.y * b.y;
}

template <class Real>
Vector<Real> broadcast(Real value) {
  return value - Vector<Real>{};
}

template <class Real>
Vector<Real> load(const Real* from) {
  Vector<Real> values;
  std::memcpy(&values, from, sizeof values);
  return values;
}

template <class Real>
void store(Vector<Real> values, Real* to) {
  std::memcpy(to, &values, sizeof values);
}

/// Splits coordinates (x y x y ...) in two vectors.
inline Pair<Vector<float>> split(Vector<float> a, Vector<float> b) {
  return {__builtin_shufflevector(a, b, 0, 2, 4, 6), __builtin_shufflevector(a, b, 1, 3, 5, 7)};
}
inline Pair<Vector<double>> split(Vector<double> a, Vector<double> b) {
  return {__builtin_shufflevector(a, b, 0, 2), __builtin_shufflevector(a, b, 1, 3)};
}

/// The positions (or other vectors) from `from` on.
template <class Real>
Pair<Vector<Real>> load_pairs(const glm::vec<2, Real>* from) {
  return split(load(&from[0].x), load(&from[lane_count<Real> / 2].x));
}

/// The positions (or other vectors) of the particles `j`. Each is loaded in one piece: a register put
/// together in memory from pieces would wait for them.
inline Pair<Vector<float>> gather(const glm::vec2* from, const uint32_t* j) {
  const auto two = [&](uint32_t a, uint32_t b) {
    double first, second;
    std::memcpy(&first, &from[a], sizeof first);
    std::memcpy(&second, &from[b], sizeof second);
    return reinterpret_cast<Vector<float>>(Vector<double>{first, second});
  };
  return split(two(j[0], j[1]), two(j[2], j[3]));
}
inline Pair<Vector<double>> gather(const glm::dvec2* from, const uint32_t* j) {
  return split(load(&from[j[0]].x), load(&from[j[1]].x));
}

/// The same for a field of reals.
inline Vector<float> gather(const float* from, const uint32_t* j) {
  return Vector<float>{from[j[0]], from[j[1]], from[j[2]], from[j[3]]};
}
inline Vector<double> gather(const double* from, const uint32_t* j) {
  return Vector<double>{from[j[0]], from[j[1]]};
}

/// What follows twice, once for every processor and once for those with SSE2.
namespace by_lane {

template <class V>
V square_root(V values) {
  for (uint32_t lane = 0; lane < sizeof(V) / sizeof(values[0]); ++lane)
    values[lane] = std::sqrt(values[lane]);
  return values;
}
template <class V>
uint32_t bits_of(V mask) {
  uint32_t bits = 0;
  for (uint32_t lane = 0; lane < sizeof(V) / sizeof(mask[0]); ++lane)
    bits |= (mask[lane] != 0 ? 1u : 0u) << lane;
  return bits;
}

}  // namespace by_lane

#ifdef __SSE2__
inline Vector<float> square_root(Vector<float> values) { return _mm_sqrt_ps(values); }
inline Vector<double> square_root(Vector<double> values) { return _mm_sqrt_pd(values); }
/// Bit l is whether lane l of the mask is set.
inline uint32_t bits_of(Mask<float> mask) {
  return static_cast<uint32_t>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
}
inline uint32_t bits_of(Mask<double> mask) {
  return static_cast<uint32_t>(_mm_movemask_pd(reinterpret_cast<__m128d>(mask)));
}
#else
using by_lane::bits_of;
using by_lane::square_root;
#endif

}  // namespace sluice::cpu
