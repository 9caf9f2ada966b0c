// SPDX-License-Identifier: GPL-3.0-or-later
// The common boundary of two blocks: parts of edges that run opposite ways over each other, as one chain.
#include "bridge/scene/joint_trace.hpp"

#include <algorithm>
#include <optional>

namespace blockweir::scene {
namespace {

struct Edge {
  Point from;
  Point to;
  [[nodiscard]] Point along() const { return to - from; }
  [[nodiscard]] Point at(double s) const { return from + s * along(); }
  /// Of the foot of p; within 1e-12 of an end it is that end.
  [[nodiscard]] double fraction(const Point& p) const {
    const double s = along().dot(p - from) / along().squaredNorm();
    if (s < 1e-12) return 0;
    return s > 1 - 1e-12 ? 1 : s;
  }
};

Edge edge_of(const Block& block, std::size_t e) {
  return {block.vertices[e], block.vertices[(e + 1) % block.vertices.size()]};
}

bool upstream_of(const Point& a, const Point& b) {
  return a.x() != b.x() ? a.x() < b.x() : a.y() > b.y();
}

/// Where two edges lie on each other, along edge a.
std::optional<TracePiece> common_part(const Edge& a, const Edge& b, double tolerance_m) {
  if (a.along().dot(b.along()) >= 0) return std::nullopt;
  TracePiece piece;
  piece.s_from_a = a.fraction(b.to);
  piece.s_to_a = a.fraction(b.from);
  piece.from_m = a.at(piece.s_from_a);
  piece.to_m = a.at(piece.s_to_a);
  piece.s_from_b = b.fraction(piece.from_m);
  piece.s_to_b = b.fraction(piece.to_m);
  const bool apart = (b.at(piece.s_from_b) - piece.from_m).norm() > tolerance_m ||
                     (b.at(piece.s_to_b) - piece.to_m).norm() > tolerance_m;
  if (apart || (piece.to_m - piece.from_m).norm() <= tolerance_m) return std::nullopt;
  return piece;
}

/// Pieces in the order in which they lie along the outline of a.
std::vector<TracePiece> pieces_along(const Block& a, const Block& b, double tolerance_m) {
  std::vector<TracePiece> pieces;
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    for (std::size_t j = 0; j < b.vertices.size(); ++j) {
      auto piece = common_part(edge_of(a, i), edge_of(b, j), tolerance_m);
      if (!piece) continue;
      piece->edge_a = static_cast<int>(i);
      piece->edge_b = static_cast<int>(j);
      pieces.push_back(*piece);
    }
  }
  std::sort(pieces.begin(), pieces.end(), [](const TracePiece& p, const TracePiece& q) {
    return p.edge_a != q.edge_a ? p.edge_a < q.edge_a : p.s_from_a < q.s_from_a;
  });
  return pieces;
}

/// Turns the pieces, which follow the closed outline of a, into a chain that begins at its upstream end.
void begin_upstream(std::vector<TracePiece>& pieces, double tolerance_m) {
  const std::size_t n = pieces.size();
  std::size_t first = 0;
  bool backwards = false;
  std::optional<Point> end;
  for (std::size_t i = 0; i < n; ++i) {
    const TracePiece& before = pieces[(i + n - 1) % n];
    if (n > 1 && (before.to_m - pieces[i].from_m).norm() <= tolerance_m) continue;  // the chain goes on here
    for (const bool back : {false, true}) {
      const Point& candidate = back ? before.to_m : pieces[i].from_m;
      if (end && !upstream_of(candidate, *end)) continue;
      end = candidate;
      first = i;
      backwards = back;
    }
  }
  std::rotate(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(first), pieces.end());
  if (!backwards) return;
  std::reverse(pieces.begin(), pieces.end());
  for (TracePiece& piece : pieces) {
    std::swap(piece.from_m, piece.to_m);
    std::swap(piece.s_from_a, piece.s_to_a);
    std::swap(piece.s_from_b, piece.s_to_b);
  }
}

}  // namespace

JointTrace trace_joint(const Block& a, const Block& b, double tolerance_m) {
  JointTrace trace{.pieces = pieces_along(a, b, tolerance_m)};
  if (!trace.pieces.empty()) begin_upstream(trace.pieces, tolerance_m);
  for (const TracePiece& piece : trace.pieces) trace.length_m += (piece.to_m - piece.from_m).norm();
  return trace;
}

}  // namespace blockweir::scene
