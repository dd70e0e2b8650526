// `sluice`: turns errors into messages and exit codes: 0 done, 1 invalid run, 2 bad input or usage, 3 the
// environment failed.
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "apps/sluice/command_line.hpp"
#include "sluice/error.hpp"

namespace {

using sluice::app::bad_input, sluice::app::environment_failed, sluice::app::fail;

/// Threads that wait for each other spin before they sleep, by default so long that another busy program
/// makes small scenes a hundred times slower. The OpenMP runtime reads how long only when a program starts,
/// so this one starts again, once; if it can't, it goes on as it is.
void limit_spinning(char** argv) {
  if (std::getenv("GOMP_SPINCOUNT") != nullptr || std::getenv("OMP_WAIT_POLICY") != nullptr) return;
  setenv("GOMP_SPINCOUNT", "5000", 1);
  execv("/proc/self/exe", argv);
}

}  // namespace

int main(int argc, char** argv) {
  limit_spinning(argv);
  // A reader that goes away and a file beyond its limit are failed writes, not deaths.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  int code = 0;
  try {
    code = sluice::app::run_command_line(argc, argv);
  } catch (const sluice::InputError& error) {
    return fail(bad_input, error.what());
  } catch (const std::bad_alloc&) {
    return fail(environment_failed, "out of memory; close other programs or use fewer particles");
  } catch (const std::exception& error) {
    return fail(environment_failed, error.what());
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    return fail(environment_failed, "standard output could not be written");
  }
  return code;
}
