// Rewrites one line of the terminal a few times a second.
#include "apps/sluice/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "core/text.hpp"

namespace sluice {

Progress::Progress(uint64_t total, double duration, std::string units, bool quiet)
    : total_(total),
      duration_(duration),
      units_(std::move(units)),
      shown_(!quiet && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\x1b[K", stderr);
}

void Progress::show(uint64_t count, const StepReport& report) {
  if (!report.converged) ++not_converged_;
  if (!shown_) return;
  const Clock::time_point now = Clock::now();
  if (drawn_ && now - last_ < std::chrono::milliseconds(200)) return;
  last_ = now;
  drawn_ = true;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double done = static_cast<double>(count) / static_cast<double>(total_);
  fmt::print(stderr, "\r{:3.0f} %  t {:.4g}/{:.4g}  {:.4g} {}/s  dt {:.3g}  ", 100 * done, report.time,
             duration_, static_cast<double>(count) / elapsed, units_, report.dt);
  if (report.iterations > 0) {
    fmt::print(stderr, "iterations {}  ", report.iterations);
    if (not_converged_ > 0) fmt::print(stderr, "not converged {}  ", not_converged_);
  }
  fmt::print(stderr, "compression {:.1e}  left {}\x1b[K", report.diagnostics.mean_compression,
             duration_text(elapsed * (1 - done) / done));
  std::fflush(stderr);
}

}  // namespace sluice
