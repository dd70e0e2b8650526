// Room in graphics memory that shaders can reach to its end.
#pragma once

#include <cstdint>
#include <string_view>

#include "gpu/gl_object.hpp"

namespace sluice::gpu {

/// Gives `buffer` room for `bytes` zeros. EnvironmentError when there is not so much, or when shaders can't
/// address it; `what` it is for is named in messages.
void make_room(const Context& context, const Buffer& buffer, uint64_t bytes, std::string_view what);

/// Way of values from buffers that shaders use to the processor: by a small buffer of its own. Drivers move
/// buffers that are read back to the computer's memory, where shaders reach them across the bus.
class ReadBack {
 public:
  explicit ReadBack(const Context& context) : staging_(context) {}

  /// Copies `bytes` of `from`, from byte `offset` on, to `to`, when all that is under way is done.
  void read(const Buffer& from, uint64_t offset, uint64_t bytes, void* to) const;

 private:
  Buffer staging_;
  mutable uint64_t room_ = 0;
};

}  // namespace sluice::gpu
