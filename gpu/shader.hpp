// Shader texts and their compilation: includes, a folder that overrides what the binary carries, and messages
// that name file and line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sluice::gpu {

/// Text of a shader, and where it comes from.
struct ShaderSource {
  std::string name;                ///< as messages call it
  std::string text;                ///< pieces of text, each with lines numbered from a multiple of 100,000 on
  std::vector<std::string> files;  ///< what these multiples stand for
  bool overridden = false;         ///< some of it comes from the user's folder
};

/// Source of all shaders: the binary, or for those that are there a folder of the user's.
class ShaderLibrary {
 public:
  /// Library with the shaders of this folder before those of the binary; without one, of the folder that the
  /// environment variable SLUICE_SHADER_DIR names. InputError when the folder is not there or has no shader
  /// that the program knows.
  explicit ShaderLibrary(std::optional<std::filesystem::path> folder = std::nullopt);

  /// Text of the shader of this name behind `prelude`, with lines `#include "FILE"` replaced by that file,
  /// each file once. Error when there is no shader, InputError when an overridden one includes what is not
  /// there.
  ShaderSource load(std::string_view name, std::string_view prelude = {},
                    std::string_view epilogue = {}) const;

 private:
  struct File {
    std::string name, text;
    bool overridden = false;
  };
  File read(std::string_view name) const;
  void append(ShaderSource& source, const File& file, std::vector<std::string>& included) const;

  std::optional<std::filesystem::path> folder_;
};

/// Throws `message`: InputError naming --shader-dir when the shader is the user's, else Error.
[[noreturn]] void refuse_shader(bool overridden, const std::string& message);

/// Text of a shader with places, "// FILE:LINE", instead of what tells the compiler of them.
std::string with_places(const ShaderSource& source);

/// Driver's message with "FILE:LINE" in place of the numbers that it knows.
std::string with_file_names(std::string_view log, const std::vector<std::string>& files);

/// A compiled shader; needed only until its program is linked.
class Shader {
 public:
  /// Compiles `source`; `kind` is OpenGL's, as GL_COMPUTE_SHADER. Error, for overridden sources InputError,
  /// with the driver's log.
  Shader(uint32_t kind, const ShaderSource& source);
  ~Shader();
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;

  uint32_t name() const { return name_; }

 private:
  uint32_t name_;
};

/// Links `program`, to which the shaders of `sources` are attached; what goes wrong is thrown as above.
void link_program(uint32_t program, const std::vector<const ShaderSource*>& sources);

}  // namespace sluice::gpu
