// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/crack_elements.hpp"

#include <algorithm>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/wire/panels.hpp"

namespace blockweir::hydrostatic {
namespace {

/// Of an element: place along the edge, and pressure.
struct Node {
  double s;
  double pressure_pa;
};

/// The element from a to b, a.s <= b.s, without what open water reaches.
void add_closed_part(int block, int edge, Node a, Node b, const std::vector<WetInterval>& open_water,
                     wire::Load& load) {
  const auto add = [&](const Node& from, const Node& to) {
    wire::add_panel(load, block, edge, from.s, to.s, from.pressure_pa, to.pressure_pa);
  };
  const auto between = [whole_a = a, whole_b = b](double s) {
    const double share = (s - whole_a.s) / (whole_b.s - whole_a.s);
    return Node{s, whole_a.pressure_pa + share * (whole_b.pressure_pa - whole_a.pressure_pa)};
  };
  const auto before = [](const WetInterval& w, const std::pair<int, int>& face) {
    return std::pair(w.block, w.edge) < face;
  };
  const std::pair face(block, edge);
  for (auto open = std::lower_bound(open_water.begin(), open_water.end(), face, before);
       open != open_water.end() && std::pair(open->block, open->edge) == face; ++open) {
    if (open->s_to <= a.s || open->s_from >= b.s) continue;
    if (open->s_from > a.s) add(a, between(open->s_from));
    if (open->s_to >= b.s) return;
    a = between(open->s_to);
  }
  add(a, b);
}

/// Where elements of a piece from `from_m` on begin and end, as shares of it.
std::vector<double> element_ends(double from_m, double length_m, const joints::Profile& profile, int elements) {
  std::vector<double> shares;
  for (int k = 0; k <= elements; ++k) shares.push_back(static_cast<double>(k) / elements);
  const auto& knots = profile.knots();
  for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
    const double share = (knots[i].at_m - from_m) / length_m;
    if (share > 0 && share < 1) shares.push_back(share);
  }
  std::sort(shares.begin(), shares.end());
  return shares;
}

/// Is no place of one face within a tenth of the piece's length of the other's edge, along which it may have slid?
bool faces_are_apart(const scene::CrackPart& part, const scene::TracePiece& piece,
                     const std::vector<std::vector<Point>>& outlines) {
  constexpr double far = 0.1;
  const auto place = [&](int block, int edge, double s) -> Point {
    const std::vector<Point>& outline = outlines[at(block)];
    return outline[at(edge)] + s * (outline[(at(edge) + 1) % outline.size()] - outline[at(edge)]);
  };
  const auto to_edge = [&](const Point& p, int block, int edge) {
    return geometry::distance_to_segment(p, place(block, edge, 0), place(block, edge, 1));
  };
  const double least_m =
      std::min({to_edge(place(part.block_a, piece.edge_a, piece.s_from_a), part.block_b, piece.edge_b),
                to_edge(place(part.block_a, piece.edge_a, piece.s_to_a), part.block_b, piece.edge_b),
                to_edge(place(part.block_b, piece.edge_b, piece.s_from_b), part.block_a, piece.edge_a),
                to_edge(place(part.block_b, piece.edge_b, piece.s_to_b), part.block_a, piece.edge_a)});
  return least_m > far * (piece.to_m - piece.from_m).norm();
}

}  // namespace

void add_crack_elements(const scene::Crack& crack, const joints::Profile& profile, int elements_per_face,
                        const std::vector<std::vector<Point>>& outlines, const std::vector<WetInterval>& open_water,
                        wire::Load& load) {
  double travelled = 0;
  for (const scene::CrackPart& part : crack.parts) {
    for (const scene::TracePiece& piece : part.trace.pieces) {
      const double length = (piece.to_m - piece.from_m).norm();
      const std::vector<double> shares = element_ends(travelled, length, profile, elements_per_face);
      const auto face = [&](int block, int edge, double s_from, double s_to) {
        const auto element_end = [&](double share) {
          return Node{s_from + (s_to - s_from) * share, profile.pressure(travelled + length * share)};
        };
        for (std::size_t k = 1; k < shares.size(); ++k) {
          const Node a = element_end(shares[k - 1]);
          const Node b = element_end(shares[k]);
          add_closed_part(block, edge, a.s <= b.s ? a : b, a.s <= b.s ? b : a, open_water, load);
        }
      };
      if (!faces_are_apart(part, piece, outlines)) {
        face(part.block_a, piece.edge_a, piece.s_from_a, piece.s_to_a);
        face(part.block_b, piece.edge_b, piece.s_from_b, piece.s_to_b);
      }
      travelled += length;
    }
  }
}

}  // namespace blockweir::hydrostatic
