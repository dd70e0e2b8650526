// What the GPU backend asks of OpenGL, seen from between the two: no driver here shows what comes of it on a
// card.
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "gpu/timer.hpp"
#include "sluice/error.hpp"
#include "tests/support/gpu.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

/// A function of OpenGL's with another one in its place, as long as this lives.
template <class Function>
class InPlaceOf {
 public:
  InPlaceOf(Function*& place, Function* other) : place_(place), before_(place) { place = other; }
  /// Keeps the function itself in `real`, for the other one to call.
  InPlaceOf(Function*& place, Function* other, Function*& real) : InPlaceOf(place, other) { real = before_; }
  ~InPlaceOf() { place_ = before_; }
  InPlaceOf(const InPlaceOf&) = delete;
  InPlaceOf& operator=(const InPlaceOf&) = delete;

 private:
  Function*& place_;
  Function* before_;
};

/// An environment variable with this value, as long as this lives.
class WithEnvironment {
 public:
  WithEnvironment(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    value != nullptr ? setenv(name, value, 1) : unsetenv(name);
  }
  ~WithEnvironment() { before_ ? setenv(name_, before_->c_str(), 1) : unsetenv(name_); }
  WithEnvironment(const WithEnvironment&) = delete;
  WithEnvironment& operator=(const WithEnvironment&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

/// What the functions below, which can't have state of their own, have seen.
struct Seen {
  std::map<GLuint, GLuint> storage;  ///< buffers by their binding
  std::set<GLuint> bound, read;      ///< buffers that shaders used, and those that were read back
  int twice = 0;                     ///< dispatches with one buffer in two places
  int queries = 0, waits = 0;
  std::vector<uint32_t> indirect;  ///< numbers of groups of all indirect dispatches
  bool bind_twice = false;         ///< puts the buffer of the first place into the second one, too
};
Seen seen;

decltype(epoxy_glBindBufferBase) bind_base;
decltype(epoxy_glGetBufferSubData) get_data;
decltype(epoxy_glDispatchCompute) dispatch_compute;
decltype(epoxy_glDispatchComputeIndirect) dispatch_indirect;
decltype(epoxy_glQueryCounter) query_counter;
decltype(epoxy_glFinish) finish;

void note_dispatch() {
  std::set<GLuint> buffers;
  GLint size = 0;
  for (const auto& [binding, buffer] : seen.storage) {
    // Fields of a model that the scene does without share a buffer of no use.
    glBindBuffer(GL_COPY_READ_BUFFER, buffer);
    glGetBufferParameteriv(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE, &size);
    if (size > 16 && !buffers.insert(buffer).second) ++seen.twice;
  }
  seen.storage.clear();
}
void EPOXY_CALLSPEC on_bind_base(GLenum target, GLuint index, GLuint buffer) {
  if (target == GL_SHADER_STORAGE_BUFFER) {
    if (seen.bind_twice && index == 1) buffer = seen.storage[0];
    seen.storage[index] = buffer;
    seen.bound.insert(buffer);
  }
  bind_base(target, index, buffer);
}
void EPOXY_CALLSPEC on_get_data(GLenum target, GLintptr offset, GLsizeiptr size, void* data) {
  GLint buffer = 0;
  glGetIntegerv(target == GL_COPY_READ_BUFFER ? GL_COPY_READ_BUFFER_BINDING : GL_COPY_WRITE_BUFFER_BINDING,
                &buffer);
  seen.read.insert(static_cast<GLuint>(buffer));
  get_data(target, offset, size, data);
}
void EPOXY_CALLSPEC on_dispatch(GLuint x, GLuint y, GLuint z) {
  note_dispatch();
  dispatch_compute(x, y, z);
}
void EPOXY_CALLSPEC on_dispatch_indirect(GLintptr offset) {
  note_dispatch();
  std::array<uint32_t, 3> groups{};
  get_data(GL_DISPATCH_INDIRECT_BUFFER, offset, sizeof(groups), groups.data());
  seen.indirect.push_back(groups[0] * groups[1]);
  dispatch_indirect(offset);
}
void EPOXY_CALLSPEC on_query_counter(GLuint query, GLenum target) {
  ++seen.queries;
  query_counter(query, target);
}
void EPOXY_CALLSPEC on_finish() {
  ++seen.waits;
  finish();
}
/// A clock that counts from 1970 and takes two microseconds for everything.
void EPOXY_CALLSPEC on_query_result(GLuint, GLenum, GLuint64* nanoseconds) {
  static GLuint64 now = 1'760'000'000'000'000'001;
  *nanoseconds = now += 2000;
}

/// What is put in OpenGL's place while this lives. Everything was called before, so that epoxy has found it.
struct Watch {
  InPlaceOf<decltype(on_bind_base)> a{epoxy_glBindBufferBase, on_bind_base, bind_base};
  InPlaceOf<decltype(on_get_data)> b{epoxy_glGetBufferSubData, on_get_data, get_data};
  InPlaceOf<decltype(on_dispatch)> c{epoxy_glDispatchCompute, on_dispatch, dispatch_compute};
  InPlaceOf<decltype(on_dispatch_indirect)> d{epoxy_glDispatchComputeIndirect, on_dispatch_indirect,
                                              dispatch_indirect};
  InPlaceOf<decltype(on_query_counter)> e{epoxy_glQueryCounter, on_query_counter, query_counter};
  InPlaceOf<decltype(on_finish)> f{epoxy_glFinish, on_finish, finish};
};

/// Runs a step, and then some whose calls are seen.
Seen seen_in(const Scene& scene, const gpu::BackendOptions& options = {}, bool bind_twice = false) {
  const Samples samples = sample(scene);
  const Gpu gpu(options);
  Simulator simulator(scene, samples, *gpu.backend);
  simulator.step();
  seen = {};
  seen.bind_twice = bind_twice;
  const Watch watch;
  try {
    for (int step = 0; step < 3; ++step) simulator.step();
    simulator.snapshot();
  } catch (const EnvironmentError&) {
    EXPECT_TRUE(bind_twice) << "ids may be anything then";
  }
  return seen;
}

TEST(GpuCalls, NothingThatShadersUseIsReadBack) {
  for (const ShippedRun& run : shipped_runs()) {
    const Seen found = seen_in(run.load());
    EXPECT_FALSE(found.bound.empty() || found.read.empty()) << run.name();
    for (const GLuint buffer : found.read) EXPECT_FALSE(found.bound.contains(buffer)) << run.name();
  }
}

TEST(GpuCalls, NoBufferIsInTwoPlacesOfAShader) {
  for (const ShippedRun& run : shipped_runs()) {
    EXPECT_EQ(seen_in(run.load()).twice, 0) << run.name();
  }
  EXPECT_GT(seen_in(shipped("breaking_dam"), {}, true).twice, 0)
      << "a block that is bound twice is not found";
}

TEST(GpuCalls, TimeIsTakenOnlyWhenItIsAskedFor) {
  for (const bool hardware : {false, true}) {
    const WithEnvironment environment("SLUICE_GL", hardware ? "hardware" : nullptr);
    if (!hardware && !gpu::Context().software()) continue;
    for (const bool timed : {true, false}) {
      const Seen found = seen_in(shipped("breaking_dam"), {.timed = timed});
      EXPECT_EQ(found.queries > 0, hardware && timed);
      EXPECT_EQ(found.waits > 0, !hardware && timed);
    }
  }
}

TEST(GpuCalls, TimestampsKeepTheirDigits) {
  EXPECT_DOUBLE_EQ(gpu::seconds_between(1'760'000'000'000'000'001, 1'760'000'000'000'002'001), 2e-6);
  const WithEnvironment environment("SLUICE_GL", "hardware");
  const Scene scene = shipped("breaking_dam", {"pressure.method=ssph"});
  const Samples samples = sample(scene);
  const Gpu gpu;
  Simulator simulator(scene, samples, *gpu.backend);
  simulator.step();
  EXPECT_GE(gpu.backend->seconds(Stage::density), 0);
  gpu.backend->reset_seconds();
  simulator.step();
  const InPlaceOf<decltype(on_query_result)> clock(epoxy_glGetQueryObjectui64v, on_query_result);
  EXPECT_DOUBLE_EQ(gpu.backend->seconds(Stage::density), 2e-6);
}

// A sweep that was asked for after the last one costs what it takes to enqueue it.
TEST(GpuCalls, SweepsBehindTheLastOneHaveNoGroups) {
  const Scene scene = shipped("breaking_dam");
  const Samples samples = sample(scene);
  const Plan plan = make_plan(model_of(scene));
  const Gpu gpu;
  Simulator simulator(scene, samples, *gpu.backend);
  simulator.step();
  std::array<uint32_t, 2> sweeps{};
  gpu.backend->upload(Field::sweeps, sweeps);
  seen = {};
  {
    const Watch watch;
    gpu.backend->sweep(plan[Phase::sweep], 100);
  }
  gpu.backend->download(Field::sweeps, sweeps);
  ASSERT_GT(sweeps[0], 1u);
  ASSERT_LT(sweeps[0], 90u);
  const size_t passes = seen.indirect.size() / 100;
  EXPECT_EQ(seen.indirect.size(), 100 * passes);
  for (size_t k = 0; k < seen.indirect.size(); ++k) {
    const size_t sweep = k / passes;
    if (sweep < sweeps[0]) {
      EXPECT_GT(seen.indirect[k], 0u) << "sweep " << sweep;
    }
    if (sweep > sweeps[0]) {  // the one in between notices that it is over
      EXPECT_EQ(seen.indirect[k], 0u) << "sweep " << sweep;
    }
  }
}

TEST(GpuCalls, DriversCheckEveryCallOnlyWhenTheyAreAskedTo) {
  for (const bool debug : {false, true}) {
    const WithEnvironment environment("SLUICE_GL", debug ? "debug" : nullptr);
    const gpu::Context context;
    GLint flags = 0;
    glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    EXPECT_EQ((flags & GL_CONTEXT_FLAG_DEBUG_BIT) != 0, debug);
    EXPECT_EQ(glIsEnabled(GL_DEBUG_OUTPUT) == GL_TRUE, debug);
    glEnable(GL_ALPHA);  // no such thing in a core context
    EXPECT_THROW(context.check("a mistake"), Error) << "errors are seen in any case";
  }
}

TEST(GpuCalls, WordsOfTheEnvironmentAreChecked) {
  const WithEnvironment environment("SLUICE_GL", "debug,hardwear");
  try {
    const gpu::Context context;
    FAIL() << "nothing was said";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "the environment variable SLUICE_GL: found \"debug,hardwear\", expected debug or "
                 "hardware, or both with a comma");
  }
}

}  // namespace
}  // namespace sluice::test
