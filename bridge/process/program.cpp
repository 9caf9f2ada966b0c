// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/program.hpp"

#include <CLI/CLI.hpp>

#include "bridge/process/exit_status.hpp"

namespace blockweir::process {
namespace {

/// Adds an option to `app` by the type of its target.
struct AddOption {
  CLI::App& app;
  const ProgramOption& option;

  CLI::Option* operator()(bool* flag) const { return app.add_flag(option.name, *flag, option.help); }
  CLI::Option* operator()(const std::function<std::string()>& text) const {
    return app.set_version_flag(option.name, text, option.help);
  }
  template <class Value>
  CLI::Option* operator()(Value* value) const {
    return app.add_option(option.name, *value, option.help);
  }
};

}  // namespace

std::vector<ProgramOption> connection_options(channel::Options& connection, ProgramOption::Use use) {
  return {{"--keys", &connection.keys, "folder of this side's keys, as \"blockweir keys\" makes it; for tcp"},
          {"--insecure", &connection.insecure, "allow other machines to connect over tcp without keys"},
          {"--endpoint", &connection.endpoint,
           connection.side == channel::Side::listens
               ? "where to listen for the fluid process: ipc://PATH or tcp://HOST:PORT"
               : "where the solid process listens: ipc://PATH or tcp://HOST:PORT",
           use}};
}

std::vector<ProgramOption> solid_options(SolidProcess& solid) {
  constexpr auto required = ProgramOption::Use::required;
  return {
      {"scene", &solid.scene, "scene file or case folder", required},
      {"--out", &solid.folder, "folder for the results", required},
      {"--set", &solid.overrides, "set a key of the scene, as key=value; the same for both processes"},
      {"--resume", &solid.resume, "continue from the checkpoint of this number in --out; the same for both processes"},
      {"--progress-fd", &solid.progress_fd, "file descriptor for progress lines"}};
}

int run_program(int argc, char** argv, const Program& program, const std::function<int()>& work) {
  CLI::App app{program.name + ": " + program.about};
  for (const std::vector<ProgramOption>& group : program.options) {
    for (const ProgramOption& option : group) {
      CLI::Option* const added = std::visit(AddOption{app, option}, option.target);
      if (option.use == ProgramOption::Use::required) added->required();
      if (!option.allowed.empty()) added->check(CLI::IsMember(option.allowed));
    }
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return exit_status(program.name.c_str(), work);
}

}  // namespace blockweir::process
