// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/modes/structure.hpp"

#include <algorithm>

#include "bridge/scene/at.hpp"
#include "solid/block/corners.hpp"

namespace blockweir::solid {
namespace {

/// Of springs that hold, over the largest stiffness of what gives way: frequencies change by some 1e-6.
constexpr double stiffer = 1e5;

std::vector<int> moving_parts(const Solid& solid) {
  std::vector<int> parts;
  for (std::size_t b = 0; b < solid.blocks().size(); ++b) {
    const Block& block = solid.blocks()[b];
    if (!block.fixed && !block.meshed) parts.push_back(static_cast<int>(b));
  }
  return parts;
}

Unknowns unknowns_of(const Solid& solid, const std::vector<int>& parts) {
  std::vector<int> count;
  std::vector<std::array<int, 3>> nodes;
  bool shared = false;
  for (const int part : parts) {
    const Block& block = solid.blocks()[at(part)];
    count.push_back(block.unknowns());
    nodes.push_back(block.nodes);
    shared = shared || block.is_part();
  }
  Unknowns unknowns(count, shared ? nodes : std::vector<std::array<int, 3>>{});
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Block& block = solid.blocks()[at(parts[k])];
    if (block.is_part()) unknowns.set_map(static_cast<int>(k), corner_map(block, solid.placements()[at(parts[k])]));
  }
  return unknowns;
}

Eigen::SparseMatrix<double> summed(const std::vector<Eigen::Triplet<double>>& entries, int size) {
  Eigen::SparseMatrix<double> sum(size, size);
  sum.setFromTriplets(entries.begin(), entries.end());
  return sum;
}

/// A joint without any shear strength does not slip where nothing pushes it.
bool holds_shear(const Solid& solid, const ContactPoint& c) {
  if (c.state != ContactState::stick) return false;
  const Strength strength = solid.laws().strength(c, c.force.x());
  return strength.friction > 0 || strength.cohesion > 0;
}

/// k times an outer product of a direction.
Eigen::Matrix2d along(const Point& direction, double k) {
  return k * direction * direction.transpose();
}

}  // namespace

double largest_modulus(const Solid& solid) {
  double largest = 0;
  double of_rigid = 0;
  for (const Block& block : solid.blocks()) {
    if (block.fixed) continue;
    const bool gives_way = !block.rigid || !solid.model().boundary.empty();
    double& most = gives_way ? largest : of_rigid;
    most = std::max(most, block.elasticity.diagonal().maxCoeff());
  }
  for (const Bolt& bolt : solid.bolts()) largest = std::max(largest, bolt.acting.slope_n_per_m2);
  return largest > 0 ? largest : of_rigid;
}

Structure::Structure(const Solid& solid)
    : solid_(solid),
      parts_(moving_parts(solid)),
      local_(solid.blocks().size(), -1),
      unknowns_(unknowns_of(solid, parts_)) {
  for (std::size_t k = 0; k < parts_.size(); ++k) local_[at(parts_[k])] = static_cast<int>(k);
  Entries mass;
  Entries stiffness;
  add_blocks(mass, stiffness);
  add_holds(stiffness);
  mass_ = summed(mass, unknowns());
  stiffness_ = summed(stiffness, unknowns());
}

/// Between two parts' six unknowns.
void Structure::add(int part_i, int part_j, const Matrix6& k, Entries& entries) const {
  const Matrix6 own = unknowns_.mapped(local(part_i), local(part_j), k);
  const auto rows = unknowns_.of(local(part_i));
  const auto columns = unknowns_.of(local(part_j));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < columns.size(); ++j) {
      entries.emplace_back(rows[i], columns[j], own(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
    }
  }
}

void Structure::add_blocks(Entries& mass, Entries& stiffness) const {
  for (const int part : parts_) {
    const Block& block = solid_.blocks()[at(part)];
    add(part, part, block.inertia.matrix(), mass);
    Matrix6 k = Matrix6::Zero();
    k.bottomRightCorner<3, 3>() = block.stiffness;
    if (!solid_.model().boundary.empty()) k += solid_.model().boundary.hold(at(part));
    add(part, part, k, stiffness);
  }
  for (const StrainCoupling& c : solid_.parts().couplings) {
    if (!moves(c.i) || !moves(c.j)) continue;
    Matrix6 k = Matrix6::Zero();
    k.bottomRightCorner<3, 3>() = c.stiffness;
    add(c.i, c.j, k, stiffness);
    add(c.j, c.i, k, stiffness);
  }
}

void Structure::add_holds(Entries& stiffness) const {
  const double holds = stiffer * largest_modulus(solid_);
  for (const ContactPoint& c : solid_.contacts()) {
    if (c.state == ContactState::open) continue;
    const Point edge = c.edge_to - c.edge_from;
    const Point tangent = solid_.placements()[at(c.edge_part)].vector(edge).normalized();
    const Point on_edge = c.edge_from + std::clamp(c.anchor, 0.0, 1.0) * edge;
    Eigen::Matrix2d k = along(perpendicular(tangent), holds);
    if (holds_shear(solid_, c)) k += along(tangent, holds);
    add_spring(c.vertex_part, c.vertex_at, c.edge_part, on_edge, k, stiffness);
  }
  for (const Support& support : solid_.state().supports) {
    const Eigen::Matrix2d k = (holds * support.held()).asDiagonal();
    add_spring(support.block, support.material, -1, Point::Zero(), k, stiffness);
  }
  for (const Bolt& bolt : solid_.bolts()) {
    const auto place = [&](std::size_t end) {
      return bolt.part[end] < 0 ? bolt.material[end]
                                : solid_.placements()[at(bolt.part[end])].position(bolt.material[end]);
    };
    const Point line = (place(1) - place(0)).normalized();
    const Eigen::Matrix2d k = along(line, bolt.acting.slope_n_per_m2);
    const std::size_t first = moves(bolt.part[0]) ? 0 : 1;
    add_spring(bolt.part[first], bolt.material[first], bolt.part[1 - first], bolt.material[1 - first], k, stiffness);
  }
}

/// k resists the displacement of point i relative to point j.
void Structure::add_spring(int part_i, const Point& at_i, int part_j, const Point& at_j, const Eigen::Matrix2d& k,
                           Entries& stiffness) const {
  if (moves(part_i)) {
    const Matrix26 T = solid_.placements()[at(part_i)].shape(at_i);
    add(part_i, part_i, T.transpose() * k * T, stiffness);
  }
  if (moves(part_j)) {
    const Matrix26 T = solid_.placements()[at(part_j)].shape(at_j);
    add(part_j, part_j, T.transpose() * k * T, stiffness);
  }
  if (!moves(part_i) || !moves(part_j)) return;
  const Matrix6 between =
      -solid_.placements()[at(part_i)].shape(at_i).transpose() * k * solid_.placements()[at(part_j)].shape(at_j);
  add(part_i, part_j, between, stiffness);
  add(part_j, part_i, between.transpose(), stiffness);
}

Eigen::VectorXd Structure::translation(int axis) const {
  Eigen::VectorXd q = Eigen::VectorXd::Zero(unknowns());
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const auto own = unknowns_.of(static_cast<int>(k));
    const bool corners = solid_.blocks()[at(parts_[k])].is_part();
    for (std::size_t i = static_cast<std::size_t>(axis); i < (corners ? own.size() : 2); i += 2) q[own[i]] = 1;
  }
  return q;
}

process::PointMotion Structure::motion_of(const process::FacePoint& point) const {
  const auto& outline = solid_.parts().outlines[at(point.block)];
  const auto side = std::find_if(outline.begin(), outline.end(), [&](const OutlineSide& o) {
    return o.described_edge == point.edge && point.s >= o.s_from - 1e-9 && point.s <= o.s_to + 1e-9;
  });
  if (side == outline.end() || !moves(side->part)) return {};
  const Point& from = solid_.parts().vertex(*side);
  const double way = (point.s - side->s_from) / (side->s_to - side->s_from);
  const Point material = from + way * (solid_.parts().end(*side) - from);
  const auto unknown = unknowns_.of(local(side->part));
  process::PointMotion motion{{unknown.begin(), unknown.end()}, {}};
  const Matrix26 T = solid_.placements()[at(side->part)].shape(material);
  Matrix26 own = T;
  for (Eigen::Index row = 0; row < 2; ++row) {
    own.row(row) = unknowns_.mapped(local(side->part), Vector6(T.row(row).transpose())).transpose();
  }
  motion.by_unknown = own.leftCols(static_cast<Eigen::Index>(motion.unknown.size()));
  return motion;
}

Point Structure::displacement(int part, const Point& material, const Eigen::VectorXd& q) const {
  if (!moves(part)) return Point::Zero();
  return solid_.placements()[at(part)].shape(material) * unknowns_.take(local(part), q);
}

}  // namespace blockweir::solid
