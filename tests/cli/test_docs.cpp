// The pages that describe files and links agree with what is there.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "sluice/load.hpp"
#include "tests/support/run_program.hpp"

namespace sluice::test {
namespace {

const std::filesystem::path source(SLUICE_SOURCE_DIR);

TEST(Docs, EveryColumnAndKeyOfARunIsExplained) {
  const TemporaryFolder folder;
  const std::string series = folder / "series.csv", summary = folder / "summary.json",
                    state = folder / "state.csv";
  ASSERT_EQ(run_program({"run", "breaking_dam", "--steps", "1", "--series", series, "--summary", summary,
                         "--state", state})
                .code,
            0);
  const std::string page = read_file(source / "docs" / "output.md");
  const auto explained = [&](const std::string& name) {
    EXPECT_NE(page.find('`' + name + '`'), std::string::npos) << name;
  };
  for (const std::string& file : {series, state}) {
    std::istringstream text(read_file(file));
    std::string header, column;
    std::getline(text, header);
    std::istringstream columns(header);
    while (std::getline(columns, column, ',')) explained(column);
  }
  const auto json = nlohmann::json::parse(read_file(summary));
  for (const auto& [key, value] : json.items()) explained(key);
}

/// All pages of the project, as paths from its root.
std::vector<std::filesystem::path> pages() {
  std::vector<std::filesystem::path> found{"README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md"};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source / "docs"))
    if (entry.path().extension() == ".md") found.push_back(entry.path().lexically_relative(source));
  return found;
}

/// A page without its programs.
std::string prose_of(const std::string& page) {
  std::string prose;
  bool program = false;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```"))
      program = !program;
    else if (!program)
      prose += line + '\n';
  }
  return prose;
}

TEST(Docs, EveryLinkLeadsSomewhere) {
  const std::regex link(R"(\]\(([^)#]+)(#[^)]*)?\))");
  int links = 0;
  for (const std::filesystem::path& page : pages()) {
    const std::string text = prose_of(read_file(source / page));
    for (std::sregex_iterator match(text.begin(), text.end(), link), end; match != end; ++match) {
      const std::string target = (*match)[1];
      if (target.starts_with("http")) continue;
      ++links;
      EXPECT_TRUE(std::filesystem::exists((source / page).parent_path() / target)) << page << ": " << target;
    }
  }
  EXPECT_GT(links, 50);
}

TEST(Docs, EveryFileThatIsNamedIsThere) {
  const std::regex name(
      "`((sluice|python|core|cpu|gpu|shaders|draw|media|apps|studies|tests|bench|fuzz|scripts|docs|scenes)"
      "/[A-Za-z0-9_./-]+)`");
  int names = 0;
  for (const std::filesystem::path& page : pages()) {
    if (page == "CHANGELOG.md") continue;  // tells of the past
    const std::string text = read_file(source / page);
    for (std::sregex_iterator match(text.begin(), text.end(), name), end; match != end; ++match) {
      ++names;
      EXPECT_TRUE(std::filesystem::exists(source / (*match)[1].str())) << page << ": " << (*match)[1];
    }
  }
  EXPECT_GT(names, 50);
}

TEST(Docs, TheSceneOfTheTutorialParses) {
  const std::string page = read_file(source / "docs" / "writing_a_scene.md");
  const std::string fence = "```toml\n";
  const size_t start = page.find(fence);
  ASSERT_NE(start, std::string::npos);
  const size_t end = page.find("```", start + fence.size());
  ASSERT_NE(end, std::string::npos);
  const std::string text = page.substr(start + fence.size(), end - start - fence.size());
  EXPECT_NO_THROW(parse_scene(text, "my.toml"));
}

TEST(Docs, EveryShippedSceneIsDescribed) {
  const std::string page = read_file(source / "docs" / "scenes.md");
  const std::vector<std::string> scenes = shipped_scenes();
  ASSERT_FALSE(scenes.empty());
  for (const std::string& name : scenes) EXPECT_NE(page.find('`' + name + '`'), std::string::npos) << name;
}

}  // namespace
}  // namespace sluice::test
