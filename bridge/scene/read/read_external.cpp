// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of [fluid] for a program that is not blockweir's.
#include <fmt/format.h>

#include "bridge/scene/fluid_models.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {

void read_external(TableReader& fluid, Reading& reading) {
  External& external = reading.scene.external;
  fluid.texts_if_any("command", external.command);
  fluid.flag("remembers", external.remembers);
  if (!external.command.empty() && external.command.front().empty()) {
    reading.problems.error(fluid.place("command"), "command begins with an empty word",
                           "a list of words, the first of which is a program",
                           "write command = [\"python3\", \"water.py\"]");
  }
  if (fluid_entry(reading.scene.fluid).yours) return;
  for (const char* key : {"command", "remembers"}) {
    if (!fluid.has(key)) continue;
    reading.problems.error(fluid.place(key), fmt::format("{} beside another model", key),
                           "model = \"external\" in [fluid]", fmt::format("leave {} out, or set the model", key));
  }
}

}  // namespace blockweir::scene
