// A copy between two buffers, timed by timestamps, or by a clock where a processor plays the graphics card.
#include "gpu/copy.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>

#include "gpu/context.hpp"
#include "gpu/gl_object.hpp"
#include "gpu/timer.hpp"

namespace sluice::gpu {
namespace {

void copy(GLsizeiptr bytes) { glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, bytes); }

double seconds_by_clock(GLsizeiptr bytes) {
  glFinish();
  const auto start = std::chrono::steady_clock::now();
  copy(bytes);
  glFinish();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double seconds_by_timestamps(GLsizeiptr bytes) {
  std::array<GLuint, 2> queries{};
  std::array<GLuint64, 2> nanoseconds{};
  glGenQueries(2, queries.data());
  glQueryCounter(queries[0], GL_TIMESTAMP);
  copy(bytes);
  glQueryCounter(queries[1], GL_TIMESTAMP);
  for (size_t i = 0; i < 2; ++i) glGetQueryObjectui64v(queries[i], GL_QUERY_RESULT, &nanoseconds[i]);
  glDeleteQueries(2, queries.data());
  return seconds_between(nanoseconds[0], nanoseconds[1]);
}

}  // namespace

double copy_seconds(const Context& context, uint64_t bytes, int repetitions) {
  const Buffer from(context), to(context);
  const auto size = static_cast<GLsizeiptr>(bytes);
  glBindBuffer(GL_COPY_READ_BUFFER, from.name());
  glBindBuffer(GL_COPY_WRITE_BUFFER, to.name());
  for (const auto target : {GLenum{GL_COPY_READ_BUFFER}, GLenum{GL_COPY_WRITE_BUFFER}}) {
    glBufferData(target, size, nullptr, GL_DYNAMIC_COPY);
    context.check("making room for a copy");
    // Memory that was never written may not be there yet.
    glClearBufferData(target, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  }
  double fastest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repetitions; ++i) {
    fastest = std::min(fastest, context.software() ? seconds_by_clock(size) : seconds_by_timestamps(size));
  }
  context.check("copying");
  return fastest;
}

}  // namespace sluice::gpu
