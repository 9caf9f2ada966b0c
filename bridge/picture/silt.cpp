// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/silt.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

#include "bridge/picture/still_pools.hpp"
#include "bridge/scene/read/stated_loads.hpp"

namespace blockweir::picture {

using nlohmann::json;

std::optional<double> silt_level_m(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return scene::silt_level_m(text.str());
}

/// It lies as a pool would whose level is the silt's.
std::vector<std::vector<Eigen::Vector2d>> silt_bodies(const json& frame, double level_m, const View& view) {
  double crest_x = 0;
  double crest_y = -std::numeric_limits<double>::infinity();
  for (const json& block : frame["blocks"]) {
    for (const json& p : block["outline"]) {
      if (block["fixed"].get<bool>() || p[1].get<double>() <= crest_y) continue;
      crest_x = p[0];
      crest_y = p[1];
    }
  }
  json silted = {{"blocks", frame["blocks"]},
                 {"upstream_level_m", level_m},
                 {"downstream_level_m", nullptr},
                 {"panels", json::array()}};
  for (const json& panel : frame["panels"]) {
    const double right = std::max(panel[0].get<double>(), panel[2].get<double>());
    if (right <= crest_x) silted["panels"].push_back(panel);
  }
  return still_pools(silted, view);
}

}  // namespace blockweir::picture
