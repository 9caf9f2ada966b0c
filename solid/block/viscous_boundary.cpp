// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/block/viscous_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/scene/at.hpp"
#include "solid/block/motion.hpp"

namespace blockweir::solid {
namespace {

// Stiffness of the springs that hold the ground at rest, over its modulus and a block's size: their settlement is below
// a thousandth of its strain. Their forces remain as a load.
constexpr double stiffer = 1e3;

double lowest_of(const scene::Scene& scene) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& face : scene.viscous_faces) lowest = std::min({lowest, face.from_m.y(), face.to_m.y()});
  return lowest;
}

/// Where the ground's surface is beside the model: the upper end of all faces on that side.
double surface_beside(const scene::Scene& scene, const scene::ViscousFace& like) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const auto& face : scene.viscous_faces) {
    if (face.is_side() != like.is_side() || face.normal().x() * like.normal().x() < 0) continue;
    highest = std::max({highest, face.from_m.y(), face.to_m.y()});
  }
  return highest;
}

/// First-order shape matrix (1)-(3) of a block where the scene draws it.
Matrix26 shape_at(const Point& material) {
  return Placement(Point::Zero(), Vector6::Zero()).shape(material);
}

}  // namespace

ViscousBoundary::ViscousBoundary(const scene::Scene& scene, const MovingParts& parts) {
  if (scene.viscous_faces.empty()) return;
  drag_.assign(parts.blocks.size(), Matrix6::Zero());
  hold_ = drag_;
  for (const auto& face : scene.viscous_faces) {
    add(scene, parts, face, lowest_of(scene), surface_beside(scene, face));
  }
  for (const BoundaryPoint& p : points_) {
    const Matrix26 T = shape_at(p.material);
    drag_[at(p.part)] += p.length_m * T.transpose() * p.resistance() * T;
    const Block& block = parts.blocks[at(p.part)];
    // Beside the model the ground settles under its weight as it does here.
    Eigen::Matrix2d held = Eigen::Matrix2d::Identity();
    if (p.side) held = p.normal * p.normal.transpose();
    hold_[at(p.part)] += stiffer * block.elasticity(0, 0) / block.radius * p.length_m * T.transpose() * held * T;
  }
}

/// A face as far as it lies on each of the outline's sides.
void ViscousBoundary::add(const scene::Scene& scene, const MovingParts& parts, const scene::ViscousFace& face,
                          double lowest_m, double surface_m) {
  const scene::Block& described = scene.blocks[at(face.block)];
  const scene::Material& beyond = scene.materials[at(face.material)];
  const Eigen::Matrix3d D = make_block(described, beyond, scene.analysis.plane).elasticity;
  BoundaryPoint like{.normal = face.normal(), .side = face.is_side(), .lateral = D(0, 1) / D(1, 1)};
  like.speed = {std::sqrt(D(2, 2) / beyond.density_kg_per_m3), std::sqrt(D(1, 1) / beyond.density_kg_per_m3)};
  like.impedance = beyond.density_kg_per_m3 * like.speed;
  const Point along = (face.to_m - face.from_m).normalized();
  const double near_m = 1e-6 * parts.blocks[at(face.block)].radius;
  for (const OutlineSide& side : parts.outlines[at(face.block)]) {
    const Point origin = parts.blocks[at(side.part)].centroid - face.from_m;
    const Point a = origin + parts.vertex(side);
    const Point b = origin + parts.end(side);
    if (std::abs(like.normal.dot(a)) > near_m || std::abs(like.normal.dot(b)) > near_m) continue;
    const double length = along.dot(b - a);
    if (length <= 0) continue;
    const double from = std::max(0.0, -along.dot(a)) / length;
    const double to = std::min(length, face.length_m() - along.dot(a)) / length;
    if (to > from) add_side(parts, side, from, to, like, lowest_m, surface_m);
  }
}

/// Two points of Gauss: exact for what dashpots do along a straight side.
void ViscousBoundary::add_side(const MovingParts& parts, const OutlineSide& side, double from, double to,
                               BoundaryPoint like, double lowest_m, double surface_m) {
  const Point& a = parts.vertex(side);
  const Point& b = parts.end(side);
  for (const double sign : {-1.0, 1.0}) {
    like.part = side.part;
    like.material = a + ((from + to) / 2 + sign * (to - from) / (2 * std::sqrt(3.0))) * (b - a);
    like.length_m = (to - from) * (b - a).norm() / 2;
    const double y = parts.blocks[at(side.part)].centroid.y() + like.material.y();
    like.up_m = y - lowest_m;
    like.down_m = 2 * (surface_m - lowest_m) - like.up_m;
    points_.push_back(like);
  }
}

Eigen::Matrix2d ViscousBoundary::BoundaryPoint::resistance() const {
  const Eigen::Matrix2d across = normal * normal.transpose();
  return impedance[1] * across + impedance[0] * (Eigen::Matrix2d::Identity() - across);
}

Point ViscousBoundary::traction(const BoundaryPoint& p, const BaseMotion& base, const scene::TimeSpan& step,
                                bool mean) {
  const auto record = [&](double way_m, int axis) {
    const double later_s = way_m / p.speed[axis];
    return base.ground_velocity({step.from_s - later_s, step.to_s - later_s}, mean)[axis];
  };
  const Point up(record(p.up_m, 0), record(p.up_m, 1));  // twice the rising wave
  // Motions are against the base where its inertia acts.
  const Point frame = base.moves_supports() ? Point(Point::Zero()) : base.ground_velocity(step, mean);
  if (!p.side) return p.resistance() * (up - frame);
  const Point down(record(p.down_m, 0), record(p.down_m, 1));
  const Point stress = p.impedance.cwiseProduct(down - up) / 2;  // shear, and along y
  const Point pull(p.lateral * stress.y() * p.normal.x() + stress.x() * p.normal.y(),
                   stress.x() * p.normal.x() + stress.y() * p.normal.y());
  return p.resistance() * ((up + down) / 2 - frame) + pull;
}

void ViscousBoundary::add_free_field(const BaseMotion& base, const scene::TimeSpan& step, bool mean,
                                     std::vector<Vector6>& forces) const {
  if (!base.shakes()) return;
  for (const BoundaryPoint& p : points_) {
    forces[at(p.part)] += p.length_m * shape_at(p.material).transpose() * traction(p, base, step, mean);
  }
}

}  // namespace blockweir::solid
