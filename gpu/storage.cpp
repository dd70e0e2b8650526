// Allocation, and the trial of what lies beyond the driver's own limit.
#include "gpu/storage.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "core/text.hpp"
#include "gpu/compute_program.hpp"
#include "gpu/context.hpp"
#include "sluice/error.hpp"

namespace sluice::gpu {
namespace {

constexpr uint64_t smallest_buffer = 16;
/// Largest part that is read back at a time.
constexpr uint64_t largest_staging = uint64_t{4} << 20;
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
  ReadBack(context).read(buffer, last * sizeof(mark), sizeof(found), &found);
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
  glBindBuffer(GL_COPY_WRITE_BUFFER, buffer.name());
  glClearBufferData(GL_COPY_WRITE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

void ReadBack::read(const Buffer& from, uint64_t offset, uint64_t bytes, void* to) const {
  glBindBuffer(GL_COPY_READ_BUFFER, from.name());
  glBindBuffer(GL_COPY_WRITE_BUFFER, staging_.name());
  if (room_ < std::min(bytes, largest_staging)) {
    room_ = std::clamp(bytes, smallest_buffer, largest_staging);
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(room_), nullptr, GL_STREAM_READ);
  }
  for (uint64_t done = 0; done < bytes; done += room_) {
    const auto part = static_cast<GLsizeiptr>(std::min(room_, bytes - done));
    glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(offset + done), 0,
                        part);
    glGetBufferSubData(GL_COPY_WRITE_BUFFER, 0, part, static_cast<std::byte*>(to) + done);
  }
}

}  // namespace sluice::gpu
