// Changes to bytes, and the choice among changes.
#include "tests/support/mutation.hpp"

#include <array>

namespace sluice::test {
namespace {

struct Part {
  size_t begin, size;
};

/// A part of the text, short more often than long.
Part part_of(const std::string& text, Dice& dice) {
  const size_t begin = dice.below(text.size());
  const size_t longest = dice.one_in(4) ? text.size() - begin : std::min<size_t>(text.size() - begin, 16);
  return {begin, dice.below(longest + 1)};
}

void flip_bit(std::string& text, Dice& dice, std::span<const std::string>) {
  if (text.empty()) return;
  char& byte = text[dice.below(text.size())];
  byte = static_cast<char>(byte ^ (1 << dice.below(8)));
}

void set_byte(std::string& text, Dice& dice, std::span<const std::string>) {
  if (!text.empty()) text[dice.below(text.size())] = static_cast<char>(dice.below(256));
}

void insert_byte(std::string& text, Dice& dice, std::span<const std::string>) {
  const char byte = static_cast<char>(dice.below(256));
  text.insert(dice.below(text.size() + 1), 1, byte);
}

void remove_part(std::string& text, Dice& dice, std::span<const std::string>) {
  const auto [begin, size] = part_of(text, dice);
  text.erase(begin, size);
}

void repeat_part(std::string& text, Dice& dice, std::span<const std::string>) {
  const auto [begin, size] = part_of(text, dice);
  const std::string part = text.substr(begin, size);
  text.insert(dice.one_in(2) ? begin : dice.below(text.size() + 1), part);
}

void splice(std::string& text, Dice& dice, std::span<const std::string> others) {
  const std::string& other = dice.of(others);
  if (dice.one_in(2)) {
    text.resize(dice.below(text.size() + 1));
    text += other.substr(dice.below(other.size() + 1));
    return;
  }
  const auto [begin, size] = part_of(other, dice);
  text.insert(dice.below(text.size() + 1), other, begin, size);
}

void cut_off(std::string& text, Dice& dice, std::span<const std::string>) {
  text.resize(dice.below(text.size() + 1));
}

}  // namespace

std::span<const Mutation> byte_mutations() {
  static const std::array<Mutation, 7> all{flip_bit,    set_byte, insert_byte, remove_part,
                                           repeat_part, splice,   cut_off};
  return all;
}

std::string mutant(std::span<const std::string> corpus, std::span<const Mutation> mutations, Dice& dice) {
  std::string text = dice.of(corpus);
  for (size_t changes = 1 + dice.below(3); changes > 0; --changes) dice.of(mutations)(text, dice, corpus);
  return text;
}

}  // namespace sluice::test
