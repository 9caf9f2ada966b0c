// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "bridge/launch/commands.hpp"

namespace blockweir::launch {
namespace {

struct CaseOptions {
  std::filesystem::path scene;
  std::filesystem::path out = "case";
  std::vector<std::string> overrides;
};

/// Becomes blockweir-openfoam --case-only, which says the rest; throws std::runtime_error when that is missing.
[[noreturn]] void write_case(const CaseOptions& options) {
  const auto program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "blockweir-openfoam";
  std::vector<std::string> words = {program, options.scene, "--out", options.out, "--case-only"};
  for (const std::string& set : options.overrides) words.insert(words.end(), {"--set", set});
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ::execv(program.c_str(), arguments.data());
  throw std::runtime_error(
      fmt::format("cannot start {}: {}; expected it beside this program; build or install blockweir with OpenFOAM",
                  program.string(), std::strerror(errno)));
}

}  // namespace

Work case_command(CLI::App& app) {
  const auto options = std::make_shared<CaseOptions>();
  app.add_option("scene", options->scene, "scene file or case folder")->required();
  app.add_option("--out", options->out, "folder for the case (default: case)");
  app.add_option("--set", options->overrides, "set a key of the scene, as key=value");
  return [options]() -> int { write_case(*options); };
}

}  // namespace blockweir::launch
