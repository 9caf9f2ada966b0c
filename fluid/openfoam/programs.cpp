// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/programs.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "bridge/process/supervisor.hpp"

namespace blockweir::openfoam {
namespace {

namespace fs = std::filesystem;
constexpr double grace_s = 3;

bool on_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::string folders = path != nullptr ? path : "";
  for (std::size_t from = 0; from <= folders.size();) {
    const std::size_t to = std::min(folders.find(':', from), folders.size());
    if (fs::exists(fs::path(folders.substr(from, to - from)) / program)) return true;
    from = to + 1;
  }
  return false;
}

/// The message of OpenFOAM's last FATAL ERROR as one line, or what its end looks like without one.
std::string cause(const fs::path& log, int exit_code) {
  std::ifstream stream(log);
  std::string text;
  bool inside = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.find("FOAM FATAL") != std::string::npos) {
      inside = true;
      text.clear();
    } else if (inside && line.find("From ") != std::string::npos) {
      inside = false;
    } else if (inside && line.find_first_not_of(" \t\r") != std::string::npos) {
      text += (text.empty() ? "" : " ") + line.substr(line.find_first_not_of(" \t"));
    }
  }
  if (!text.empty()) return text;
  if (exit_code == 128 + 8 || exit_code == 128 + 6) {
    return "a floating point exception: the solution has diverged; smaller windows or a lower max_courant may help";
  }
  if (exit_code > 128) return fmt::format("ended by signal {}", exit_code - 128);
  return fmt::format("ended with status {}", exit_code);
}

/// What the program said on its last line.
std::string last_line(const fs::path& log) {
  std::ifstream stream(log);
  std::string last;
  for (std::string line; std::getline(stream, line);) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  }
  return last;
}

}  // namespace

void find_openfoam() {
  if (!on_path("interFoam")) {
    throw std::runtime_error(
        "OpenFOAM's interFoam is not on the PATH; install Debian's package openfoam or source the environment of "
        "another, or use [fluid] model = \"hydrostatic\"");
  }
  if (std::getenv("WM_PROJECT_DIR") != nullptr) return;
  ::setenv("WM_PROJECT_DIR", "/usr/share/openfoam", 0);
  ::setenv("WM_PROJECT", "OpenFOAM", 0);
  ::setenv("WM_PROJECT_VERSION", "v1912", 0);
}

std::string openfoam_version() {
  if (!on_path("interFoam")) return "none: interFoam is not on the PATH";
  find_openfoam();
  std::string number = "of an unknown version";
  std::FILE* help = ::popen("interFoam -help 2>/dev/null", "r");
  if (help == nullptr) return number;
  char line[256];
  while (std::fgets(line, sizeof line, help) !=
         nullptr) {  // Using: OpenFOAM- (1912) - visit ...; or OpenFOAM-8 (see ...
    const std::string words = line;
    const std::size_t from = words.find_first_of("0123456789");
    if (!words.starts_with("Using: ") || from == std::string::npos) continue;
    number = words.substr(from, words.find_first_not_of("0123456789.", from) - from);
  }
  ::pclose(help);
  return number;
}

fs::path find_plugin() {
  const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
  for (const fs::path& folder : {here, here.parent_path() / "lib"}) {
    if (fs::exists(folder / "libblockweirOpenFOAM.so")) return folder / "libblockweirOpenFOAM.so";
  }
  throw std::runtime_error(fmt::format(
      "OpenFOAM's plugin libblockweirOpenFOAM.so is neither in {} nor in ../lib beside it: this blockweir was built "
      "without OpenFOAM's headers; fluid/openfoam/README.md says how to get them",
      here.string()));
}

void run_program(const std::string& name, std::vector<std::string> words, const fs::path& folder) {
  process::Command command{name, std::move(words)};
  command.output = folder / ("log." + name);
  const process::Supervised end = process::supervise({command}, folder, grace_s, [] { return true; });
  if (end.interrupted) throw std::runtime_error("asked to stop");
  if (!end.all_fine()) {
    throw std::runtime_error(fmt::format("{}: {} (see {})", name, cause(command.output, end.ends.front().exit_code),
                                         command.output.string()));
  }
}

std::optional<std::string> entry(const fs::path& folder, const std::string& file, const std::string& name) {
  const std::string program = "foamDictionary";
  process::Command command{program, {program, folder / file, "-case", folder, "-entry", name, "-value"}};
  command.output = folder / ("log." + program);
  const process::Supervised end = process::supervise({command}, folder, grace_s, [] { return true; });
  if (end.interrupted) throw std::runtime_error("asked to stop");
  if (end.all_fine()) return last_line(command.output);
  const std::string trouble = cause(command.output, end.ends.front().exit_code);
  if (trouble.find("Cannot find entry") != std::string::npos) return std::nullopt;
  throw std::runtime_error(fmt::format("{}: {}", (folder / file).string(), trouble));
}

void set_entry(const fs::path& folder, const std::string& file, const std::string& name, const std::string& value) {
  // Unexpanded: a user's macros and includes stay what they are.
  run_program(
      "foamDictionary",
      {"foamDictionary", folder / file, "-case", folder, "-disableFunctionEntries", "-entry", name, "-set", value},
      folder);
}

}  // namespace blockweir::openfoam
