// OpenGL without a display: devices, refusals with their messages, and errors that are not swallowed.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

#include "draw/program.hpp"
#include "gpu/context.hpp"
#include "sluice/error.hpp"

namespace {

using namespace sluice::gpu;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

template <class Expected, class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const Expected& error) {
    return error.what();
  }
  return "";
}

// A program that has a uniform vec4 to be set wrongly.
ShaderSource vertex_source() {
  return {"test.vert", "#version 430 core\nuniform vec4 shift;\nvoid main() { gl_Position = shift; }\n", {}};
}
ShaderSource fragment_source() {
  return {"test.frag", "#version 430 core\nout vec4 result;\nvoid main() { result = vec4(1.0); }\n", {}};
}

TEST(Context, IsAnOpenGl43Core) {
  const Context context;
  EXPECT_FALSE(context.renderer().empty());
  EXPECT_FALSE(context.vendor().empty());
  EXPECT_GE(std::stod(context.version()), 4.3) << context.version();
  EXPECT_NO_THROW(context.check("nothing"));
}

TEST(Context, EveryListedDeviceWorksOrSaysWhyNot) {
  const auto devices = list_devices();
  ASSERT_FALSE(devices.empty());
  int usable = 0;
  for (size_t k = 0; k < devices.size(); ++k) {
    const DeviceInfo& device = devices[k];
    EXPECT_EQ(device.index, static_cast<int>(k));
    EXPECT_NE(device.renderer.empty(), device.problem.empty());
    if (device.problem.empty()) {
      const Context context(device.index);
      EXPECT_TRUE(contains(device.renderer, context.renderer()));
      EXPECT_EQ(device.software, context.software());
      ++usable;
    } else {
      EXPECT_THROW(Context{device.index}, sluice::EnvironmentError);
    }
    EXPECT_TRUE(contains(describe(devices), device.renderer + device.problem));
  }
  EXPECT_GT(usable, 0) << describe(devices);
}

TEST(Context, HardwareIsPreferred) {
  bool hardware = false;
  for (const DeviceInfo& device : list_devices())
    hardware = hardware || (device.problem.empty() && !device.software);
  EXPECT_EQ(Context().software(), !hardware);
}

TEST(Context, AnUnknownDeviceIsBadInputAndTheDevicesAreListed) {
  for (const int device : {-1, 1000}) {
    const std::string message = message_of<sluice::InputError>([&] { const Context context(device); });
    EXPECT_TRUE(contains(message, "no OpenGL device " + std::to_string(device))) << message;
    EXPECT_TRUE(contains(message, describe(list_devices()))) << message;
  }
}

TEST(Context, AMissingLibraryNamesItsPackage) {
  const std::string message =
      message_of<sluice::EnvironmentError>([] { require_library("libNotThere.so.1", "libnotthere1"); });
  EXPECT_TRUE(contains(message, "libNotThere.so.1")) << message;
  EXPECT_TRUE(contains(message, "install the package libnotthere1")) << message;
  EXPECT_NO_THROW(require_library("libEGL.so.1", "libegl1"));
}

TEST(Context, ErrorsWaitForTheCheckAndAreReportedOnce) {
  const Context context;
  sluice::draw::Program program(context, vertex_source(), fragment_source());
  EXPECT_NO_THROW(context.check("a correct program"));
  program.set("shift", 1.0f);  // a float for a vec4
  const std::string message = message_of<sluice::Error>([&] { context.check("setting a uniform"); });
  EXPECT_TRUE(contains(message, "setting a uniform: OpenGL reports")) << message;
  EXPECT_NO_THROW(context.check("afterwards"));
}

TEST(Context, MovedContextGoesOn) {
  Context first;
  Context second = std::move(first);
  sluice::draw::Program program(second, vertex_source(), fragment_source());
  program.set("shift", 1);  // errors must reach the context's new place
  EXPECT_THROW(second.check("moved"), sluice::Error);
}

TEST(Program, ACompileErrorNamesTheFile) {
  const Context context;
  ShaderSource broken = fragment_source();
  broken.text += "float half_a_function(";
  const std::string message = message_of<sluice::Error>(
      [&] { const sluice::draw::Program program(context, vertex_source(), broken); });
  EXPECT_TRUE(contains(message, "test.frag does not compile:\n")) << message;
  EXPECT_GT(message.size(), 40u) << "the driver's log is missing: " << message;
}

TEST(Program, ALinkErrorNamesBothFiles) {
  const Context context;
  const ShaderSource lonely{"lonely.frag",
                            "#version 430 core\nin vec3 nobody_writes;\nout vec4 result;\n"
                            "void main() { result = vec4(nobody_writes, 1.0); }\n",
                            {}};
  const std::string message = message_of<sluice::Error>(
      [&] { const sluice::draw::Program program(context, vertex_source(), lonely); });
  EXPECT_TRUE(contains(message, "test.vert and lonely.frag do not link:\n")) << message;
}

TEST(Program, UnknownNamesAreErrors) {
  const Context context;
  sluice::draw::Program program(context, vertex_source(), fragment_source());
  EXPECT_TRUE(contains(message_of<sluice::Error>([&] { program.set("shfit", 1.0f); }), "no uniform 'shfit'"));
  EXPECT_TRUE(
      contains(message_of<sluice::Error>([&] { program.attribute("place"); }), "no attribute 'place'"));
  EXPECT_TRUE(contains(message_of<sluice::Error>([] { ShaderLibrary().load("none.vert"); }), "none.vert"));
}

// The following need a process in which nothing of OpenGL has been loaded yet.
class FreshProcess : public testing::Test {
 protected:
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

// Exit code 3 and the message of an EnvironmentError, as the program does it.
[[noreturn]] void make_context() {
  try {
    const Context context;
  } catch (const sluice::EnvironmentError& error) {
    std::fputs(error.what(), stderr);
    std::_Exit(3);
  }
  std::_Exit(0);
}

TEST_F(FreshProcess, NothingOfOpenGlIsLoadedBeforeAContext) {
  const auto loaded = [](const char* library) { return dlopen(library, RTLD_LAZY | RTLD_NOLOAD) != nullptr; };
  EXPECT_EXIT(std::_Exit(loaded("libEGL.so.1") || loaded("libOpenGL.so.0") || loaded("libGL.so.1") ? 1 : 0),
              testing::ExitedWithCode(0), "");
}

TEST_F(FreshProcess, WithoutADriverTheMessageSaysWhatToInstall) {
  const auto without_drivers = [] {
    setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent/driver.json", 1);
    make_context();
  };
  EXPECT_EXIT(without_drivers(), testing::ExitedWithCode(3),
              "no OpenGL 4.3 was found; install.*libgl1-mesa-dri.*tried");
}

TEST_F(FreshProcess, AnOlderOpenGlIsRefused) {
  const auto with_old_driver = [] {
    // Mesa, which is always installed for tests, can be told to offer less than it has.
    setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/usr/share/glvnd/egl_vendor.d/50_mesa.json", 1);
    setenv("MESA_GL_VERSION_OVERRIDE", "3.3", 1);
    make_context();
  };
  EXPECT_EXIT(with_old_driver(), testing::ExitedWithCode(3),
              "refuses an OpenGL 4.3 core context|4.3 is needed");
}

}  // namespace
