// Finding and reading scene files.
#include "sluice/load.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>

#include "core/scene/passes.hpp"
#include "core/scene/tree.hpp"

namespace fs = std::filesystem;

namespace sluice {
namespace {

constexpr size_t max_file_size = 1 << 20;

std::vector<fs::path> scene_folders() {
  std::vector<fs::path> folders{SLUICE_SCENE_DIR};
  std::error_code error;
  fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) folders.push_back(program.parent_path().parent_path() / "share/sluice/scenes");
  folders.push_back(SLUICE_INSTALLED_SCENE_DIR);
  return folders;
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

[[noreturn]] void refuse(const std::string& scene, const std::string& why) {
  throw InputError(one_line(fmt::format("{}: {}", scene, why)));
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(max_file_size + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!file.is_open() || file.bad()) refuse(path, "found a file that can't be read, expected a scene file");
  text.resize(static_cast<size_t>(file.gcount()));
  if (text.size() > max_file_size)
    refuse(path, fmt::format("found more than {} bytes, expected a scene file", max_file_size));
  return text;
}

[[noreturn]] void refuse_missing(const std::string& scene) {
  std::error_code error;
  if (fs::exists(scene, error))
    refuse(scene, fmt::format("found a {}, expected a scene file",
                              fs::is_directory(scene, error) ? "directory" : "special file"));
  const std::string missing = "found no such file, expected the path of a scene file";
  const std::vector<std::string> names = shipped_scenes();
  if (!names.empty()) refuse(scene, fmt::format("{} or one of {}", missing, fmt::join(names, ", ")));
  refuse(scene,
         fmt::format("{}; the shipped scenes are not where they were built ({}) nor beside the program",
                     missing, SLUICE_SCENE_DIR));
}

std::string find_scene(const std::string& scene) {
  if (is_file(scene)) return scene;
  const bool below = !scene.empty() && scene.front() != '/' && scene.find("..") == scene.npos;
  if (below)
    for (const fs::path& folder : scene_folders())
      if (fs::path file = folder / (scene + ".toml"); is_file(file)) return file.string();
  refuse_missing(scene);
}

}  // namespace

Scene load_scene(const std::string& scene, std::span<const std::string> overrides) {
  std::string file = find_scene(scene);
  return parse_scene(read_file(file), file, overrides);
}

Scene parse_scene(std::string_view text, const std::string& file, std::span<const std::string> overrides) {
  SceneValue root = parse_toml(text, file);
  apply_overrides(root, overrides);
  check_scene(root);
  Scene scene = build_scene(root, fs::path(file).stem().string(), file);
  scene.record.text = text;
  scene.record.overrides.assign(overrides.begin(), overrides.end());
  return scene;
}

Scene changed(const Scene& scene, std::span<const std::string> overrides) {
  std::vector<std::string> all = scene.record.overrides;
  all.insert(all.end(), overrides.begin(), overrides.end());
  return parse_scene(scene.record.text, scene.file, all);
}

std::vector<std::string> shipped_scenes() {
  std::vector<std::string> names;
  for (const fs::path& folder : scene_folders()) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
      if (entry->path().extension() == ".toml" && is_file(entry->path()))
        names.push_back(entry->path().stem().string());
  }
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace sluice
