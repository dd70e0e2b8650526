// What shaders that were translated to C++ are made of: GLSL's types and functions, storage in which every
// access is checked, and groups whose invocations wait for each other. Found are
//   races        an element that one invocation of a dispatch writes and another one reads or writes, atomics
//   aside;
//                in shared memory, between two barriers
//   bounds       an index at or behind the end
//   unwritten    an element that is read and that nobody wrote
//   barriers     a barrier() that not all invocations of a group reach
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/fields.hpp"
#include "core/model/params.hpp"
#include "gpu/passes.hpp"

namespace sluice::glsl {

using uint = uint32_t;
using glm::abs, glm::findMSB, glm::floatBitsToUint, glm::uintBitsToFloat;
using glm::uvec2, glm::vec2, glm::vec4;
inline uint max(uint a, uint b) { return a < b ? b : a; }
inline uint min(uint a, uint b) { return b < a ? b : a; }
inline float max(float a, float b) { return a < b ? b : a; }
inline float min(float a, float b) { return b < a ? b : a; }
inline float sqrt(float a) { return std::sqrt(a); }
inline bool isnan(float a) { return std::isnan(a); }

/// Constants as the uniform blocks have them.
inline ParamsOf<float> params;
#define CONSTANT(name, meaning) inline uint name = 0;
SLUICE_PASS_CONSTANTS(CONSTANT)
#undef CONSTANT

/// What went wrong, a line each, the first few of a dispatch.
inline std::vector<std::string> findings;
void report(const std::string& what, const std::string& memory, uint64_t word);

/// 32-bit words, and what this dispatch did with each.
class Memory {
 public:
  explicit Memory(std::string name) : name_(std::move(name)) {}

  void resize(uint64_t words, bool written);
  /// From now on nothing in it counts as written.
  void forget();
  uint64_t size() const { return words_.size(); }
  std::vector<uint32_t>& words() { return words_; }
  const std::vector<uint32_t>& words() const { return words_; }
  void mark_written();
  void swap(Memory& other);
  bool shared = false;  ///< by a group; then what happened before a barrier is over

  uint32_t read(uint64_t word);
  void write(uint64_t word, uint32_t value);
  uint32_t atomic(uint64_t word, const std::function<uint32_t(uint32_t)>& change);

 private:
  struct Trace {
    uint64_t write_time = 0, read_time = 0, atomic_time = 0;
    uint32_t writer = 0, reader = 0;
    bool many_readers = false, written = false;
  };
  uint64_t now() const;
  bool inside(uint64_t word, const char* doing) const;

  std::string name_;
  std::vector<uint32_t> words_;
  std::vector<Trace> traces_;
};

template <class T>
class Ref;

/// One word of memory as a T.
template <class T>
class Word {
 public:
  static_assert(sizeof(T) == sizeof(uint32_t));
  Word(Memory& memory, uint64_t at) : memory_(&memory), at_(at) {}
  Word(const Word&) = default;
  operator T() const {
    const uint32_t bits = memory_->read(at_);
    T value;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
  }
  const Word& operator=(T value) const {
    uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    memory_->write(at_, bits);
    return *this;
  }
  const Word& operator=(const Word& other) const { return *this = T(other); }
  const Word& operator+=(T value) const { return *this = T(*this) + value; }
  uint atomic(const std::function<uint(uint)>& change) const { return memory_->atomic(at_, change); }

 private:
  Memory* memory_;
  uint64_t at_;
};

template <>
class Ref<uint> : public Word<uint> {
 public:
  using Word::operator=;
  Ref(Memory& memory, uint64_t i) : Word(memory, i) {}
};
template <>
class Ref<float> : public Word<float> {
 public:
  using Word::operator=;
  Ref(Memory& memory, uint64_t i) : Word(memory, i) {}
};
template <class T, class Scalar>
class Pair {
 public:
  Pair(Memory& memory, uint64_t i) : x(memory, 2 * i), y(memory, 2 * i + 1) {}
  operator T() const { return T(Scalar(x), Scalar(y)); }
  const Pair& operator=(T value) const {
    x = value.x;
    y = value.y;
    return *this;
  }
  friend T operator+(const Pair& a, T b) { return T(a) + b; }
  friend T operator-(const Pair& a, T b) { return T(a) - b; }
  Word<Scalar> x, y;
};
template <>
class Ref<vec2> : public Pair<vec2, float> {
 public:
  using Pair::operator=;
  using Pair::Pair;
};
template <>
class Ref<uvec2> : public Pair<uvec2, uint> {
 public:
  using Pair::operator=;
  using Pair::Pair;
};
template <>
class Ref<vec4> {
 public:
  Ref(Memory& memory, uint64_t i)
      : x(memory, 4 * i), y(memory, 4 * i + 1), z(memory, 4 * i + 2), w(memory, 4 * i + 3) {}
  operator vec4() const { return {float(x), float(y), float(z), float(w)}; }
  const Ref& operator=(vec4 value) const {
    x = value.x, y = value.y, z = value.z, w = value.w;
    return *this;
  }
  Word<float> x, y, z, w;
};

/// Storage blocks: those that may be written, and those that may not.
template <class T>
struct Buffer {
  Memory& memory;
  Ref<T> operator[](uint64_t i) const { return {memory, i}; }
};
template <class T>
struct ReadOnly {
  Memory& memory;
  T operator[](uint64_t i) const { return T(Ref<T>(memory, i)); }
};
Memory& memory_of(std::string_view block);

/// Shared memory of the group that runs.
template <class T, uint32_t length>
struct Shared {
  Shared() : memory("shared memory") {
    memory.shared = true;
    memory.resize(length, false);
  }
  Ref<T> operator[](uint64_t i) { return {memory, i}; }
  Memory memory;
};

inline uint atomicAdd(const Word<uint>& word, uint value) {
  return word.atomic([&](uint old) { return old + value; });
}
inline uint atomicMax(const Word<uint>& word, uint value) {
  return word.atomic([&](uint old) { return old > value ? old : value; });
}

inline uint gl_LocalInvocationIndex = 0;
void barrier();

/// One pass of a stage, translated.
struct Unit {
  std::string_view stage;
  uint32_t pass;
  std::string_view fault;  ///< what was put into it on purpose; empty for the shader as it is
  void (*run)(uint);       ///< of an invocation or of a group
  gpu::Entry entry;
  std::vector<std::pair<std::string_view, bool*>> needs;  ///< constants that follow from a scene
};
const std::vector<Unit>& units();

/// Order in which the invocations of a dispatch run.
enum class Order { forward, backward, shuffled };

/// Runs the first `groups` groups of `unit`, of `group_size` invocations each.
void dispatch(const Unit& unit, uint64_t groups, uint32_t group_size, Order order);

}  // namespace sluice::glsl
