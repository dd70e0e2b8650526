// The signal handler, and what it leaves behind: a handler can reach nothing but a global.
#include "apps/sluice/interrupt.hpp"

#include <csignal>

namespace sluice::app {
namespace {

volatile std::sig_atomic_t stop_requested = 0;
// A second one ends the program at once: what it waits for may never come.
extern "C" void request_stop(int signal) {
  stop_requested = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void note_interrupts() {
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
  std::signal(SIGHUP, request_stop);
}

bool interrupted() { return stop_requested != 0; }

}  // namespace sluice::app
