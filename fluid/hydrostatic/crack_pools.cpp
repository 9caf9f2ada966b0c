// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/crack_pools.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/scene/at.hpp"

namespace blockweir::hydrostatic {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

bool same_level(double a_m, double b_m) {
  return std::abs(a_m - b_m) <= 1e-12 * std::max(std::abs(a_m), std::abs(b_m));
}

}  // namespace

CrackPools::CrackPools(const scene::Scene& scene, const std::vector<scene::Crack>& cracks) {
  constexpr double widths = 4;  // of a crack that carries open water: it ends so far from an acute corner
  near_m_ = widths * scene.water.open_crack_width_m;
  for (const scene::Crack& crack : cracks) {
    const auto beside = [&](const scene::CrackPart& part, const scene::TracePiece& piece, bool mouth) {
      const auto one = [&](int block, int edge, double s_from, double s_to) {
        return beyond(scene.blocks[at(block)], block, edge, mouth ? s_from : s_to, mouth ? s_to : s_from);
      };
      return Beside{one(part.block_a, piece.edge_a, piece.s_from_a, piece.s_to_a),
                    one(part.block_b, piece.edge_b, piece.s_from_b, piece.s_to_b)};
    };
    const scene::CrackPart& first = crack.parts.front();
    const scene::CrackPart& last = crack.parts.back();
    ends_.push_back({beside(first, first.trace.pieces.front(), true), beside(last, last.trace.pieces.back(), false)});
  }
}

CrackPools::Beyond CrackPools::beyond(const scene::Block& block, int number, int edge, double s, double s_inside) {
  const int edges = static_cast<int>(block.vertices.size());
  const bool forwards = s > s_inside;
  if (forwards && s == 1) return {number, (edge + 1) % edges, 0, true};
  if (!forwards && s == 0) return {number, (edge + edges - 1) % edges, 1, false};
  return {number, edge, s, forwards};
}

std::optional<double> CrackPools::level(std::size_t k, bool mouth, const Point& place, double expected_m,
                                        const std::vector<WaterBody>& bodies,
                                        const std::vector<std::vector<Point>>& outlines) const {
  const auto gap_m = [&](const Beyond& b, const std::vector<WetInterval>& wet) {
    const auto& outline = outlines[at(b.block)];
    const double length_m = (outline[(at(b.edge) + 1) % outline.size()] - outline[at(b.edge)]).norm();
    const std::pair face(b.block, b.edge);
    const auto before = [](const WetInterval& w, const std::pair<int, int>& f) {
      return std::pair(w.block, w.edge) < f;
    };
    double least = nowhere;
    for (auto w = std::lower_bound(wet.begin(), wet.end(), face, before);
         w != wet.end() && std::pair(w->block, w->edge) == face; ++w) {
      if (b.forwards ? w->s_to <= b.s : w->s_from >= b.s) continue;
      least = std::min(least, length_m * std::max(0.0, b.forwards ? w->s_from - b.s : b.s - w->s_to));
    }
    return least;
  };
  std::optional<double> found;
  double nearest_m = near_m_;
  for (const WaterBody& body : bodies) {
    double least = nowhere;
    for (const Beyond& b : ends_[k][mouth ? 0 : 1]) least = std::min(least, gap_m(b, body.wet->intervals));
    if (least > near_m_) continue;
    const double level_m = body.surface.at(place.x());
    if (same_level(level_m, expected_m)) return expected_m;
    if (found && least >= nearest_m) continue;
    nearest_m = least;
    found = level_m;
  }
  return found;
}

}  // namespace blockweir::hydrostatic
