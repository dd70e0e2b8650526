// What the memory of a device can give: the measure that the speed of the stages is compared with.
#pragma once

#include <cstdint>

namespace sluice::gpu {

class Context;

/// Seconds that the device takes to copy `bytes` from one buffer to another: the fastest of `repetitions`.
/// EnvironmentError when there is no room for both.
double copy_seconds(const Context& context, uint64_t bytes, int repetitions);

}  // namespace sluice::gpu
