// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/validate/compare.hpp"

namespace blockweir::launch {

Work compare_command(CLI::App& app) {
  const auto options = std::make_shared<study::CompareOptions>();
  app.add_option("cases", options->cases, "case folders or scene files (default: five cases)");
  app.add_option("--json", options->json, "also write the table to this file, as JSON");
  app.add_option("--out", options->out, "keep each run in this folder, as CASE-FORMULATION or CASE-FLUID");
  app.add_option("--fluids", options->fluids,
                 "compare these models of [fluid], as reservoir,openfoam, in place of contacts")
      ->delimiter(',');
  app.add_option("--set", options->overrides,
                 "set a key in each scene, as key=value; with --fluids a key of [fluid] acts on the model that has it");
  return [options] { return study::compare(*options); };
}

}  // namespace blockweir::launch
