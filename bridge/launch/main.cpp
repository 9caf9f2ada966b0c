// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir: the command line.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "bridge/launch/commands.hpp"
#include "bridge/launch/version.hpp"
#include "bridge/process/exit_status.hpp"
#include "bridge/results/wrapped.hpp"
#include "bridge/scene/read/nearest.hpp"

namespace {

using namespace blockweir;

/// CLI11 would call an unknown command an extra argument; people want the word that they meant.
void refuse_unknown_command(int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const launch::Command& command : launch::commands) names.emplace_back(command.name);
  if (std::find(names.begin(), names.end(), argv[1]) != names.end()) return;
  const std::string near = scene::nearest(argv[1], names);
  throw std::invalid_argument(fmt::format("there is no command \"{}\"{}; blockweir --help lists them", argv[1],
                                          near.empty() ? "" : fmt::format(", did you mean \"{}\"?", near)));
}

int run_command(int argc, char** argv) {
  CLI::App app{"blockweir: at which water level a structure of blocks fails, and how"};
  app.set_version_flag("--version", launch::version, "version, commit, compiler and the OpenFOAM that is found");
  app.require_subcommand(1);
  const auto works = launch::add_commands(app);
  refuse_unknown_command(argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream help;
    std::ostringstream wrong;
    const int status = app.exit(error, help, wrong);
    fmt::print("{}", results::for_stdout(help.str()));
    fmt::print(stderr, "{}", results::for_stderr(wrong.str()));
    return status == 0 ? 0 : 2;
  }
  const auto asked = std::find_if(works.begin(), works.end(), [](const auto& work) { return work.first->parsed(); });
  return asked->second();
}

}  // namespace

int main(int argc, char** argv) {
  return process::exit_status("blockweir", [&] { return run_command(argc, argv); });
}
