// A step allocates nothing once the run has started, and a run takes the memory it was said to need.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "core/solver/memory.hpp"
#include "tests/support/simulation.hpp"

namespace {
std::atomic<uint64_t> allocations = 0, allocated_bytes = 0;
}

// The whole test program counts; only the differences below matter.
[[gnu::noinline]] void* operator new(size_t size) {
  ++allocations;
  allocated_bytes += size;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  allocated_bytes += size;
  return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, size_t) noexcept { std::free(memory); }

namespace sluice::test {
namespace {

TEST(Allocations, CounterCounts) {
  const uint64_t before = allocations;
  ::operator delete(::operator new(1000));  // a container's memory may be left out when nobody looks
  EXPECT_GT(allocations.load(), before);
}

TEST(Allocations, StepsAfterTheFirstMakeNone) {
  for (const char* method : {"iisph", "ssph", "wcsph"}) {
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

// Of a block that hits the floor, so that steps change and some are repeated.
TEST(Allocations, AdaptiveStepsMakeNoneEither) {
  Simulation simulation(shipped(
      "breaking_dam",
      {"time.cfl=0.8", "time.dt_min=1e-4", "time.dt_max=0.1", "pressure.iisph.solver=barzilai-borwein",
       "fluid.rect=[{min=[\"3h\",\"20h\"],count=[22,12],velocity=[0,-150]}]"}));
  simulation.simulator->step();
  const uint64_t before = allocations;
  uint32_t repeats = 0;
  for (int step = 0; step < 60; ++step) repeats += simulation.simulator->step().repeats;
  EXPECT_EQ(allocations.load(), before);
  EXPECT_GT(repeats, 0u);
}

TEST(Allocations, BackendTakesWhatWasForeseen) {
  for (const char* name : {"leaking_dam", "falling_from_platform"}) {
    for (const char* method : {"iisph", "ssph", "wcsph"}) {
      const Scene scene = shipped(name, {std::string("pressure.method=") + method});
      const Samples samples = sample(scene);
      const Params params = make_params(scene, static_cast<uint32_t>(samples.fluid.size()));
      const Sizes sizes{samples.fluid.size(), samples.boundary.size(), uint64_t{params.columns} * params.rows,
                        first_list_size(samples.fluid.size(), scene.smoothing)};
      const auto backend = cpu::make_backend(Precision::double_, 1);
      const uint64_t before = allocated_bytes;
      backend->allocate(make_plan(model_of(scene)).fields(), sizes);
      const double taken = static_cast<double>(allocated_bytes - before);
      const double foreseen = memory_need(scene, Precision::double_).bytes;
      EXPECT_GE(foreseen, taken) << name << " " << method;
      EXPECT_LE(foreseen, 1.8 * taken)
          << name << " " << method;  // the host's copies, and bounds on the counts
    }
  }
}

}  // namespace
}  // namespace sluice::test
