// OpenMP for the thread sanitizer: the few functions of GCC's runtime that the CPU backend calls, on threads
// and a barrier that the sanitizer sees. The runtime itself is not instrumented: with it every fork, join and
// barrier would look like a race. Linked into the tests when they are built with -fsanitize=thread, nowhere
// else. A team's threads are started anew for every region, which is slow and as strict as can be.
#include <omp.h>

#include <barrier>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

namespace {

struct Team {
  explicit Team(unsigned threads) : size(threads), barrier(threads) {}
  unsigned size;
  std::barrier<> barrier;
};

/// The place of this thread in the region that it runs.
struct Place {
  Team* team = nullptr;
  unsigned number = 0;
};
thread_local Place place;

std::mutex& atomic_mutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

// As GCC's compiled code calls them (libgomp/libgomp_g.h).
extern "C" {

void GOMP_parallel(void (*region)(void*), void* data, unsigned threads, unsigned) {
  if (place.team != nullptr || threads == 0)
    throw std::logic_error("regions within regions, or without num_threads, are not for this runtime");
  Team team(threads);
  const auto run = [&](unsigned number) {
    place = {&team, number};
    region(data);
    place = {};
  };
  std::vector<std::jthread> others;
  for (unsigned number = 1; number < threads; ++number) others.emplace_back(run, number);
  run(0);
}

void GOMP_barrier() {
  if (place.team != nullptr) place.team->barrier.arrive_and_wait();
}

void GOMP_atomic_start() { atomic_mutex().lock(); }
void GOMP_atomic_end() { atomic_mutex().unlock(); }

int omp_get_thread_num() { return static_cast<int>(place.number); }
int omp_get_num_threads() { return place.team != nullptr ? static_cast<int>(place.team->size) : 1; }

}  // extern "C"
