// Files that travel inside the binary: shaders and the font. Filled in by cmake/embed.cmake.
#pragma once

#include <span>
#include <string_view>

namespace sluice::gpu {

/// The bytes of an embedded file by its name ("density.comp", "lib/kernel.glsl", "DejaVuSans.ttf"); empty if
/// there is none.
std::string_view embedded_file(std::string_view name);

std::span<const std::string_view> embedded_names();

}  // namespace sluice::gpu
