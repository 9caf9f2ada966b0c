// SPDX-License-Identifier: GPL-3.0-or-later
// [fluid.external]: a program of the user's that computes the water.
#include <toml++/toml.h>

#include "bridge/scene/fluid_models.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {

void read_external(TableReader& fluid, Reading& reading) {
  const toml::table* section = fluid.table("external");
  if (section == nullptr) return;
  TableReader table(reading.problems, section, "[fluid.external]");
  External& external = reading.scene.external;
  table.texts_if_any("command", external.command);
  table.flag("remembers", external.remembers);
  if (!external.command.empty() && external.command.front().empty()) {
    reading.problems.error(table.place("command"), "command begins with an empty word",
                           "a list of words, the first of which is a program",
                           "write command = [\"python3\", \"water.py\"]");
  }
  if (fluid_entry(reading.scene.fluid).yours) return;
  reading.problems.error(table.place(), "[fluid.external] beside another model", "model = \"external\" in [fluid]",
                         "leave [fluid.external] out, or set the model");
}

}  // namespace blockweir::scene
