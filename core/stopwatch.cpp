// The clocks of the system, and of the machine the first line of /proc/stat.
#include "core/stopwatch.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <string>

namespace sluice {
namespace {

/// Processors used by others from which on wall seconds are spoilt.
constexpr double busy_from = 0.15;

double wall_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double cpu_now() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Seconds that the processors of this machine have worked, all together: for users, nice ones, the system,
/// interrupts, and for other machines on the same processors.
std::optional<double> machine_now() {
  std::ifstream file("/proc/stat");
  std::string name;
  double user = 0, nice = 0, system = 0, idle = 0, waiting = 0, hard = 0, soft = 0, stolen = 0;
  file >> name >> user >> nice >> system >> idle >> waiting >> hard >> soft >> stolen;
  const long ticks = sysconf(_SC_CLK_TCK);
  if (!file || name != "cpu" || ticks <= 0) return std::nullopt;
  return (user + nice + system + hard + soft + stolen) / static_cast<double>(ticks);
}

}  // namespace

Stopwatch::Stopwatch() : wall_first_(wall_now()), cpu_first_(cpu_now()), machine_first_(machine_now()) {}

void Stopwatch::start() {
  wall_then_ = wall_now();
  cpu_then_ = cpu_now();
}

double Stopwatch::stop() {
  const double wall = wall_now() - wall_then_;
  wall_ += wall;
  cpu_ += cpu_now() - cpu_then_;
  return wall;
}

std::optional<double> Stopwatch::others() const {
  const double passed = wall_now() - wall_first_;
  const auto machine = machine_now();
  if (!machine || !machine_first_ || passed < 1) return std::nullopt;
  return std::max(0.0, (*machine - *machine_first_ - (cpu_now() - cpu_first_)) / passed);
}

bool was_busy(std::optional<double> others) { return others && *others > busy_from; }

}  // namespace sluice
