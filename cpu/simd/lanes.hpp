// Particles side by side: the same arithmetic for as many reals as fit into a register of the instruction set
// that is compiled for. Each lane belongs to one particle and rounds as a plain real does.
#pragma once

#include "cpu/simd/instructions.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
inline constexpr uint32_t lane_count = vector_bytes / sizeof(Real);

template <class T, uint32_t count>
struct VectorOf {
  typedef T type __attribute__((vector_size(count * sizeof(T))));
};
/// Operators work lane by lane; comparisons give masks, all bits of a lane or none.
template <class Real>
using Vector = typename VectorOf<Real, lane_count<Real>>::type;
/// Numbers of as many particles as there are lanes.
template <class Real>
using Indices = typename VectorOf<uint32_t, lane_count<Real>>::type;

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
Pair(Value, Value) -> Pair<Value>;

template <class Value>
Pair<Value> operator-(const Pair<Value>& a, const Pair<Value>& b) {
  return {a.x - b.x, a.y - b.y};
}

template <class Value>
Pair<Value> operator+(const Pair<Value>& a, const Pair<Value>& b) {
  return {a.x + b.x, a.y + b.y};
}
template <class Value>
Pair<Value> operator-(const Pair<Value>& a) {
  return {-a.x, -a.y};
}
template <class Value>
Pair<Value>& operator+=(Pair<Value>& a, const Pair<Value>& b) {
  return a = a + b;
}
template <class Value>
Pair<Value>& operator-=(Pair<Value>& a, const Pair<Value>& b) {
  return a = a - b;
}
template <class Factor, class Value>
Pair<Value> operator*(Factor factor, const Pair<Value>& a) {
  return {factor * a.x, factor * a.y};
}
template <class Value>
Pair<Value> operator/(const Pair<Value>& a, Value divisor) {
  return {a.x / divisor, a.y / divisor};
}

template <class Value>
Value dot(const Pair<Value>& a, const Pair<Value>& b) {
  return a.x * b.x + a.y * b.y;
}

template <class Real>
Vector<Real> broadcast(Real value) {
  return value - Vector<Real>{};
}

template <class Vector>
Vector load_as(const void* from) {
  Vector values;
  std::memcpy(&values, from, sizeof values);
  return values;
}
template <std::floating_point Real>
auto load(const Real* from) {
  return load_as<Vector<Real>>(from);
}

template <class Vector, class T>
requires std::is_arithmetic_v<T>
void store(Vector values, T* to) { std::memcpy(to, &values, sizeof values); }

/// Splits coordinates (x y x y ...) in two vectors.
template <class V, int... lane>
Pair<V> split(V a, V b, std::integer_sequence<int, lane...>) {
  return {__builtin_shufflevector(a, b, (2 * lane)...), __builtin_shufflevector(a, b, (2 * lane + 1)...)};
}
template <class V>
Pair<V> split(V a, V b) {
  return split(a, b, std::make_integer_sequence<int, sizeof(V) / sizeof(a[0])>());
}

/// The positions (or other vectors) from `from` on.
template <class Real>
Pair<Vector<Real>> load(const glm::vec<2, Real>* from) {
  return split(load(&from[0].x), load(&from[lane_count<Real> / 2].x));
}

/// The same, of vectors of four.
template <class Real>
struct Quad {
  Vector<Real> x, y, z, w;
};
template <class Real>
Quad<Real> load(const glm::vec<4, Real>* from) {
  constexpr uint32_t each = lane_count<Real>;
  const auto [xz_0, yw_0] = split(load(&from->x), load(&from->x + each));
  const auto [xz_1, yw_1] = split(load(&from->x + 2 * each), load(&from->x + 3 * each));
  const auto [x, z] = split(xz_0, xz_1);
  const auto [y, w] = split(yw_0, yw_1);
  return {x, y, z, w};
}

/// Stores coordinates as they are loaded.
template <class Real, int... lane>
void store(const Pair<Vector<Real>>& values, glm::vec<2, Real>* to, std::integer_sequence<int, lane...>) {
  constexpr int half = lane_count<Real> / 2, width = lane_count<Real>;
  store(__builtin_shufflevector(values.x, values.y, (lane / 2 + lane % 2 * width)...), &to[0].x);
  store(__builtin_shufflevector(values.x, values.y, (half + lane / 2 + lane % 2 * width)...), &to[half].x);
}
template <class Real>
void store(const Pair<Vector<Real>>& values, glm::vec<2, Real>* to) {
  store(values, to, std::make_integer_sequence<int, lane_count<Real>>());
}

/// Lane by lane, for every processor.
namespace by_lane {

template <class V>
V square_root(V values) {
  for (uint32_t lane = 0; lane < sizeof(V) / sizeof(values[0]); ++lane)
    values[lane] = std::sqrt(values[lane]);
  return values;
}
template <class V, class Real>
uint32_t bits_below(V values, Real bound) {
  uint32_t bits = 0;
  for (uint32_t lane = 0; lane < sizeof(V) / sizeof(Real); ++lane)
    bits |= (values[lane] < bound ? 1u : 0u) << lane;
  return bits;
}

/// The values of the particles `j`, loaded one by one and put together; vectors of floats in one piece, since
/// a register put together in memory from pieces would wait for them.
template <std::floating_point Real, int... lane>
auto gather(const Real* from, Indices<Real> j, std::integer_sequence<int, lane...>) {
  return Vector<Real>{from[j[lane]]...};
}
template <int... lane>
Vector<float> gather_half(const glm::vec2* from, Indices<float> j, std::integer_sequence<int, lane...>,
                          auto first) {
  return reinterpret_cast<Vector<float>>(Vector<double>{load_as<double>(from + j[first + lane])...});
}
template <int... lane>
Pair<Vector<float>> gather(const glm::vec2* from, Indices<float> j, std::integer_sequence<int, lane...>) {
  constexpr int half = sizeof...(lane) / 2;
  constexpr auto each = std::make_integer_sequence<int, half>();
  return split(gather_half(from, j, each, std::integral_constant<int, 0>()),
               gather_half(from, j, each, std::integral_constant<int, half>()));
}
template <int... lane>
Pair<Vector<double>> gather(const glm::dvec2* from, Indices<double> j, std::integer_sequence<int, lane...>) {
  return {Vector<double>{from[j[lane]].x...}, Vector<double>{from[j[lane]].y...}};
}
template <class T, class J>
auto gather(const T* from, J j) {
  return gather(from, j, std::make_integer_sequence<int, sizeof(J) / sizeof(uint32_t)>());
}

}  // namespace by_lane

// square_root(values); bits_below(values, bound), where bit l is whether lane l is below it; gather(from, j),
// the values of the particles j of a field of reals or of vectors.
#if SLUICE_VECTOR_BYTES == 64

inline Vector<float> square_root(Vector<float> values) { return _mm512_maskz_sqrt_ps(0xffff, values); }
inline Vector<double> square_root(Vector<double> values) { return _mm512_maskz_sqrt_pd(0xff, values); }
inline uint32_t bits_below(Vector<float> values, float bound) {
  return _mm512_cmp_ps_mask(values, broadcast(bound), _CMP_LT_OQ);
}
inline uint32_t bits_below(Vector<double> values, double bound) {
  return _mm512_cmp_pd_mask(values, broadcast(bound), _CMP_LT_OQ);
}

inline Vector<double> gather_8(const void* from, __m256i j) {
  return _mm512_mask_i32gather_pd(_mm512_setzero_pd(), 0xff, j, from, 8);
}
inline Vector<float> gather(const float* from, Indices<float> j) {
  return _mm512_mask_i32gather_ps(_mm512_setzero_ps(), 0xffff, reinterpret_cast<__m512i>(j), from, 4);
}
inline Vector<double> gather(const double* from, Indices<double> j) {
  return gather_8(from, reinterpret_cast<__m256i>(j));
}
inline Pair<Vector<float>> gather(const glm::vec2* from, Indices<float> j) {
  const auto low = __builtin_shufflevector(j, j, 0, 1, 2, 3, 4, 5, 6, 7),
             high = __builtin_shufflevector(j, j, 8, 9, 10, 11, 12, 13, 14, 15);
  const auto first = gather_8(from, reinterpret_cast<__m256i>(low)),
             second = gather_8(from, reinterpret_cast<__m256i>(high));
  return split(reinterpret_cast<Vector<float>>(first), reinterpret_cast<Vector<float>>(second));
}
inline Pair<Vector<double>> gather(const glm::dvec2* from, Indices<double> j) {
  const auto twice = reinterpret_cast<__m256i>(j + j);
  return {gather_8(&from->x, twice), gather_8(&from->y, twice)};
}

#elif SLUICE_VECTOR_BYTES == 32

inline Vector<float> square_root(Vector<float> values) { return _mm256_sqrt_ps(values); }
inline Vector<double> square_root(Vector<double> values) { return _mm256_sqrt_pd(values); }
inline uint32_t bits_below(Vector<float> values, float bound) {
  return static_cast<uint32_t>(_mm256_movemask_ps(reinterpret_cast<__m256>(values < bound)));
}
inline uint32_t bits_below(Vector<double> values, double bound) {
  return static_cast<uint32_t>(_mm256_movemask_pd(reinterpret_cast<__m256d>(values < bound)));
}

// Loads put together are faster than the gathers of AVX2.
using by_lane::gather;

#else

#ifdef __SSE2__
inline Vector<float> square_root(Vector<float> values) { return _mm_sqrt_ps(values); }
inline Vector<double> square_root(Vector<double> values) { return _mm_sqrt_pd(values); }
inline uint32_t bits_below(Vector<float> values, float bound) {
  return static_cast<uint32_t>(_mm_movemask_ps(reinterpret_cast<__m128>(values < bound)));
}
inline uint32_t bits_below(Vector<double> values, double bound) {
  return static_cast<uint32_t>(_mm_movemask_pd(reinterpret_cast<__m128d>(values < bound)));
}
#else
using by_lane::bits_below;
using by_lane::square_root;
#endif
using by_lane::gather;

#endif

}  // namespace sluice::cpu::SLUICE_SET
