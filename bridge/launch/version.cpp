// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/launch/version.hpp"

#include <fmt/format.h>

#include <fstream>

#include "bridge/process/stopped.hpp"
#include "bridge/process/supervisor.hpp"
#include "bridge/process/temporary_folder.hpp"
#include "commit.hpp"

namespace blockweir::launch {
namespace {

#ifdef __clang__
constexpr const char* compiler = "clang " __clang_version__;
#else
constexpr const char* compiler = "GCC " __VERSION__;
#endif

/// The program blockweir-openfoam, in the same folder, knows its version of OpenFOAM.
std::string openfoam() {
  const auto program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "blockweir-openfoam";
  if (!std::filesystem::exists(program)) return "none: blockweir-openfoam is not installed";
  const process::TemporaryFolder folder;
  process::Command command{"openfoam", {program.string(), "--version"}};
  command.output = folder.path() / "version";
  const process::Supervised supervised = process::supervise(
      {command}, folder.path(), 1, [] { return true; }, 10);
  if (supervised.asked_to_stop) throw process::Stopped();
  std::string line;
  std::getline(std::ifstream(command.output), line);
  return line;
}

}  // namespace

std::string version() {
  return fmt::format("blockweir {}\ncommit    {}\ncompiler  {}\nOpenFOAM  {}", BLOCKWEIR_VERSION, BLOCKWEIR_COMMIT,
                     compiler, openfoam());
}

}  // namespace blockweir::launch
