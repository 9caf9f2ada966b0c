// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/silt.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>
#include <utility>

#include "bridge/picture/still_pools.hpp"
#include "bridge/scene/read/stated_loads.hpp"

namespace blockweir::picture {

using nlohmann::json;

std::optional<double> silt_level_m(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return scene::silt_level_m(text.str());
}

/// What of a panel that begins below a level lies there.
static json below(json panel, double level_m) {
  const std::size_t high = panel[1] > panel[3] ? 0 : 2;
  const std::size_t low = 2 - high;
  const double rise = panel[high + 1].get<double>() - panel[low + 1].get<double>();
  const double left_out = panel[high + 1].get<double>() - level_m;
  if (left_out <= 0) return panel;
  panel[high] = panel[high].get<double>() + left_out / rise * (panel[low].get<double>() - panel[high].get<double>());
  panel[high + 1] = level_m;
  return panel;
}

/// It lies as a pool would whose level is the silt's.
std::vector<std::vector<Eigen::Vector2d>> silt_bodies(const json& frame, double level_m, const View& view) {
  // The highest point of what can move, of several the one upstream.
  std::pair crest(-std::numeric_limits<double>::infinity(), 0.0);
  for (const json& block : frame["blocks"]) {
    for (const json& p : block["outline"]) {
      if (!block["fixed"].get<bool>()) crest = std::max(crest, std::pair(p[1].get<double>(), -p[0].get<double>()));
    }
  }
  const double crest_x = -crest.second;
  json silted = {{"blocks", frame["blocks"]},
                 {"upstream_level_m", level_m},
                 {"downstream_level_m", nullptr},
                 {"panels", json::array()}};
  for (const json& panel : frame["panels"]) {
    if (std::max(panel[0].get<double>(), panel[2].get<double>()) > crest_x) continue;
    if (std::min(panel[1].get<double>(), panel[3].get<double>()) < level_m) {
      silted["panels"].push_back(below(panel, level_m));
    }
  }
  return still_pools(silted, view);
}

}  // namespace blockweir::picture
