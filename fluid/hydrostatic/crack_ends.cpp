// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/crack_ends.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/geometry/place_text.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/hydrostatics.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::hydrostatic {
namespace {

double distance(const Point& p, const Point& from, const Point& to) {
  const Point along = to - from;
  const double share = along.isZero(0) ? 0 : std::clamp(along.dot(p - from) / along.squaredNorm(), 0.0, 1.0);
  return (from + share * along - p).norm();
}

bool lies_on(const scene::Crack& crack, const Point& p, double near_m) {
  return std::any_of(crack.parts.begin(), crack.parts.end(), [&](const scene::CrackPart& part) {
    return std::any_of(part.trace.pieces.begin(), part.trace.pieces.end(),
                       [&](const scene::TracePiece& piece) { return distance(p, piece.from_m, piece.to_m) <= near_m; });
  });
}

}  // namespace

CrackEnds::CrackEnds(const scene::Scene& scene, const std::vector<scene::Crack>& cracks)
    : scene_(scene), on_another_(cracks.size()) {
  constexpr std::size_t most = 1'000;  // more are a network, and take long to look at
  if (cracks.size() > most) {
    on_another_.assign(cracks.size(), {true, true});
    return;
  }
  const double near_m = scene.water.open_crack_width_m;
  for (std::size_t k = 0; k < cracks.size(); ++k) {
    names_.push_back(scene::name_of(scene, cracks[k]));
    const Point mouth = cracks[k].mouth();
    const Point end = cracks[k].end();
    const auto is_of_ground = [&](const scene::CrackPart& part) {
      return scene.blocks[at(part.block_a)].fixed && scene.blocks[at(part.block_b)].fixed;
    };
    of_ground_.push_back({is_of_ground(cracks[k].parts.front()), is_of_ground(cracks[k].parts.back())});
    for (std::size_t other = 0; other < cracks.size(); ++other) {
      if (other == k) continue;
      on_another_[k].mouth = on_another_[k].mouth || lies_on(cracks[other], mouth, near_m);
      on_another_[k].end = on_another_[k].end || lies_on(cracks[other], end, near_m);
    }
  }
}

void CrackEnds::look(std::size_t k, const End& end, const std::vector<std::vector<Point>>& outlines,
                     const std::vector<WetInterval>& open_water) {
  constexpr double widths = 4;  // of a crack that carries open water: it ends so far from an acute corner
  if (end.pressure_pa <= driest_.pressure_pa || (end.upstream ? on_another_[k].mouth : on_another_[k].end)) return;
  const double near_m = widths * scene_.water.open_crack_width_m;
  // A toe at the tailwater's level settles by less.
  if (end.pressure_pa <= scene::unit_weight_of_water(scene_) * near_m) return;
  const bool reached = std::any_of(open_water.begin(), open_water.end(), [&](const WetInterval& wet) {
    const auto& outline = outlines[at(wet.block)];
    const Point& from = outline[at(wet.edge)];
    const Point along = outline[(at(wet.edge) + 1) % outline.size()] - from;
    return distance(end.place, from + wet.s_from * along, from + wet.s_to * along) <= near_m;
  });
  if (reached) return;
  driest_ = end;
  crack_ = k;
}

std::string CrackEnds::warning() const {
  if (driest_.pressure_pa <= 0) return {};
  const char* pool = driest_.upstream ? "upstream" : "downstream";
  return fmt::format(
      "no open water reaches the {0} end of joint \"{1}\" at {2} m, which has the pressure of the {0} "
      "pool there, {3:.4g} Pa, all the same; expected a joint that ends in that pool; {4}",
      pool, names_[crack_], geometry::place_text(driest_.place, scene::structure_size_m(scene_.blocks)),
      driest_.pressure_pa,
      of_ground_[crack_][driest_.upstream ? 0 : 1]
          ? "fixed blocks that are drawn as one have no joint between them, along which its pressure falls"
          : "where its ground is dry state uplift = \"none\" for it in [[joints]]");
}

}  // namespace blockweir::hydrostatic
