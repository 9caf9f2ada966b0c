// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/plot.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "bridge/picture/draw.hpp"
#include "bridge/picture/plot_flow.hpp"
#include "bridge/picture/plot_section.hpp"
#include "bridge/picture/plot_series.hpp"
#include "bridge/picture/plot_snapshots.hpp"
#include "bridge/picture/plot_spectrum.hpp"
#include "bridge/picture/stop_message.hpp"

namespace blockweir::picture {

void plot(const PlotOptions& options) {
  if (std::filesystem::is_regular_file(options.run)) {
    throw std::invalid_argument(
        fmt::format("{0}: found a file; expected the folder of a run; name the one that the "
                    "last line of \"blockweir run\" says",
                    options.run.string()));
  }
  const StopMessage stopped("blockweir: stopped on request while it drew " + options.run.string() +
                            "; no picture was changed; the same command draws them anew");
  std::ifstream stream(options.run / "summary.json");
  auto summary = stream ? nlohmann::json::parse(stream, nullptr, /*allow_exceptions=*/false) : nlohmann::json::object();
  if (!summary.is_object()) summary = nlohmann::json::object();
  const std::string ending = options.svg ? ".svg" : ".png";
  std::vector<Picture> pictures = series_pictures(options, summary, ending);
  const auto add = [&](const std::vector<Picture>& more) { pictures.insert(pictures.end(), more.begin(), more.end()); };
  add(snapshot_pictures(options.run, summary, ending, options.animated));
  if (options.section) add({section_picture(options.run, summary, ending)});
  add(spectrum_picture(options.run, ending));
  add(flow_picture(options.run, summary, ending));
  draw(pictures, options.animated);
  for (const Picture& picture : pictures) fmt::print("{}\n", picture.file.string());
}

}  // namespace blockweir::picture
