// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/launch/completion.hpp"

namespace blockweir::launch {

Work completion_command(CLI::App& app) {
  const auto shell = std::make_shared<std::string>();
  app.add_option("shell", *shell, "bash or zsh: source <(blockweir completion bash)")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh"}));
  return [shell, &app] {
    fmt::print("{}", *shell == "bash" ? bash_completion(*app.get_parent()) : zsh_completion(*app.get_parent()));
    return 0;
  };
}

}  // namespace blockweir::launch
