// Files that nobody would write: seeded changes to good ones, the same from a seed everywhere.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/random.hpp"

namespace sluice::test {

/// Throws of a die with as many sides as are asked for.
class Dice {
 public:
  explicit Dice(uint64_t seed) : random_(seed) {}

  /// 0 to n - 1; 0 when n is 0.
  size_t below(size_t n) { return static_cast<size_t>(random_.uniform() * static_cast<double>(n)); }
  bool one_in(size_t n) { return below(n) == 0; }
  template <class T>
  const T& of(std::span<const T> choices) {
    return choices[below(choices.size())];
  }

 private:
  Random random_;
};

/// One change to a text. What it takes from elsewhere it takes from `others`.
using Mutation = std::function<void(std::string& text, Dice& dice, std::span<const std::string> others)>;

/// Changes that know of bytes only: flipped bits, other bytes, parts removed, repeated or taken from another
/// file, an end cut off.
std::span<const Mutation> byte_mutations();

/// Changes to a TOML file: numbers and strings replaced by extreme ones; keys misspelt; lines and tables
/// removed, repeated, moved or taken from another file; deep nesting; long strings; bytes that are not UTF-8.
std::span<const Mutation> scene_mutations();

/// Replaces a number of the text, if there is one, by a plausible or an extreme one.
void replace_number(std::string& text, Dice& dice, std::span<const std::string> others);

/// A text of `corpus` after one to three of the changes.
std::string mutant(std::span<const std::string> corpus, std::span<const Mutation> mutations, Dice& dice);

}  // namespace sluice::test
