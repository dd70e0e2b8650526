// Writes all stages' shaders as C++ to the file named on the command line: each pass as it is compiled for a
// graphics card, and once more with each seeded fault in it. What GLSL has and C++ has not,
// tests/translated/glsl.hpp provides.
#include <fmt/format.h>

#include <fstream>
#include <iostream>
#include <regex>
#include <set>

#include "gpu/stage_program.hpp"
#include "tests/translated/faults.hpp"

namespace sluice::test {
namespace {

constexpr uint32_t group_size = 64;

std::string replaced(const std::string& text, const char* pattern, const char* by) {
  return std::regex_replace(text, std::regex(pattern), by);
}

/// GLSL -> what a namespace holds.
std::string as_cpp(std::string text) {
  text.erase(text.rfind("\nvoid main()"));  // dispatch() stands for it
  text = replaced(text, "#version[^\n]*\n|#line[^\n]*\n|layout\\(local_size_x[^\n]*\n", "");
  text = replaced(text, "layout\\(std140\\)[^}]*\\}[^;]*;", "");
  text = replaced(text, "layout\\(std430\\) restrict readonly buffer (\\w+) \\{ (\\w+) (\\w+)\\[\\]; \\};",
                  "const ReadOnly<$2> $3{memory_of(\"$1\")};");
  text = replaced(text, "layout\\(std430\\) restrict buffer (\\w+) \\{ (\\w+) (\\w+)\\[\\]; \\};",
                  "const Buffer<$2> $3{memory_of(\"$1\")};");
  text = replaced(text, "shared (\\w+) (\\w+)\\[(\\w+)\\];", "Shared<$1, $3> $2;");
  text = replaced(text, "const bool (needs_\\w+) = \\w+;", "bool $1 = false;");
  text = replaced(text, "\\bprecise\\b", "");
  return replaced(text, "(\\d+\\.\\d*(e[-+]?\\d+)?)", "$1f");
}

std::set<std::string> words_after(const std::string& text, const char* pattern) {
  std::set<std::string> found;
  const std::regex expression(pattern);
  for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
    found.insert((*at)[1]);
  return found;
}

struct Written {
  std::string units, table;
};

void add_unit(Written& written, Stage stage, const gpu::Pass& pass, const std::string& fault,
              const std::string& glsl) {
  const std::string text = as_cpp(glsl);
  const std::string name =
      fmt::format("{}_{}{}{}", info(stage).name, pass.number, fault.empty() ? "" : "_", fault);
  written.units += fmt::format("namespace {} {{\n{}\n}}  // namespace {}\n", name, text, name);
  for (const std::string& macro : words_after(text, "#define (\\w+)"))
    written.units += fmt::format("#undef {}\n", macro);
  std::string needs;
  for (const std::string& need : words_after(text, "bool needs_(\\w+) = false;"))
    needs += fmt::format("{{\"{0}\", &{1}::needs_{0}}}, ", need, name);
  const bool groups = pass.entry == gpu::Entry::group;
  written.table += fmt::format("    {{\"{}\", {}, \"{}\", {}::{}, gpu::Entry::{}, {{{}}}}},\n",
                               info(stage).name, pass.number, fault, name, groups ? "run_group" : "run",
                               groups ? "group" : "invocation", needs);
}

std::string with_fault(const std::string& glsl, const SeededFault& fault) {
  const size_t at = glsl.find(fault.was);
  if (at == std::string::npos) return glsl;
  return std::string(glsl).replace(at, fault.was.size(), fault.is);
}

std::string translation() {
  const gpu::ShaderLibrary shaders;
  Written written;
  std::set<std::string_view> seeded;
  for (uint32_t s = 0; s < stage_count; ++s) {
    const Stage stage = static_cast<Stage>(s);
    std::set<uint32_t> seen;
    for (const gpu::Pass& pass :
         gpu::passes_of(stage, {.fluid = 2 * chunk_width * chunk_width}, group_size)) {
      if (!seen.insert(pass.number).second) continue;
      const std::string glsl =
          gpu::stage_source(shaders, stage, {}, pass, group_size, gpu::Loads::blocks).text;
      add_unit(written, stage, pass, "", glsl);
      for (const SeededFault& fault : seeded_faults) {
        if (fault.stage != info(stage).name) continue;
        const std::string faulty = with_fault(glsl, fault);
        if (faulty == glsl) continue;
        add_unit(written, stage, pass, std::string(fault.name), faulty);
        seeded.insert(fault.name);
      }
    }
  }
  if (seeded.size() != seeded_faults.size()) throw std::logic_error("a seeded fault of no stage");
  return "#include \"tests/translated/glsl.hpp\"\n\nnamespace sluice::glsl {\n\n" + written.units +
         "\nconst std::vector<Unit>& units() {\n  static const std::vector<Unit> all = {\n" + written.table +
         "  };\n  return all;\n}\n\n}  // namespace sluice::glsl\n";
}

}  // namespace
}  // namespace sluice::test

int main(int count, char** words) {
  if (count != 2) return 2;
  try {
    std::ofstream file(words[1]);
    file << sluice::test::translation();
    return file.flush() ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << "translate: " << error.what() << '\n';
    return 1;
  }
}
