// The subcommands. Each returns the exit code of the program and throws Error for what a user can mend.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/sluice/options.hpp"

namespace sluice::app {

int run_command(const RunOptions& options);
int agree_command(const AgreeOptions& options);
int play_command(const PlayOptions& options);
int export_command(const ExportOptions& options);
int study_command(const StudyOptions& options);
int scenes_command(bool keys);
int agree_stage_command(const AgreeOptions& options);
int shader_command(const std::string& scene, const std::vector<std::string>& overrides,
                   const std::string& stage, const std::optional<std::filesystem::path>& shader_dir);
int info_command(const std::optional<std::string>& scene, const std::vector<std::string>& overrides);

}  // namespace sluice::app
