// Reading, expanding and compiling shaders.
#include "gpu/shader.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "gpu/embedded.hpp"
#include "sluice/error.hpp"

namespace sluice::gpu {
namespace {

/// The file's number goes into the line's: drivers tend to forget the second number of `#line`.
constexpr uint32_t lines_per_file = 100'000;

std::string line_directive(size_t file, uint32_t line) {
  return fmt::format("#line {}\n", file * lines_per_file + line);
}

/// The file that a line `#include "FILE"` names.
std::optional<std::string> included_file(std::string_view line) {
  constexpr std::string_view directive = "#include \"";
  if (!line.starts_with(directive)) return std::nullopt;
  line.remove_prefix(directive.size());
  const size_t quote = line.find('"');
  if (quote == std::string_view::npos) return std::nullopt;
  return std::string(line.substr(0, quote));
}

bool is_shader(std::string_view name) {
  const auto dot = name.rfind('.');
  return dot != std::string_view::npos && name.substr(dot) != ".ttf";
}

bool is_known(std::string_view name) {
  return is_shader(name) && std::ranges::find(embedded_names(), name) != embedded_names().end();
}

/// A shader that would never be used is a mistake: one of ours in another place, or under a name that none
/// has. Files that only the user's shaders include may be called as they like.
void refuse_misplaced(const std::filesystem::path& path) {
  std::string expected;
  for (const std::string_view name : embedded_names()) {
    if (is_shader(name) && std::filesystem::path(name).filename() == path.filename()) expected = name;
  }
  const bool program =
      path.extension() == ".comp" || path.extension() == ".vert" || path.extension() == ".frag";
  if (expected.empty() && !program) return;
  throw InputError(fmt::format(
      "--shader-dir: found {}, expected {}", path.string(),
      expected.empty() ? "names that are in the folder shaders/" : expected + " under the folder given"));
}

/// Takes a number off the front of `text`.
std::optional<uint32_t> take_number(std::string_view& text) {
  uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<size_t>(end - text.data()));
  return value;
}

/// "0:100012(5): error" of Mesa or "0(100012) : error" of NVIDIA becomes "FILE:12: error".
std::string with_file_name(std::string_view line, const std::vector<std::string>& files) {
  std::string_view rest = line;
  if (!take_number(rest) || rest.empty() || (rest[0] != ':' && rest[0] != '(')) return std::string(line);
  const bool bracket = rest[0] == '(';
  rest.remove_prefix(1);
  const auto number = take_number(rest);
  if (!number || *number % lines_per_file == 0 || *number / lines_per_file >= files.size())
    return std::string(line);  // line 0 is what drivers say when they know no place
  if (bracket && rest.starts_with(')')) rest.remove_prefix(1);
  if (rest.starts_with('(')) rest.remove_prefix(std::min(rest.find(')') + 1, rest.size()));
  rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  return fmt::format("{}:{}{}{}", files[*number / lines_per_file], *number % lines_per_file,
                     rest.starts_with(':') ? "" : ": ", rest);
}

template <class GetLength, class GetLog>
std::string log_of(GLuint object, GetLength get_length, GetLog get_log) {
  GLint size = 0;
  get_length(object, GL_INFO_LOG_LENGTH, &size);
  std::string log(static_cast<size_t>(std::max(size, 1)), '\0');
  get_log(object, size, &size, log.data());
  log.resize(static_cast<size_t>(size));
  return log;
}

}  // namespace

void refuse_shader(bool overridden, const std::string& message) {
  if (overridden) throw InputError("--shader-dir: " + message);
  throw Error(message);
}

ShaderLibrary::ShaderLibrary(std::optional<std::filesystem::path> folder) : folder_(std::move(folder)) {
  if (const char* folder_of_all = std::getenv("SLUICE_SHADER_DIR"); !folder_ && folder_of_all != nullptr)
    folder_ = folder_of_all;
  if (!folder_) return;
  std::error_code error;
  if (!std::filesystem::is_directory(*folder_, error)) {
    throw InputError(fmt::format("--shader-dir: found {}, which is no folder, expected one with shaders",
                                 folder_->string()));
  }
  bool any = false;
  for (const char* part : {"", "lib", "draw"}) {
    for (const auto& entry : std::filesystem::directory_iterator(*folder_ / part, error)) {
      const std::string name = entry.path().lexically_relative(*folder_).string();
      any = any || is_known(name);
      if (!is_known(name)) refuse_misplaced(entry.path());
    }
  }
  if (any) return;
  throw InputError(fmt::format(
      "--shader-dir: found {}, which has no file named like one of the program's shaders, expected "
      "some of those in the folder shaders/, as density.comp or lib/kernel.glsl",
      folder_->string()));
}

ShaderLibrary::File ShaderLibrary::read(std::string_view name) const {
  std::error_code error;
  if (folder_ && std::filesystem::exists(*folder_ / name, error)) {
    const std::filesystem::path path = *folder_ / name;
    std::ifstream stream(path);
    std::ostringstream text;
    text << stream.rdbuf();
    if (text.str().empty()) refuse_shader(true, path.string() + " is empty or cannot be read");
    return {path.string(), text.str(), true};
  }
  return {std::string(name), std::string(embedded_file(name)), false};
}

void ShaderLibrary::append(ShaderSource& source, const File& file, std::vector<std::string>& included) const {
  const size_t number = source.files.size();
  source.files.push_back(file.name);
  source.overridden = source.overridden || file.overridden;
  std::istringstream lines(file.text);
  uint32_t line_number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++line_number;
    if (line_number == 1 && !line.starts_with("#version")) source.text += line_directive(number, 1);
    const auto name = included_file(line);
    if (!name) {
      source.text += line + '\n';
      continue;
    }
    if (std::find(included.begin(), included.end(), *name) == included.end()) {
      included.push_back(*name);
      const File inner = read(*name);
      if (inner.text.empty()) {
        refuse_shader(file.overridden,
                      fmt::format("{}:{}: no file \"{}\" to include", file.name, line_number, *name));
      }
      append(source, inner, included);
    }
    source.text += line_directive(number, line_number + 1);
  }
}

ShaderSource ShaderLibrary::load(std::string_view name, std::string_view prelude,
                                 std::string_view epilogue) const {
  const File file = read(name);
  if (file.text.empty()) throw Error(fmt::format("{}: no such shader in this program; build it again", name));
  ShaderSource source;
  source.name = file.name;
  if (!prelude.empty()) source.files.emplace_back("(prelude)");
  source.text = prelude;
  std::vector<std::string> included;
  append(source, file, included);
  if (!epilogue.empty()) {
    source.text += line_directive(source.files.size(), 1);
    source.text += epilogue;
    source.files.emplace_back("(epilogue)");
  }
  return source;
}

std::string with_places(const ShaderSource& source) {
  constexpr std::string_view directive = "#line ";
  std::istringstream lines(source.text);
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    std::string_view rest = line;
    std::optional<uint32_t> number;
    if (rest.starts_with(directive)) {
      rest.remove_prefix(directive.size());
      number = take_number(rest);
    }
    text += number ? fmt::format("// {}:{}", source.files[*number / lines_per_file], *number % lines_per_file)
                   : line;
    text += '\n';
  }
  return text;
}

std::string with_file_names(std::string_view log, const std::vector<std::string>& files) {
  std::string text;
  while (!log.empty()) {
    const size_t end = std::min(log.find('\n'), log.size());
    text += with_file_name(log.substr(0, end), files) + '\n';
    log.remove_prefix(std::min(end + 1, log.size()));
  }
  return text;
}

Shader::Shader(uint32_t kind, const ShaderSource& source) : name_(glCreateShader(kind)) {
  const GLchar* text = source.text.data();
  const GLint length = static_cast<GLint>(source.text.size());
  glShaderSource(name_, 1, &text, &length);
  glCompileShader(name_);
  GLint done = GL_FALSE;
  glGetShaderiv(name_, GL_COMPILE_STATUS, &done);
  if (done == GL_TRUE) return;
  const std::string log = log_of(name_, glGetShaderiv, glGetShaderInfoLog);
  glDeleteShader(name_);
  refuse_shader(source.overridden,
                fmt::format("{} does not compile:\n{}", source.name, with_file_names(log, source.files)));
}

Shader::~Shader() { glDeleteShader(name_); }

void link_program(uint32_t program, const std::vector<const ShaderSource*>& sources) {
  glLinkProgram(program);
  GLint done = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &done);
  if (done == GL_TRUE) return;
  std::string names;
  bool overridden = false;
  for (const ShaderSource* source : sources) {
    names += (names.empty() ? "" : " and ") + source->name;
    overridden = overridden || source->overridden;
  }
  std::string log = log_of(program, glGetProgramiv, glGetProgramInfoLog);
  if (sources.size() == 1) log = with_file_names(log, sources[0]->files);
  refuse_shader(overridden,
                fmt::format("{} {} not link:\n{}", names, sources.size() > 1 ? "do" : "does", log));
}

}  // namespace sluice::gpu
