// Rewrites one line of the terminal a few times a second.
#include "apps/sluice/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "core/text.hpp"

namespace sluice {

Progress::Progress(uint64_t steps, double duration, bool quiet)
    : steps_(steps), duration_(duration), shown_(!quiet && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\x1b[K", stderr);
}

void Progress::show(const StepReport& report) {
  if (!shown_) return;
  const Clock::time_point now = Clock::now();
  if (drawn_ && now - last_ < std::chrono::milliseconds(200)) return;
  last_ = now;
  drawn_ = true;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double done = static_cast<double>(report.step) / static_cast<double>(steps_);
  fmt::print(stderr, "\r{:3.0f} %  t {:.4g}/{:.4g}  {:.4g} steps/s  dt {:.3g}  ", 100 * done, report.time,
             duration_, static_cast<double>(report.step) / elapsed, report.dt);
  if (report.iterations > 0) {
    fmt::print(stderr, "iterations {}{}  ", report.iterations, report.converged ? "" : " (not converged)");
  }
  fmt::print(stderr, "compression {:.1e}  left {}\x1b[K", report.diagnostics.mean_compression,
             duration_text(elapsed * (1 - done) / done));
  std::fflush(stderr);
}

}  // namespace sluice
