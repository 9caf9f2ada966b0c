// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/launch/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "bridge/launch/commands.hpp"
#include "bridge/launch/version.hpp"
#include "bridge/results/wrapped.hpp"
#include "bridge/scene/read/nearest.hpp"

namespace blockweir::launch {
namespace {

/// CLI11 would call an unknown command an extra argument; people want the word that they meant.
void refuse_unknown_command(int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const Command& command : commands) names.emplace_back(command.name);
  if (std::find(names.begin(), names.end(), argv[1]) != names.end()) return;
  const std::string near = scene::nearest(argv[1], names);
  throw std::invalid_argument(fmt::format("there is no command \"{}\"{}; blockweir --help lists them", argv[1],
                                          near.empty() ? "" : fmt::format(", did you mean \"{}\"?", near)));
}

/// --out that names no folder or file which could be made: CLI11 hands on an empty text as if nothing had been given.
void refuse_impossible_out(const CLI::App& command) {
  constexpr std::size_t longest = 255;  // of a name, on any file system
  const CLI::Option* option = command.get_option_no_throw("--out");
  if (option == nullptr || option->count() == 0) return;
  const auto refuse = [](const std::string& found, const char* expected) {
    throw std::invalid_argument(fmt::format("--out: found {}; expected {}; choose another", found, expected));
  };
  const std::filesystem::path out = option->results().back();
  if (out.empty()) refuse("an empty text", "the path of a folder or file");
  for (const std::filesystem::path& name : out) {
    if (name.string().size() <= longest) continue;
    refuse(fmt::format("a name of {} bytes, \"{}...\"", name.string().size(), name.string().substr(0, 20)),
           "names of at most 255 bytes");
  }
}

/// Of words that a command does not take: the option that was meant, or what is too much.
[[noreturn]] void refuse_extras(const CLI::App& app) {
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  const CLI::App& command = parsed.empty() ? app : *parsed.front();
  const std::vector<std::string> extras = app.remaining(/*recurse=*/true);
  const auto is_option = [](const std::string& word) { return word.size() > 1 && word.front() == '-'; };
  const auto unknown = std::find_if(extras.begin(), extras.end(), is_option);
  if (unknown == extras.end()) {
    throw std::invalid_argument(fmt::format("{0} does not take \"{1}\"; expected what blockweir {0} --help lists",
                                            command.get_name(), extras.empty() ? "" : extras.front()));
  }
  std::vector<std::string> known;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  }
  const std::string word = unknown->substr(0, unknown->find('='));
  std::string near = scene::nearest(word, known);
  if (near.size() < 3 || word.size() < 3 || near[2] != word[2]) near.clear();  // --variant is no slip of --strict
  const bool sets = std::find(known.begin(), known.end(), "--set") != known.end();
  throw std::invalid_argument(fmt::format("{0} has no option \"{1}\"{2}; blockweir {0} --help lists them{3}",
                                          command.get_name(), word,
                                          near.empty() ? "" : fmt::format(", did you mean \"{}\"?", near),
                                          sets ? ", and --set SECTION.KEY=VALUE sets a key of the scene" : ""));
}

}  // namespace

int run_command_line(int argc, char** argv) {
  CLI::App app{"blockweir: at which water level a structure of blocks fails, and how"};
  app.set_version_flag("--version", version, "version, commit, compiler and the OpenFOAM that is found");
  app.require_subcommand(1);
  const auto works = add_commands(app);
  refuse_unknown_command(argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError&) {
    refuse_extras(app);
  } catch (const CLI::ParseError& error) {
    std::ostringstream help;
    std::ostringstream wrong;
    const int status = app.exit(error, help, wrong);
    fmt::print("{}", results::for_stdout(help.str()));
    fmt::print(stderr, "{}", results::for_stderr(wrong.str()));
    return status == 0 ? 0 : 2;
  }
  const auto asked = std::find_if(works.begin(), works.end(), [](const auto& work) { return work.first->parsed(); });
  refuse_impossible_out(*asked->first);
  return asked->second();
}

}  // namespace blockweir::launch
