// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "bridge/launch/commands.hpp"
#include "bridge/launch/manual.hpp"

namespace blockweir::launch {

Work man_command(CLI::App& app) {
  return [&app] { return fmt::print("{}", manual(*app.get_parent())), 0; };
}

}  // namespace blockweir::launch
