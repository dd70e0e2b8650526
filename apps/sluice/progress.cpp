// Rewrites one line of the terminal a few times a second.
#include "apps/sluice/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>

#include "core/text.hpp"

namespace sluice {
namespace {

/// Of the terminal; a line that is wrapped could not be rewritten.
size_t columns() {
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : std::string::npos;
}

}  // namespace

Progress::Progress(uint64_t total, double duration, std::string units, bool quiet, uint64_t before)
    : total_(total),
      before_(before),
      duration_(duration),
      units_(std::move(units)),
      shown_(!quiet && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\x1b[K", stderr);
}

void Progress::show(uint64_t count, const StepReport& report, uint64_t not_converged) {
  if (!shown_) return;
  const Clock::time_point now = Clock::now();
  if (drawn_ && now - last_ < std::chrono::milliseconds(200)) return;
  last_ = now;
  drawn_ = true;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double done = static_cast<double>(count) / static_cast<double>(total_);
  const auto here = static_cast<double>(count - before_), left = static_cast<double>(total_ - count);
  std::string line = fmt::format("{:3.0f} %  t {:.4g}/{:.4g}  {:.4g} {}/s  dt {:.3g}  ", 100 * done,
                                 report.time, duration_, here / elapsed, units_, report.dt);
  if (report.iterations > 0) line += fmt::format("iterations {}  ", report.iterations);
  if (not_converged > 0) line += fmt::format("not converged {}  ", not_converged);
  line += fmt::format("compression {:.1e}  left {}", report.diagnostics.mean_compression,
                      duration_text(elapsed * left / here));
  fmt::print(stderr, "\r{}\x1b[K", line.substr(0, columns()));
  std::fflush(stderr);
}

}  // namespace sluice
