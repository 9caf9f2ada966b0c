// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
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
    throw std::invalid_argument(
        fmt::format("{}: found no such file, an empty one, or one that you may not read; expected the folder of a run "
                    "that has begun; name that folder",
                    file.string()));
  return frames;
}

namespace {

/// What falls deep or is thrown far would leave the structure a dot: it is shown as far as that.
View near_the_model(const View& view, const View& model) {
  const double size = std::max(model.right - model.left, model.top - model.bottom);
  const double aside = 2 * size;
  return {std::max(view.left, model.left - aside), std::min(view.right, model.right + aside),
          std::max(view.bottom, model.bottom - size), std::min(view.top, model.top + size)};
}

void include_outline(View& view, const json& block) {
  for (const json& p : block["outline"]) view.include(p[0], p[1]);
}

/// What all but a twentieth of the blocks that move reach on each side, over all frames.
View reach_of_most(const std::vector<json>& frames) {
  std::vector<View> ways(frames.front()["blocks"].size());
  for (const json& frame : frames) {
    const json& blocks = frame["blocks"];
    for (std::size_t b = 0; b < std::min(ways.size(), blocks.size()); ++b) {
      if (!blocks[b]["fixed"].get<bool>()) include_outline(ways[b], blocks[b]);
    }
  }
  std::erase_if(ways, [](const View& way) { return way.left > way.right; });  // fixed blocks
  if (ways.empty()) return {};
  const std::size_t left_out = ways.size() / 20;
  const auto reach = [&](double View::*side, double sign) {
    std::nth_element(ways.begin(), ways.begin() + static_cast<std::ptrdiff_t>(left_out), ways.end(),
                     [&](const View& a, const View& b) { return sign * a.*side > sign * b.*side; });
    return ways[left_out].*side;
  };
  return {reach(&View::left, -1), reach(&View::right, 1), reach(&View::bottom, -1), reach(&View::top, 1)};
}

/// Whether the water presses on fixed blocks only; then they are the subject of the picture.
bool stands_above_water(const json& frame) {
  double lowest = 1e300;
  for (const json& block : frame["blocks"]) {
    if (block["fixed"].get<bool>()) continue;
    for (const json& p : block["outline"]) lowest = std::min(lowest, p[1].get<double>());
  }
  const json& level = frame["upstream_level_m"];
  return level.is_number() && level.get<double>() <= lowest;
}

}  // namespace

View view_of(const std::vector<json>& frames, double water_m) {
  View model;  // as it begins
  const bool with_ground = stands_above_water(frames.front());
  for (const json& block : frames.front()["blocks"]) {
    double top = -1e300;
    for (const json& p : block["outline"]) top = std::max(top, p[1].get<double>());
    if (with_ground || top > water_m || !block["fixed"].get<bool>()) include_outline(model, block);
  }
  const auto include_fittings = [](View& view, const json& frame) {
    for (const json& b : frame.value("bolts", json::array())) {  // their ends may lie in the ground
      view.include(b[0], b[1]);
      view.include(b[2], b[3]);
    }
    for (const char* pool : {"upstream_level_m", "downstream_level_m"}) {
      if (frame[pool].is_number()) view.include(view.left, frame[pool]);
    }
  };
  include_fittings(model, frames.front());
  View view = model;
  const View most = reach_of_most(frames);
  view.include(most.left, most.bottom);
  view.include(most.right, most.top);
  for (const json& frame : frames) include_fittings(view, frame);
  view = near_the_model(view, model);
  const double size = std::max(view.right - view.left, view.top - view.bottom);
  return {view.left - 0.35 * size, view.right + 0.2 * size, view.bottom - 0.12 * size, view.top + 0.08 * size};
}

std::size_t blocks_beyond(const json& frame, const View& view) {
  const json& blocks = frame["blocks"];
  return static_cast<std::size_t>(std::count_if(blocks.begin(), blocks.end(), [&view](const json& block) {
    if (block["fixed"].get<bool>()) return false;
    View box;
    include_outline(box, block);
    return box.left < view.left || box.right > view.right || box.bottom < view.bottom || box.top > view.top;
  }));
}

}  // namespace blockweir::picture
