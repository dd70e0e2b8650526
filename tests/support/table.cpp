#include "tests/support/table.hpp"

#include <stb_image.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "tests/support/run_program.hpp"

namespace sluice::test {

using namespace study;
namespace {

std::string inline_toml(const nlohmann::ordered_json& value) {
  if (!value.is_structured()) return value.dump();  // numbers and strings are written alike
  std::string text = value.is_array() ? "[" : "{";
  bool first = true;
  for (const auto& item : value.items()) {
    text += (first ? "" : ", ") + (value.is_array() ? "" : item.key() + " = ") + inline_toml(item.value());
    first = false;
  }
  return text + (value.is_array() ? "]" : "}");
}

}  // namespace

nlohmann::ordered_json read_json(const std::filesystem::path& path) {
  return nlohmann::ordered_json::parse(read_file(path));
}

std::string to_toml(const nlohmann::ordered_json& settings) {
  std::string text;
  for (const auto& [key, value] : settings.items()) text += key + " = " + inline_toml(value) + '\n';
  return text;
}

draw::Image read_image(const std::filesystem::path& path) {
  int width = 0, height = 0, channels = 0;
  stbi_uc* bytes = stbi_load(path.c_str(), &width, &height, &channels, 3);
  if (bytes == nullptr) throw std::runtime_error("can't read the picture " + path.string());
  draw::Image image{static_cast<uint32_t>(width), static_cast<uint32_t>(height), {}};
  image.rgb.assign(bytes, bytes + size_t{image.width} * image.height * 3);
  stbi_image_free(bytes);
  return image;
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

}  // namespace sluice::test
