// The checks of memory, and the order of invocations. Invocations that can wait are fibres.
#include "tests/translated/glsl.hpp"

#include <fmt/format.h>
#include <ucontext.h>

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>
#include <stdexcept>

#include "core/scene/random.hpp"

namespace sluice::glsl {
namespace {

constexpr size_t most_findings = 8;
constexpr size_t stack_bytes = size_t{256} << 10;

uint64_t dispatches = 0, phases = 0;  ///< of all dispatches; phases lie between barriers
uint32_t me = 0;                      ///< the invocation that runs, among all of its dispatch
std::string running;                  ///< the unit

struct Fibre {
  ucontext_t context{};
  std::unique_ptr<char[]> stack = std::make_unique<char[]>(stack_bytes);
  bool done = false;
};

/// A group whose invocations run in turns, each up to the next barrier.
struct Group {
  const Unit* unit = nullptr;
  uint number = 0;
  ucontext_t scheduler{};
  Fibre* current = nullptr;
};
Group group;

void enter_fibre() {
  group.unit->run(group.number);
  group.current->done = true;
  swapcontext(&group.current->context, &group.scheduler);
}

std::vector<uint32_t> in_order(uint64_t count, Order order) {
  std::vector<uint32_t> places(count);
  std::iota(places.begin(), places.end(), 0u);
  if (order == Order::backward) std::ranges::reverse(places);
  if (order == Order::shuffled) {
    Random random(count + dispatches);
    for (uint64_t k = count; k > 1; --k)
      std::swap(places[k - 1], places[static_cast<uint64_t>(random.uniform() * static_cast<double>(k))]);
  }
  return places;
}

void run_group(const Unit& unit, uint64_t number, uint32_t group_size, Order order) {
  static std::vector<Fibre> fibres;
  fibres.resize(group_size);
  group.unit = &unit;
  group.number = static_cast<uint>(number);
  for (Fibre& fibre : fibres) {
    getcontext(&fibre.context);
    fibre.context.uc_stack = {fibre.stack.get(), 0, stack_bytes};
    fibre.context.uc_link = nullptr;
    makecontext(&fibre.context, enter_fibre, 0);
    fibre.done = false;
  }
  for (size_t left = group_size; left > 0;) {
    for (const uint32_t lane : in_order(group_size, order)) {
      group.current = &fibres[lane];
      if (group.current->done) continue;
      gl_LocalInvocationIndex = lane;
      me = static_cast<uint32_t>(number * group_size + lane);
      swapcontext(&group.scheduler, &group.current->context);
      left -= group.current->done ? 1 : 0;
    }
    if (left > 0 && left < group_size) report("barrier that some invocations do not reach", "group", number);
    ++phases;
  }
}

}  // namespace

void report(const std::string& what, const std::string& memory, uint64_t word) {
  if (findings.size() < most_findings)
    findings.push_back(fmt::format("{}: {}: {}, word {}, invocation {}", running, what, memory, word, me));
}

void Memory::resize(uint64_t words, bool written) {
  words_.assign(words, 0);
  traces_.assign(words, {});
  if (written) mark_written();
}

void Memory::forget() {
  for (Trace& trace : traces_) trace.written = false;
}

void Memory::mark_written() {
  for (Trace& trace : traces_) trace.written = true;
}

void Memory::swap(Memory& other) {
  std::swap(words_, other.words_);
  std::swap(traces_, other.traces_);
}

uint64_t Memory::now() const { return shared ? phases + 1 : dispatches; }

bool Memory::inside(uint64_t word, const char* doing) const {
  if (word < words_.size()) return true;
  report(fmt::format("{} beyond the end, {} words", doing, words_.size()), name_, word);
  return false;
}

uint32_t Memory::read(uint64_t word) {
  if (!inside(word, "read")) return 0;
  Trace& trace = traces_[word];
  if (!trace.written) report("read of what nobody wrote", name_, word);
  if ((trace.write_time == now() || trace.atomic_time == now()) && trace.writer != me)
    report(fmt::format("race: read of what invocation {} writes", trace.writer), name_, word);
  trace.many_readers = trace.read_time == now() && (trace.many_readers || trace.reader != me);
  trace.reader = me;
  trace.read_time = now();
  return words_[word];
}

void Memory::write(uint64_t word, uint32_t value) {
  if (!inside(word, "write")) return;
  Trace& trace = traces_[word];
  if ((trace.write_time == now() || trace.atomic_time == now()) && trace.writer != me)
    report(fmt::format("race: write of what invocation {} writes, too", trace.writer), name_, word);
  if (trace.read_time == now() && (trace.many_readers || trace.reader != me))
    report(fmt::format("race: write of what invocation {} reads", trace.reader), name_, word);
  trace.writer = me;
  trace.write_time = now();
  trace.written = true;
  words_[word] = value;
}

uint32_t Memory::atomic(uint64_t word, const std::function<uint32_t(uint32_t)>& change) {
  if (!inside(word, "atomic access")) return 0;
  Trace& trace = traces_[word];
  if (!trace.written) report("read of what nobody wrote", name_, word);
  if (trace.write_time == now() && trace.writer != me)
    report(fmt::format("race: atomic access to what invocation {} writes", trace.writer), name_, word);
  if (trace.read_time == now() && (trace.many_readers || trace.reader != me))
    report(fmt::format("race: atomic access to what invocation {} reads", trace.reader), name_, word);
  trace.writer = trace.atomic_time == now() && trace.writer != me ? 0xffffffff : me;
  trace.atomic_time = now();
  const uint32_t before = words_[word];
  words_[word] = change(before);
  return before;
}

Memory& memory_of(std::string_view block) {
  static std::map<std::string, Memory, std::less<>> memories;
  const auto known = memories.find(block);
  if (known != memories.end()) return known->second;
  return memories.emplace(std::string(block), Memory(std::string(block))).first->second;
}

void barrier() {
  if (group.current == nullptr) throw std::logic_error("barrier() in a pass of single invocations");
  swapcontext(&group.current->context, &group.scheduler);
}

void dispatch(const Unit& unit, uint64_t groups, uint32_t group_size, Order order) {
  ++dispatches;
  ++phases;
  running = fmt::format("{}, pass {}", unit.stage, unit.pass);
  if (unit.entry == gpu::Entry::group) {
    for (const uint32_t number : in_order(groups, order)) run_group(unit, number, group_size, order);
    group.current = nullptr;
    return;
  }
  const uint64_t invocations = std::min<uint64_t>(groups * group_size, count);
  for (const uint32_t i : in_order(invocations, order)) {
    me = i;
    gl_LocalInvocationIndex = i % group_size;
    unit.run(i);
  }
}

}  // namespace sluice::glsl
