// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/plot.hpp"

#include <fmt/format.h>

#include <fstream>

#include "bridge/picture/gnuplot.hpp"
#include "bridge/picture/plot_flow.hpp"
#include "bridge/picture/plot_section.hpp"
#include "bridge/picture/plot_series.hpp"
#include "bridge/picture/plot_snapshots.hpp"
#include "bridge/picture/plot_spectrum.hpp"

namespace blockweir::picture {

void plot(const PlotOptions& options) {
  std::ifstream stream(options.run / "summary.json");
  auto summary = stream ? nlohmann::json::parse(stream, nullptr, /*allow_exceptions=*/false) : nlohmann::json::object();
  if (!summary.is_object()) summary = nlohmann::json::object();
  const std::string terminal = options.svg ? "svg background 'white' font 'sans,14'" : "pngcairo font 'sans,12'";
  const std::string ending = options.svg ? ".svg" : ".png";
  std::string script = series_script(options, summary, terminal, ending);
  script += snapshot_script(options.run, summary, terminal, ending, options.animated);
  if (options.section) script += section_script(options.run, summary, terminal, ending);
  script += spectrum_script(options.run, terminal, ending);
  script += flow_script(options.run, terminal, ending);
  gnuplot(script, options.animated);
  for (const char* name :
       {"displacements", "velocities", "rotations", "level", "snapshots", "picture", "section", "spectrum", "flow"}) {
    const auto file = options.run / (name + ending);
    if (std::filesystem::exists(file)) fmt::print("{}\n", file.string());
  }
  if (options.animated) fmt::print("{}\n", (options.run / "animation.gif").string());
}

}  // namespace blockweir::picture
