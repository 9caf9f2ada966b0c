// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/launch/commands.hpp"

namespace blockweir::launch {

std::vector<std::pair<const CLI::App*, Work>> add_commands(CLI::App& app) {
  std::vector<std::pair<const CLI::App*, Work>> works;
  for (const Command& command : commands) {
    CLI::App* own = app.add_subcommand(command.name, command.about);
    works.emplace_back(own, command.make(*own));
  }
  return works;
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<const CLI::Option*> named_options(const CLI::App& app) {
  return app.get_options([](const CLI::Option* option) { return !option->get_positional(); });
}

std::vector<const CLI::Option*> positional_options(const CLI::App& app) {
  return app.get_options([](const CLI::Option* option) { return option->get_positional(); });
}

bool takes_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

}  // namespace blockweir::launch
