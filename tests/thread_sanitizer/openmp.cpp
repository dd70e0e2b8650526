// OpenMP for the thread sanitizer: the few functions of GCC's runtime that the CPU backend calls, on threads
// and a barrier that the sanitizer sees. The runtime itself is not instrumented: with it every fork, join and
// barrier would look like a race. Linked into the tests when they are built with -fsanitize=thread, nowhere
// else.
#include <omp.h>

#include <barrier>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <thread>

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

/// A thread that runs what it is given, one thing after the other.
class Worker {
 public:
  Worker() : thread_([this] { run(); }) {}
  ~Worker() { give({}); }

  /// Nothing ends the thread.
  void give(std::function<void()> work) {
    const std::lock_guard lock(mutex_);
    work_ = std::move(work);
    busy_ = true;
    changed_.notify_all();
  }

  void wait_until_done() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !busy_; });
  }

 private:
  void run() {
    std::unique_lock lock(mutex_);
    for (;;) {
      changed_.wait(lock, [&] { return busy_; });
      if (!work_) return;
      lock.unlock();
      work_();
      lock.lock();
      busy_ = false;
      changed_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::function<void()> work_;
  bool busy_ = false;
  std::jthread thread_;  // last, so that everything it uses exists
};
thread_local std::deque<Worker> workers;  // of the thread that opens the regions

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
  while (workers.size() + 1 < threads) workers.emplace_back();
  for (unsigned number = 1; number < threads; ++number)
    workers[number - 1].give([&run, number] { run(number); });
  run(0);
  for (unsigned number = 1; number < threads; ++number) workers[number - 1].wait_until_done();
}

void GOMP_barrier() {
  if (place.team != nullptr) place.team->barrier.arrive_and_wait();
}

void GOMP_atomic_start() { atomic_mutex().lock(); }
void GOMP_atomic_end() { atomic_mutex().unlock(); }

int omp_get_thread_num() { return static_cast<int>(place.number); }
int omp_get_num_threads() { return place.team != nullptr ? static_cast<int>(place.team->size) : 1; }

}  // extern "C"
