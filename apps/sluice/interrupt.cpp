// The signal handler, and what it leaves behind: a handler can reach nothing but a global.
#include "apps/sluice/interrupt.hpp"

#include <csignal>

namespace sluice {
namespace {

volatile std::sig_atomic_t stop_requested = 0;
extern "C" void request_stop(int) { stop_requested = 1; }

}  // namespace

void note_interrupts() {
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
}

bool interrupted() { return stop_requested != 0; }

}  // namespace sluice
