// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/open_water.hpp"

#include <algorithm>

#include "bridge/scene/at.hpp"

namespace blockweir::joints {

OpenWater::OpenWater(const std::vector<std::vector<Point>>& outlines, const wire::Load& load, std::size_t panels,
                     double water_n_per_m3, double atmosphere_pa)
    : outlines_(outlines), water_n_per_m3_(water_n_per_m3) {
  for (std::size_t i = 0; i < panels; ++i) {
    faces_[{static_cast<int>(load.block[i]), static_cast<int>(load.edge[i])}].push_back(
        {load.s_from[i], load.s_to[i], load.pressure_from_pa[i] - atmosphere_pa,
         load.pressure_to_pa[i] - atmosphere_pa});
  }
}

std::optional<double> OpenWater::pressure(const Point& p, const std::vector<int>& blocks, double near_m) const {
  std::optional<double> found;
  double nearest_m = near_m;
  for (const int block : blocks) {
    const auto& outline = outlines_[at(block)];
    for (auto face = faces_.lower_bound({block, 0}); face != faces_.end() && face->first.first == block; ++face) {
      const Point& from = outline[at(face->first.second)];
      const Point along = outline[(at(face->first.second) + 1) % outline.size()] - from;
      for (const Face& f : face->second) {
        const double s = std::clamp(along.dot(p - from) / along.squaredNorm(), f.s_from, f.s_to);
        const Point on = from + s * along;
        const double away_m = (on - p).norm();
        if (away_m > nearest_m) continue;
        const double share = f.s_to > f.s_from ? (s - f.s_from) / (f.s_to - f.s_from) : 0;
        const double there = f.pressure_from_pa + share * (f.pressure_to_pa - f.pressure_from_pa);
        const double here = there + water_n_per_m3_ * (on.y() - p.y());
        nearest_m = away_m;
        found = here > 0 ? std::optional(here) : std::nullopt;
      }
    }
  }
  return found;
}

const std::vector<OpenWater::Face>& OpenWater::on(int block, int edge) const {
  static const std::vector<Face> none;
  const auto found = faces_.find({block, edge});
  return found == faces_.end() ? none : found->second;
}

bool OpenWater::covers(int block, int edge, double s) const {
  const std::vector<Face>& faces = on(block, edge);
  return std::any_of(faces.begin(), faces.end(), [s](const Face& f) { return f.s_from <= s && s <= f.s_to; });
}

}  // namespace blockweir::joints
