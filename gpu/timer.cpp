// Timestamps in a ring, or a clock.
#include "gpu/timer.hpp"

#include <epoxy/gl.h>

#include <chrono>
#include <vector>

#include "gpu/context.hpp"

namespace sluice::gpu {
namespace {

constexpr size_t most_pending = 1024;  ///< stages that are timed before the oldest are read

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

GLuint64 nanoseconds_at(GLuint query) {
  GLuint64 nanoseconds = 0;
  glGetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
  return nanoseconds;
}

}  // namespace

double seconds_between(uint64_t from, uint64_t to) { return 1e-9 * static_cast<double>(to - from); }

struct StageTimer::Queries {
  struct Timed {
    Stage stage;
    GLuint begin, end;
  };
  GLuint take() {
    const GLuint query = unused.back();
    unused.pop_back();
    glQueryCounter(query, GL_TIMESTAMP);
    return query;
  }
  std::vector<Timed> pending;  // oldest first
  std::vector<GLuint> unused;
  GLuint begun = 0;
};

StageTimer::StageTimer(const Context& context, bool timed) : context_(context), timed_(timed) {
  if (!timed || context.software()) return;
  queries_ = std::make_unique<Queries>();
  queries_->pending.reserve(most_pending + 1);
  queries_->unused.resize(2 * (most_pending + 1));
  glGenQueries(static_cast<GLsizei>(queries_->unused.size()), queries_->unused.data());
}

StageTimer::~StageTimer() {
  if (!queries_) return;
  context_.make_current();
  for (const auto& timed : queries_->pending) {
    queries_->unused.push_back(timed.begin);
    queries_->unused.push_back(timed.end);
  }
  glDeleteQueries(static_cast<GLsizei>(queries_->unused.size()), queries_->unused.data());
}

void StageTimer::begin() {
  if (!timed_) return;
  if (queries_)
    queries_->begun = queries_->take();
  else
    started_ = now();
}

void StageTimer::end(Stage stage) {
  if (!timed_) return;
  if (queries_) {
    queries_->pending.push_back({stage, queries_->begun, queries_->take()});
    if (queries_->pending.size() > most_pending) collect(most_pending / 2);
  } else {
    glFinish();
    seconds_[static_cast<uint32_t>(stage)] += now() - started_;
  }
}

/// Reads the oldest queries until `keep` are left.
void StageTimer::collect(size_t keep) {
  if (!queries_ || queries_->pending.size() <= keep) return;
  const auto kept = queries_->pending.end() - static_cast<std::ptrdiff_t>(keep);
  for (auto timed = queries_->pending.begin(); timed != kept; ++timed) {
    const auto [stage, begin, end] = *timed;
    const uint64_t from = nanoseconds_at(begin), to = nanoseconds_at(end);
    seconds_[static_cast<uint32_t>(stage)] += seconds_between(from, to);
    queries_->unused.push_back(begin);
    queries_->unused.push_back(end);
  }
  queries_->pending.erase(queries_->pending.begin(), kept);
}

void StageTimer::reset() {
  collect(0);
  seconds_.fill(0);
}

double StageTimer::seconds(Stage stage) {
  collect(0);
  return seconds_[static_cast<uint32_t>(stage)];
}

}  // namespace sluice::gpu
