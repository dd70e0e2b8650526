// Allocation, and the trial of what lies beyond the driver's own limit.
#include "gpu/storage.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/text.hpp"
#include "gpu/compute_program.hpp"
#include "gpu/context.hpp"

namespace sluice::gpu {
namespace {

constexpr uint64_t smallest_buffer = 16;
/// Shaders count the bytes of a buffer in 32 bits.
constexpr uint64_t largest_buffer = 0xfffffff0;

[[noreturn]] void refuse(std::string_view what, uint64_t bytes, const std::string& reason) {
  throw EnvironmentError(fmt::format("{} needs {} in one buffer, {}; use fewer particles, or --backend cpu",
                                     what, bytes_text(static_cast<double>(bytes)), reason));
}

/// Whether a shader can write the last word of `buffer`.
bool reaches_the_end(const Context& context, const Buffer& buffer, uint64_t bytes) {
  constexpr uint32_t mark = 0x5eed;
  const uint64_t last = bytes / sizeof(mark) - 1;
  ComputeProgram probe(context, context.shaders().load("lib/probe_storage.comp"));
  probe.set("last", static_cast<uint32_t>(last));
  probe.set("mark", mark);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer.name());
  probe.dispatch({1, 1});
  uint32_t found = 0;
  glGetBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(last * sizeof(mark)), sizeof(found), &found);
  return found == mark;
}

}  // namespace

void make_room(const Context& context, const Buffer& buffer, uint64_t bytes, std::string_view what) {
  if (bytes > largest_buffer) refuse(what, bytes, "more than shaders can address");
  glBindBuffer(GL_COPY_WRITE_BUFFER, buffer.name());
  glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(std::max(bytes, smallest_buffer)), nullptr,
               GL_DYNAMIC_COPY);
  context.check(fmt::format("making room for {}", what));
  // Drivers, llvmpipe among them, state a limit far below what they can do; so it is tried.
  GLint64 limit = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &limit);
  if (bytes > static_cast<uint64_t>(limit) && !reaches_the_end(context, buffer, bytes)) {
    refuse(what, bytes,
           fmt::format("and shaders on {} reach {}", context.renderer(),
                       bytes_text(static_cast<double>(limit))));
  }
  glClearBufferData(GL_COPY_WRITE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

}  // namespace sluice::gpu
