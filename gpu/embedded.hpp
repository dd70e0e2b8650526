// Files that travel inside the binary: shaders and the font. Filled in by cmake/embed.cmake.
#pragma once

#include <string_view>

namespace sluice::gpu {

/// The bytes of an embedded file by its name without folder ("particles.vert"); empty if there is none.
std::string_view embedded_file(std::string_view name);

}  // namespace sluice::gpu
