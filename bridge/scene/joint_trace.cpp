// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/joint_trace.hpp"

#include <algorithm>
#include <cmath>

namespace blockweir::scene {
namespace {

struct Edge {
  Point from;
  Point to;
  [[nodiscard]] double fraction(const Point& p) const { return (to - from).dot(p - from) / (to - from).squaredNorm(); }
  [[nodiscard]] double offset(const Point& p) const {
    const Point span = (to - from).normalized();
    return span.x() * (p - from).y() - span.y() * (p - from).x();
  }
};

Edge edge_of(const Block& block, std::size_t e) {
  return {block.vertices[e], block.vertices[(e + 1) % block.vertices.size()]};
}

/// Fractions that are an end but for round-off are that end.
double snapped(double s) {
  if (std::abs(s) < 1e-12) return 0;
  if (std::abs(s - 1) < 1e-12) return 1;
  return s;
}

bool upstream_of(const Point& a, const Point& b) {
  return a.x() != b.x() ? a.x() < b.x() : a.y() > b.y();
}

}  // namespace

JointTrace trace_joint(const Block& a, const Block& b, double tolerance_m) {
  JointTrace trace;
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    const Edge ea = edge_of(a, i);
    for (std::size_t j = 0; j < b.vertices.size(); ++j) {
      const Edge eb = edge_of(b, j);
      if ((ea.to - ea.from).dot(eb.to - eb.from) >= 0) continue;
      if (std::max(std::abs(ea.offset(eb.from)), std::abs(ea.offset(eb.to))) > tolerance_m) continue;
      const double s0 = snapped(std::max(0.0, ea.fraction(eb.to)));
      const double s1 = snapped(std::min(1.0, ea.fraction(eb.from)));
      if ((s1 - s0) * (ea.to - ea.from).norm() <= tolerance_m) continue;
      TracePiece piece{.edge_a = static_cast<int>(i), .edge_b = static_cast<int>(j), .s_from_a = s0, .s_to_a = s1};
      piece.from_m = ea.from + s0 * (ea.to - ea.from);
      piece.to_m = ea.from + s1 * (ea.to - ea.from);
      if (upstream_of(piece.to_m, piece.from_m)) {
        std::swap(piece.from_m, piece.to_m);
        std::swap(piece.s_from_a, piece.s_to_a);
      }
      piece.s_from_b = snapped(eb.fraction(piece.from_m));
      piece.s_to_b = snapped(eb.fraction(piece.to_m));
      trace.length_m += (piece.to_m - piece.from_m).norm();
      trace.pieces.push_back(piece);
    }
  }
  std::sort(trace.pieces.begin(), trace.pieces.end(),
            [](const TracePiece& p, const TracePiece& q) { return upstream_of(p.from_m, q.from_m); });
  return trace;
}

}  // namespace blockweir::scene
