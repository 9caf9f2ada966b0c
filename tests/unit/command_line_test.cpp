// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_launch
// The manual page, the completions and --version say what the commands are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "bridge/launch/commands.hpp"
#include "bridge/launch/completion.hpp"
#include "bridge/launch/manual.hpp"
#include "bridge/launch/version.hpp"
#include "tests/own_folder.hpp"

namespace blockweir::launch::command_line_test {
namespace {

using testing::HasSubstr;

class CommandLine : public test::OwnFolder {
 protected:
  CommandLine() { add_commands(app_); }
  void write(const std::string& file, const std::string& text) const { std::ofstream(folder / file) << text; }
  /// What a shell command writes, errors too.
  [[nodiscard]] std::string said(const std::string& command) const {
    EXPECT_EQ(std::system(("cd " + folder.string() + " && { " + command + "; } >said 2>&1").c_str()), 0) << command;
    std::ostringstream all;
    all << std::ifstream(folder / "said").rdbuf();
    return all.str();
  }
  static bool installed(const std::string& program) {
    return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
  }
  CLI::App app_{"blockweir: blocks in water"};
};

TEST_F(CommandLine, EachCommandAndOptionIsInTheManual) {
  write("blockweir.1", manual(app_));
  if (!installed("groff")) GTEST_SKIP() << "groff is not installed";
  const std::string page = said("groff -man -Tascii -P-c -P-b -P-u -rLL=500n blockweir.1");
  for (const CLI::App* command : commands_of(app_)) {
    EXPECT_THAT(page, HasSubstr(command->get_description()));
    for (const CLI::Option* option : command->get_options()) {
      if (!option->get_positional() && option->get_lnames().front() == "help") continue;
      EXPECT_THAT(page, HasSubstr(option->get_positional() ? option->get_name(true) : option->get_name()));
      EXPECT_THAT(page, HasSubstr(option->get_description()));
    }
  }
}

TEST_F(CommandLine, TheManualIsSoundRoff) {
  if (!installed("groff")) GTEST_SKIP() << "groff is not installed";
  write("blockweir.1", manual(app_));
  EXPECT_EQ(said("groff -man -Tutf8 -ww -z blockweir.1"), "");
}

TEST_F(CommandLine, BashCompletesCommandsAndTheirOptions) {
  write("script", bash_completion(app_));
  const auto completed = [&](const std::string& words, int at) {
    return said("bash -c 'source ./script; COMP_WORDS=(" + words + "); COMP_CWORD=" + std::to_string(at) +
                "; _blockweir; echo \"${COMPREPLY[*]}\"'");
  };
  for (const CLI::App* command : commands_of(app_)) {
    const std::string name = command->get_name();
    EXPECT_THAT(completed("blockweir " + name, 1), HasSubstr(name));
    const std::string options = completed("blockweir " + name + " --", 2);
    for (const CLI::Option* option : named_options(*command)) EXPECT_THAT(options, HasSubstr(option->get_name()));
  }
  EXPECT_EQ(completed("blockweir study s.toml --engine", 4), "local slurm\n");
  EXPECT_EQ(completed("blockweir study s.toml --engine sl", 4), "slurm\n");
  EXPECT_EQ(completed("blockweir run s.toml --out", 4), "\n");
  EXPECT_EQ(completed("blockweir va", 1), "validate\n");
  EXPECT_EQ(completed("blockweir run --in", 2), "--inproc\n");
  EXPECT_EQ(completed("blockweir run cases/in", 2), "\n");  // left to the names of files
}

TEST_F(CommandLine, ZshTakesItsCompletion) {
  const std::string script = zsh_completion(app_);
  for (const CLI::App* command : commands_of(app_)) {
    EXPECT_THAT(script, HasSubstr("\n    '" + command->get_name() + ":"));
    for (const CLI::Option* option : named_options(*command)) EXPECT_THAT(script, HasSubstr(option->get_name() + "["));
  }
  EXPECT_THAT(script, HasSubstr(":value:(local slurm)'"));
  if (!installed("zsh")) GTEST_SKIP() << "zsh is not installed";
  write("_blockweir", script);
  EXPECT_EQ(said("zsh -f -c 'autoload -U compinit; compinit -D -u; source ./_blockweir; echo $_comps[blockweir]'"),
            "_blockweir\n");
}

TEST_F(CommandLine, TheVersionNamesCommitCompilerAndOpenFoam) {
  EXPECT_THAT(version(), testing::MatchesRegex("blockweir [0-9.]+\ncommit    ([0-9a-f]+(-changed)?|unknown)\n"
                                               "compiler  (GCC|clang) [0-9].*\nOpenFOAM  .+"));
}

}  // namespace
}  // namespace blockweir::launch::command_line_test
