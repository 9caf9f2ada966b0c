// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of every program but blockweir. Only program.cpp includes CLI11, which takes seconds to compile.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bridge/channel/channel.hpp"
#include "bridge/process/sides.hpp"

namespace blockweir::process {

/// An option "--name", or one identified by its position: "name".
struct ProgramOption {
  /// Where its value is stored; a bool is a flag; a function returns a text, which is printed in place of all work.
  using Target = std::variant<std::string*, std::filesystem::path*, std::vector<std::string>*, int*, std::uint64_t*,
                              std::optional<double>*, bool*, std::function<std::string()>>;
  enum class Use { optional, required };

  const char* name;
  Target target;
  std::string help;
  Use use = Use::optional;
  std::vector<std::string> allowed{};  ///< values; empty: any
};

/// --keys, --insecure and --endpoint, which is required where `use` says so.
std::vector<ProgramOption> connection_options(channel::Options& connection,
                                              ProgramOption::Use use = ProgramOption::Use::optional);

/// Of each program that contains the solid.
std::vector<ProgramOption> solid_options(SolidProcess& solid);

struct Program {
  std::string name;
  std::string about;
  std::vector<std::vector<ProgramOption>> options;  ///< in groups, in the order of --help
};

/// main() of a program: reads the options, then works. Returns the exit status: 2 if the command line is wrong,
/// otherwise that of exit_status().
int run_program(int argc, char** argv, const Program& program, const std::function<int()>& work);

}  // namespace blockweir::process
