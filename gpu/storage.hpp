// Room in graphics memory that shaders can reach to its end.
#pragma once

#include <cstdint>
#include <string_view>

#include "gpu/gl_object.hpp"

namespace sluice::gpu {

/// Gives `buffer` room for `bytes` zeros. EnvironmentError when there is not so much, or when shaders can't
/// address it; `what` it is for is named in messages.
void make_room(const Context& context, const Buffer& buffer, uint64_t bytes, std::string_view what);

}  // namespace sluice::gpu
