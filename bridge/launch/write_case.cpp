// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/launch/write_case.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace blockweir::launch {

void write_case(const CaseOptions& options) {
  const auto program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "blockweir-openfoam";
  std::vector<std::string> words = {program, options.scene, "--out", options.out, "--case-only"};
  for (const std::string& set : options.overrides) words.insert(words.end(), {"--set", set});
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ::execv(program.c_str(), arguments.data());
  throw std::runtime_error(fmt::format("cannot start {}: {}", program.string(), std::strerror(errno)));
}

}  // namespace blockweir::launch
