// Rewrites one line of the terminal a few times a second.
#include "apps/sluice/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>

#include "core/text.hpp"

namespace sluice::app {
namespace {

/// Width of the terminal; a line that is wrapped could not be rewritten.
size_t columns() {
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : std::string::npos;
}

}  // namespace

Progress::Progress(uint64_t total, double duration, std::string units, bool quiet, uint64_t before,
                   double time_before)
    : total_(total),
      before_(before),
      duration_(duration),
      time_before_(time_before),
      units_(std::move(units)),
      shown_(!quiet && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\x1b[K", stderr);
}

double Progress::share(uint64_t count, double time) const {
  return total_ > 0 ? static_cast<double>(count) / static_cast<double>(total_) : time / duration_;
}

void Progress::show(uint64_t count, const StepReport& report, uint64_t not_converged) {
  if (!shown_) return;
  const Clock::time_point now = Clock::now();
  if (drawn_ && now - last_ < std::chrono::milliseconds(200)) return;
  last_ = now;
  drawn_ = true;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double done = share(count, report.time), done_here = done - share(before_, time_before_);
  std::string line =
      fmt::format("{:3.0f} %  t {:.4g}/{:.4g}  {:.4g} {}/s  dt {:.3g}  ", 100 * done, report.time, duration_,
                  static_cast<double>(count - before_) / elapsed, units_, report.dt);
  if (report.iterations > 0) line += fmt::format("iterations {}  ", report.iterations);
  if (not_converged > 0) line += fmt::format("not converged {}  ", not_converged);
  line += fmt::format("compression {:.1e}  left {}", report.diagnostics.mean_compression,
                      duration_text(elapsed * (1 - done) / done_here));
  fmt::print(stderr, "\r{}\x1b[K", line.substr(0, columns()));
  std::fflush(stderr);
}

}  // namespace sluice::app
