// The CPU backend as a device.
#include "sluice/cpu.hpp"

#include <fmt/format.h>

#include "cpu/backend.hpp"

namespace sluice::cpu {

Device device(const DeviceOptions& options) {
  if (options.threads < 0)
    throw InputError(fmt::format("threads: found {}, expected 1 or more, or 0 for all", options.threads));
  return Device(make_backend(options.precision, options.threads == 0 ? hardware_threads() : options.threads));
}

}  // namespace sluice::cpu
