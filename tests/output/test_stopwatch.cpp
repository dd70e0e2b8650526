// Seconds by the wall clock and of processors, and what others do meanwhile.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>
#include <vector>

#include "core/stopwatch.hpp"

namespace sluice::test {
namespace {

using std::chrono::milliseconds, std::chrono::steady_clock;

void work_for(milliseconds time) {
  volatile double sum = 0;
  for (const auto end = steady_clock::now() + time; steady_clock::now() < end;) sum = sum + 1;
}

TEST(Stopwatch, CountsWorkInBothAndSleepInOne) {
  Stopwatch watch;
  watch.start();
  std::this_thread::sleep_for(milliseconds(60));
  EXPECT_GE(watch.stop(), 0.06);
  EXPECT_LT(watch.cpu(), 0.03);
  std::this_thread::sleep_for(milliseconds(30));  // between the parts
  watch.start();
  work_for(milliseconds(50));
  watch.stop();
  EXPECT_GE(watch.wall(), 0.11);
  EXPECT_GT(watch.cpu(), 0.005);
  EXPECT_LE(watch.cpu(), watch.wall());
}

TEST(Stopwatch, ThreadsCountTogether) {
  Stopwatch watch;
  watch.start();
  std::thread other(work_for, milliseconds(100));
  work_for(milliseconds(100));
  other.join();
  watch.stop();
  EXPECT_GT(watch.cpu(), 0.02);
}

// A child is another program. How much of a processor it gets where others run too is not known, but it gets
// some.
TEST(Stopwatch, SeesOtherProgramsButNotItself) {
  EXPECT_FALSE(Stopwatch().others()) << "in less than a second";
  Stopwatch watch;
  const pid_t child = fork();
  if (child == 0) {
    work_for(milliseconds(60'000));
    _exit(0);
  }
  work_for(milliseconds(1100));
  const auto others = watch.others();
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  ASSERT_TRUE(others);
  EXPECT_GT(*others, 0.2);
  EXPECT_TRUE(was_busy(others));
  EXPECT_FALSE(was_busy(0.1));
  EXPECT_FALSE(was_busy(std::nullopt));
}

// There are only so many processors: what this program had, others had not.
TEST(Stopwatch, DoesNotCountItsOwnWorkAmongTheOthers) {
  const unsigned processors = std::thread::hardware_concurrency();
  Stopwatch watch;
  watch.start();
  std::vector<std::thread> threads;
  for (unsigned k = 0; k < processors; ++k) threads.emplace_back(work_for, milliseconds(1100));
  for (std::thread& each : threads) each.join();
  const double own = watch.stop();
  const auto others = watch.others();
  ASSERT_TRUE(others);
  EXPECT_LT(*others + watch.cpu() / own, processors + 0.2);
}

}  // namespace
}  // namespace sluice::test
