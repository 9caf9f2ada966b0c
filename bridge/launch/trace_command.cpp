// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/picture/trace.hpp"

namespace blockweir::launch {

Work trace_command(CLI::App& app) {
  const auto run = std::make_shared<std::filesystem::path>();
  app.add_option("run", *run, "folder of a run that was made with --trace")->required();
  return [run] { return fmt::print("{}\n", picture::trace(*run).string()), 0; };
}

}  // namespace blockweir::launch
