// From lists that stand one after the other to lists side by side.
#pragma once

#include "cpu/simd/lanes.hpp"

namespace sluice::cpu::SLUICE_SET {

using Words = typename VectorOf<uint32_t, vector_bytes / sizeof(uint32_t)>::type;
inline constexpr uint32_t word_count = vector_bytes / sizeof(uint32_t);

template <class V, int... lane>
auto join(V a, V b, std::integer_sequence<int, lane...>) {
  return __builtin_shufflevector(a, b, lane...);
}
/// Four words of every fourth list, `lists` apart.
template <uint32_t count, class List>
auto load_fours(const List* lists, size_t entry) {
  if constexpr (count == 4) {
    return load_as<typename VectorOf<uint32_t, 4>::type>(&(*lists)[entry]);
  } else {
    return join(load_fours<count / 2>(lists, entry), load_fours<count / 2>(lists + count / 2, entry),
                std::make_integer_sequence<int, count>());
  }
}

/// In each four of lanes: the lower (or, with offset = 2, the upper) two of a and b, one by one in turns or
/// pair by pair.
template <int offset, int... lane>
Words in_turns(Words a, Words b, std::integer_sequence<int, lane...>) {
  constexpr int width = word_count;
  return __builtin_shufflevector(a, b, (lane / 4 * 4 + lane % 4 / 2 + offset + lane % 2 * width)...);
}
template <int offset, int... lane>
Words pairwise(Words a, Words b, std::integer_sequence<int, lane...>) {
  constexpr int width = word_count;
  return __builtin_shufflevector(a, b, (lane / 4 * 4 + lane % 2 + offset + lane % 4 / 2 * width)...);
}

/// Entries `entry` to `entry` + 3 of as many lists as there are words in a register: each of them for all
/// lists side by side.
template <class List>
std::array<Words, 4> transposed(const List* lists, size_t entry) {
  constexpr auto lanes = std::make_integer_sequence<int, word_count>();
  const Words a = load_fours<word_count>(lists, entry), b = load_fours<word_count>(lists + 1, entry),
              c = load_fours<word_count>(lists + 2, entry), d = load_fours<word_count>(lists + 3, entry);
  const Words ab_0 = in_turns<0>(a, b, lanes), ab_2 = in_turns<2>(a, b, lanes),
              cd_0 = in_turns<0>(c, d, lanes), cd_2 = in_turns<2>(c, d, lanes);
  return {pairwise<0>(ab_0, cd_0, lanes), pairwise<2>(ab_0, cd_0, lanes), pairwise<0>(ab_2, cd_2, lanes),
          pairwise<2>(ab_2, cd_2, lanes)};
}

}  // namespace sluice::cpu::SLUICE_SET
