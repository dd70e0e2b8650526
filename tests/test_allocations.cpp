// A step allocates nothing, once the run has started.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/support/simulation.hpp"

namespace {
std::atomic<uint64_t> allocations = 0;
}

// The whole test program counts; only the differences below matter.
[[gnu::noinline]] void* operator new(size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, size_t) noexcept { std::free(memory); }

namespace sluice::test {
namespace {

TEST(Allocations, CounterCounts) {
  const uint64_t before = allocations;
  std::vector<double> values(1000);
  EXPECT_GT(values.size(), 0u);
  EXPECT_GT(allocations.load(), before);
}

TEST(Allocations, StepsAfterTheFirstMakeNone) {
  for (const char* method : {"iisph", "ssph"}) {
    for (const int threads : {1, 2}) {
      Simulation simulation(shipped("breaking_dam", {std::string("pressure.method=") + method}),
                            Precision::double_, threads);
      simulation.simulator->step();
      const uint64_t before = allocations;
      for (int step = 0; step < 300; ++step) simulation.simulator->step();
      EXPECT_EQ(allocations.load(), before) << method << ", " << threads << " threads";
    }
  }
}

}  // namespace
}  // namespace sluice::test
