// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/frames.hpp"

#include <fmt/format.h>

#include <fstream>
#include <optional>
#include <stdexcept>

namespace blockweir::picture {

using nlohmann::json;

std::vector<json> read_frames(const std::filesystem::path& run) {
  const std::filesystem::path file = run / "frames.jsonl";
  std::ifstream stream(file);
  std::vector<json> frames;
  for (std::string line; std::getline(stream, line);) {
    json frame = json::parse(line, nullptr, /*allow_exceptions=*/false);
    if (frame.is_object()) frames.push_back(std::move(frame));  // a killed run may leave half a line
  }
  if (frames.empty())
    throw std::invalid_argument(fmt::format(
        "{}: found no such file, or an empty one; expected the folder of a run that has begun; name that folder",
        file.string()));
  return frames;
}

namespace {

/// What falls deep or is thrown far would leave the structure a dot: it is shown as far as that.
View near_the_model(const View& view, const View& model) {
  const double way = std::max(model.right - model.left, model.top - model.bottom) / 2;
  return {std::max(view.left, model.left - way), std::min(view.right, model.right + way),
          std::max(view.bottom, model.bottom - way), std::min(view.top, model.top + way)};
}

}  // namespace

View view_of(const std::vector<json>& frames, double water_m) {
  View view;
  for (const json& block : frames.front()["blocks"]) {
    double top = -1e300;
    for (const json& p : block["outline"]) top = std::max(top, p[1].get<double>());
    if (top <= water_m) continue;
    for (const json& p : block["outline"]) view.include(p[0], p[1]);
  }
  std::optional<View> model;  // as it begins
  for (const json& frame : frames) {
    for (const json& block : frame["blocks"]) {
      if (block["fixed"].get<bool>()) continue;
      for (const json& p : block["outline"]) view.include(p[0], p[1]);
    }
    for (const json& b : frame.value("bolts", json::array())) {  // their ends may lie in the ground
      view.include(b[0], b[1]);
      view.include(b[2], b[3]);
    }
    for (const char* pool : {"upstream_level_m", "downstream_level_m"}) {
      if (frame[pool].is_number()) view.include(view.left, frame[pool]);
    }
    if (!model) model = view;
  }
  view = near_the_model(view, *model);
  const double size = std::max(view.right - view.left, view.top - view.bottom);
  return {view.left - 0.35 * size, view.right + 0.2 * size, view.bottom - 0.12 * size, view.top + 0.08 * size};
}

}  // namespace blockweir::picture
