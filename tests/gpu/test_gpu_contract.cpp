// The contract between shaders and tables, and the user's own shaders: what does not fit is refused by name,
// what does not compile is named with file and line, and what is right is used.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/output/output_file.hpp"
#include "gpu/stage_program.hpp"
#include "sluice/error.hpp"
#include "tests/support/gpu.hpp"
#include "tests/support/run_program.hpp"

namespace sluice::test {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

template <class Expected, class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const Expected& error) {
    return error.what();
  }
  return "";
}

class Contract : public testing::Test {
 protected:
  void TearDown() override { EXPECT_NO_THROW(context.check("the test")); }

  /// A shader for the stage `density` with these declarations, which `use` uses.
  static gpu::ShaderSource source(const std::string& declarations, const std::string& use) {
    return {"mine.comp",
            "#version 430 core\nlayout(local_size_x = 64) in;\nlayout(std430) buffer rho_block { float "
            "rho[]; };\n" +
                declarations + "\nvoid main() { rho[0] = float(" + use + "); }\n",
            {},
            false};
  }
  /// What is said against it; nothing when it is accepted.
  std::string refusal(const std::string& declarations, const std::string& use) const {
    return message_of<Error>([&] { gpu::StageProgram(context, Stage::density, source(declarations, use)); });
  }

  gpu::Context context;
};

TEST_F(Contract, AShaderThatKeepsItIsBoundByName) {
  const gpu::StageProgram program(context, Stage::density,
                                  source("layout(std430) buffer x_block { vec2 x[]; };\nlayout(std430) "
                                         "buffer scratch_block { uint scratch[]; };\n"
                                         "layout(std140) uniform params_block { float h; float m; } params;",
                                         "x[1].y + float(scratch[1]) + params.m"));
  std::set<Field> fields;
  int scratch = 0;
  for (const gpu::BoundBlock& block : program.blocks()) {
    if (block.what == gpu::BoundBlock::What::field) fields.insert(block.field);
    if (block.what == gpu::BoundBlock::What::scratch) ++scratch;
  }
  EXPECT_EQ(fields, (std::set{Field::rho, Field::x}));
  EXPECT_EQ(scratch, 1);
}

TEST_F(Contract, ABlockThatTheStageDoesNotHaveIsNamed) {
  EXPECT_EQ(refusal("layout(std430) buffer v_block { vec2 v[]; };", "v[0].x"),
            "mine.comp: has the storage block v_block, which the stage's row in the table does not");
  EXPECT_TRUE(has(refusal("layout(std430) buffer own_block { vec2 own[]; };", "own[0].x"), "own_block"));
}

TEST_F(Contract, AUniformOutsideTheBlocksIsNamed) {
  EXPECT_EQ(refusal("uniform uint own;", "own"),
            "mine.comp: has the uniform own, expected constants in the blocks that it is given only");
  EXPECT_EQ(
      refusal("layout(std140) uniform own_block { uint own; };", "own"),
      "mine.comp: has the uniform own in own_block, expected constants in the blocks that it is given only");
  EXPECT_EQ(refusal("layout(std140) uniform pass_block { uint count, cells; };", "cells"), "");
  EXPECT_EQ(refusal("layout(std140) uniform pass_block { uint cells; };", "cells"),
            "mine.comp: the uniform cells does not have the type and place that the table gives it");
}

TEST_F(Contract, AnotherStrideIsNamed) {
  EXPECT_EQ(refusal("layout(std140) buffer wall_density_block { float wall_density[]; };", "wall_density[0]"),
            "mine.comp: an element of wall_density_block has 16 bytes, expected 4");
}

TEST_F(Contract, AnotherTypeIsNamed) {
  for (const std::string declaration : {"vec4 x[];", "ivec2 x[];", "dvec2 x[];", "vec2 other; vec2 x[];"}) {
    const std::string message = refusal("layout(std430) buffer x_block { " + declaration + " };", "x[0].x");
    EXPECT_EQ(message,
              "mine.comp: the storage block x_block is not one array of the type that the table gives it")
        << declaration;
  }
  EXPECT_TRUE(has(refusal("layout(std430) buffer scratch_block { float scratch[]; };", "scratch[0]"),
                  "scratch_block"));
}

TEST_F(Contract, AParameterThatMovedIsNamed) {
  const auto with = [&](const std::string& members, const std::string& use) {
    return refusal("layout(std140) uniform params_block { " + members + " } params;", use);
  };
  EXPECT_EQ(with("float h; float m;", "params.m"), "");
  EXPECT_TRUE(
      has(with("float m;", "params.m"), "m does not have the type and place that the table gives it"));
  EXPECT_TRUE(has(with("float h; vec4 m;", "params.m.x"), "uniform m "));
  EXPECT_TRUE(has(with("uint h;", "params.h"), "uniform h "));
  EXPECT_TRUE(has(with("float unknown;", "params.unknown"), "uniform unknown "));
  EXPECT_TRUE(
      has(refusal("uniform own_block { float mine; } own;", "own.mine"), "uniform mine in own_block"));
}

TEST_F(Contract, AnImageThatTheStageDoesNotHaveIsNamed) {
  EXPECT_EQ(refusal("layout(r32f) uniform readonly imageBuffer x_texels;", "imageLoad(x_texels, 0).x"), "");
  for (const std::string name : {"v_texels", "rho_texels", "own"}) {
    EXPECT_EQ(
        refusal("layout(r32f) uniform readonly imageBuffer " + name + ";", "imageLoad(" + name + ", 0).x"),
        "mine.comp: reads the image " + name + ", which the stage's row in the table does not give it");
  }
}

TEST_F(Contract, OfTheUsersShadersItIsBadInput) {
  gpu::ShaderSource mine = source("layout(std430) buffer v_block { vec2 v[]; };", "v[0].x");
  EXPECT_ANY_THROW(message_of<InputError>([&] { gpu::StageProgram(context, Stage::density, mine); }));
  mine.overridden = true;
  EXPECT_TRUE(message_of<InputError>([&] {
                gpu::StageProgram(context, Stage::density, mine);
              }).starts_with("--shader-dir: mine.comp: has the storage block v_block"));
}

/// A folder of the user's, and the stage `density` of one particle run with it.
class ShaderFolder : public testing::Test {
 protected:
  void put(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder / name).parent_path());
    write_file(folder / name, text);
  }
  std::string at(const std::string& place) const { return (folder / place).string(); }

  double density() const {
    Gpu gpu({}, gpu::ShaderLibrary(folder.path));
    gpu.allocate({Field::x, Field::list, Field::index, Field::rho}, {.fluid = 1, .list = 16});
    Params params;
    params.n = 1;
    params.m = 2;
    params.inverse_H = params.kernel_factor = 1;
    gpu.backend->configure(params, Needs{});
    gpu.backend->run(Stage::density);
    return gpu.reals(Field::rho).at(0);
  }
  std::string refusal() const {
    const std::string message = message_of<InputError>([&] { density(); });
    EXPECT_TRUE(message.starts_with("--shader-dir: ")) << message;
    return message;
  }

  TemporaryFolder folder;
};

TEST_F(ShaderFolder, AnOverrideIsUsed) {
  put("density.comp", "void run(uint i) { rho[i] = 7.0 + params.m; }\n");
  EXPECT_EQ(density(), 9);
}

TEST_F(ShaderFolder, AnOverriddenIncludeIsUsedByTheProgramsOwnShaders) {
  put("lib/kernel.glsl",
      "#include \"lib/vectors.glsl\"\nfloat kernel(float r) { return 5.0; }\nvec2 kernel_gradient(vec2 x_ij, "
      "float r) { return x_ij; }\n");
  EXPECT_EQ(density(), 10);
  put("lib/kernel.glsl",
      "#include \"lib/vectors.glsl\"\nfloat kernel(float r) { return 6.0; }\nvec2 kernel_gradient(vec2 x_ij, "
      "float r) { return x_ij; }\n");
  EXPECT_EQ(density(), 12);
}

TEST_F(ShaderFolder, WithoutOverridesOfAStageTheProgramsOwnIsUsed) {
  put("predict.comp", "nonsense that nothing compiles here\n");
  EXPECT_EQ(density(), 2 * (8 - 4));
}

TEST_F(ShaderFolder, ACompileErrorNamesFileAndLine) {
  put("density.comp", "#include \"lib/kernel.glsl\"\n\nvoid run(uint i) {\n  rho[i] = nobody_knows;\n}\n");
  std::string message = refusal();
  EXPECT_TRUE(has(message, at("density.comp") + " does not compile:\n")) << message;
  EXPECT_TRUE(has(message, at("density.comp:4: "))) << message;
  EXPECT_TRUE(has(message, "nobody_knows")) << message;
  put("density.comp", "\nvoid run(uint i) {\n  rho[i] = kernel(0.0);\n}\n#include \"lib/kernel.glsl\"\n");
  EXPECT_TRUE(has(refusal(), at("density.comp:3: ")));
}

TEST_F(ShaderFolder, ACompileErrorInAnIncludeNamesThatFileAndItsLine) {
  put("lib/kernel.glsl",
      "// A kernel.\n#include \"lib/vectors.glsl\"\n\nfloat kernel(float r) {\n  return rr;\n}\n");
  const std::string message = refusal();
  EXPECT_TRUE(has(message, "density.comp does not compile:\n")) << message;
  EXPECT_TRUE(has(message, at("lib/kernel.glsl:5: "))) << message;
}

TEST_F(ShaderFolder, WhatThePreludeForbidsNamesFileAndLine) {
  put("density.comp", "void run(uint i) {\n  x[i] = vec2(0.0);\n}\n");
  EXPECT_TRUE(has(refusal(), at("density.comp:2: "))) << refusal();
  put("density.comp",
      "layout(std430) buffer index_block { float index[]; };\nvoid run(uint i) { rho[i] = index[i]; }\n");
  EXPECT_TRUE(has(refusal(), "index_block")) << refusal();
  put("density.comp",
      "layout(std140) uniform params_block { float dt; } mine;\nvoid run(uint i) { rho[i] = mine.dt; }\n");
  EXPECT_TRUE(has(refusal(), "params_block")) << refusal();
  put("density.comp",
      "\nlayout(std430) buffer v_block { vec2 v[]; };\nvoid run(uint i) { rho[i] = v[i].x; }\n");
  EXPECT_TRUE(has(refusal(), at("density.comp: has the storage block v_block"))) << refusal();
}

TEST_F(ShaderFolder, WithoutTheFunctionThatIsCalledTheCallIsNamed) {
  put("density.comp", "void runs(uint i) { rho[i] = 1.0; }\n");
  EXPECT_TRUE(has(refusal(), "(epilogue):")) << refusal();
  EXPECT_TRUE(has(refusal(), "run")) << refusal();
}

TEST_F(ShaderFolder, AnIncludeThatIsNotThereIsNamedWithItsPlace) {
  put("density.comp", "\n#include \"lib/none.glsl\"\nvoid run(uint i) {}\n");
  EXPECT_EQ(refusal(), "--shader-dir: " + at("density.comp:2: no file \"lib/none.glsl\" to include"));
}

TEST_F(ShaderFolder, AnEmptyFileOrAFolderInPlaceOfOneIsRefused) {
  put("density.comp", "");
  EXPECT_EQ(refusal(), "--shader-dir: " + at("density.comp is empty or cannot be read"));
  std::filesystem::remove(folder / "density.comp");
  std::filesystem::create_directory(folder / "density.comp");
  EXPECT_EQ(refusal(), "--shader-dir: " + at("density.comp is empty or cannot be read"));
}

TEST_F(ShaderFolder, IsThereAndHasShaders) {
  EXPECT_TRUE(
      has(refusal(), folder.path.string() + ", which has no file named like one of the program's shaders"));
  put("my_density.txt", "void run(uint i) {}\n");
  put("DejaVuSans.ttf", "no shader");
  EXPECT_TRUE(has(refusal(), "which has no file named like one of the program's shaders"));
  const auto open = [](const std::filesystem::path& path) {
    return message_of<InputError>([&] { const gpu::ShaderLibrary library(path); });
  };
  EXPECT_TRUE(has(open(folder / "none"), (folder / "none").string() + ", which is no folder"));
  EXPECT_TRUE(has(open(folder / "my_density.txt"), "which is no folder"));
}

// What would never be used is refused, or its author would take the program's own shader for theirs.
TEST_F(ShaderFolder, AMisplacedOrMisnamedShaderIsRefused) {
  put("density.comp", "void run(uint i) {}\n");
  put("densty.comp", "void run(uint i) {}\n");
  EXPECT_EQ(refusal(),
            "--shader-dir: found " + at("densty.comp") + ", expected names that are in the folder shaders/");
  std::filesystem::remove(folder / "densty.comp");
  put("kernel.glsl", "float kernel(float r) { return r; }\n");
  EXPECT_EQ(refusal(),
            "--shader-dir: found " + at("kernel.glsl") + ", expected lib/kernel.glsl under the folder given");
  std::filesystem::remove(folder / "kernel.glsl");
  put("own.glsl", "// for includes\n");
  put("notes.txt", "");
  EXPECT_NO_THROW(gpu::ShaderLibrary(folder.path)) << "files of the user's own may be there";
}

TEST(ShaderMessages, NumbersBecomeFileNames) {
  const std::vector<std::string> files{"(prelude)", "density.comp", "lib/kernel.glsl"};
  const auto named = [&](const std::string& line) { return gpu::with_file_names(line, files); };
  // Mesa
  EXPECT_EQ(named("0:100012(5): error: `a' undeclared"), "density.comp:12: error: `a' undeclared\n");
  EXPECT_EQ(named("0:200003(12): warning: x"), "lib/kernel.glsl:3: warning: x\n");
  EXPECT_EQ(named("0:7(1): error: x"), "(prelude):7: error: x\n");
  // NVIDIA
  EXPECT_EQ(named("0(100012) : error C1503: undefined variable \"a\""),
            "density.comp:12: error C1503: undefined variable \"a\"\n");
  EXPECT_EQ(named("0(200001) : warning C7050: x"), "lib/kernel.glsl:1: warning C7050: x\n");
  // whatever else there is stays
  for (const std::string other : {"error: x", "", "0", "0:", "0(", "12 errors", "0:300001(1): error: x",
                                  "0:0(0): error: x", "no 0:100001"})
    EXPECT_EQ(named(other), other.empty() ? "" : other + "\n");
  EXPECT_EQ(named("0:100001(1): a\n0:200002(2): b\n"), "density.comp:1: a\nlib/kernel.glsl:2: b\n");
}

}  // namespace
}  // namespace sluice::test
