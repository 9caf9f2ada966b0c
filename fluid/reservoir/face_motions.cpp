// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/face_motions.hpp"

#include <algorithm>

#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/water_answers.hpp"

namespace blockweir::reservoir {

FaceMotions::FaceMotions(const scene::Scene& scene, const wire::Motion& motion,
                         const std::vector<std::vector<Point>>& outlines)
    : corners_of_(scene.blocks.size()), count_(scene.blocks.size()) {
  const bool answers_strains = scene::answers_bending(scene);
  bool any_strains = false;
  for (std::size_t b = 0; b < scene.blocks.size(); ++b) {
    const scene::Block& block = scene.blocks[b];
    const bool strains = answers_strains && !block.fixed && !block.rigid && block.mesh_size_m == 0 &&
                         scene.analysis.rigid != scene::Rigid::all;
    any_strains = any_strains || strains;
    bodies_.push_back({block.fixed, strains, geometry::centroid(outlines[b]),
                       Eigen::Rotation2Dd(motion.displacement[b][2]).toRotationMatrix(), outlines[b]});
  }
  take_corners(motion);
  if (any_strains || !corners_.empty()) count_ = 2 * scene.blocks.size() + corners_.size();
}

void FaceMotions::take_corners(const wire::Motion& motion) {
  const std::size_t n = motion.face_s.size();
  for (std::size_t k = 0; k < n; ++k) {
    const auto [block, edge] = motion.face_edge[k];
    const auto& outline = bodies_.at(block).outline;
    const Point& from = outline.at(edge);
    corners_.emplace_back(from + motion.face_s[k] * (outline[(edge + 1) % outline.size()] - from));
    corners_of_[block].push_back(k);
    corner_.push_back({edge, motion.face_s[k], 1, k + 1});
  }
  for (const auto& own : corners_of_) {
    if (own.empty()) continue;
    for (std::size_t i = 0; i + 1 < own.size(); ++i) {
      Corner& corner = corner_[own[i]];
      corner.next = own[i + 1];
      if (corner_[corner.next].edge == corner.edge) corner.s_to = corner_[corner.next].s_from;
    }
    corner_[own.back()].next = own.front();
  }
}

process::PointMotion FaceMotions::operator()(const process::FacePoint& point) const {
  const Body& body = bodies_[at(point.block)];
  if (body.fixed) return {};
  if (!corners_of_[at(point.block)].empty()) return of_corners(point);
  const Point& from = body.outline[at(point.edge)];
  const Point to = body.outline[(at(point.edge) + 1) % body.outline.size()];
  const Point arm = from + point.s * (to - from) - body.centroid;
  process::PointMotion motion;
  const auto number = [&](std::size_t of_three) { return static_cast<int>(3 * of_three); };
  const int rigid = number(at(point.block));
  motion.unknown = {rigid, rigid + 1, rigid + 2};
  motion.by_unknown.resize(2, body.strains ? 6 : 3);
  motion.by_unknown.leftCols<3>() << 1, 0, -arm.y(), 0, 1, arm.x();
  if (body.strains) {
    const Point X = body.turn.transpose() * arm;
    const int strain = number(bodies_.size() + at(point.block));
    motion.unknown.insert(motion.unknown.end(), {strain, strain + 1, strain + 2});
    motion.by_unknown.col(3) = body.turn * Point(X.x(), 0);
    motion.by_unknown.col(4) = body.turn * Point(0, X.y());
    motion.by_unknown.col(5) = body.turn * Point(X.y() / 2, X.x() / 2);
  }
  return motion;
}

/// Between its two corners a side of a mesh stays straight.
process::PointMotion FaceMotions::of_corners(const process::FacePoint& point) const {
  const auto& own = corners_of_[at(point.block)];
  std::size_t from = own.front();
  double outside = 2;
  for (const std::size_t k : own) {
    const Corner& corner = corner_[k];
    if (corner.edge != static_cast<std::uint32_t>(point.edge)) continue;
    const double beyond = std::max({0.0, corner.s_from - point.s, point.s - corner.s_to});
    if (beyond < outside) outside = beyond, from = k;
  }
  const Corner& corner = corner_[from];
  const double way = std::clamp((point.s - corner.s_from) / (corner.s_to - corner.s_from), 0.0, 1.0);
  process::PointMotion motion;
  motion.by_unknown = Eigen::Matrix2Xd::Zero(2, 4);
  motion.by_unknown.leftCols<2>() = (1 - way) * Eigen::Matrix2d::Identity();
  motion.by_unknown.rightCols<2>() = way * Eigen::Matrix2d::Identity();
  for (const std::size_t k : {from, corner.next}) {
    const int x = static_cast<int>(3 * (2 * bodies_.size() + k));
    motion.unknown.insert(motion.unknown.end(), {x, x + 1});
  }
  return motion;
}

}  // namespace blockweir::reservoir
