// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/fill_motion.hpp"

#include "bridge/scene/at.hpp"
#include "bridge/scene/water_answers.hpp"

namespace blockweir::solid {
namespace {

void tell_corners(const Solid& solid, double ahead_s, wire::Motion& motion) {
  const auto& corners = solid.model().water_motions.corners();
  if (corners.empty()) return;
  auto& velocity = motion.face_velocity.own();
  velocity.resize(corners.size());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const OutlineSide& side = corners[k].side;
    const BlockState& s = solid.states()[at(side.part)];
    const Vector6 of_corners = s.velocity + ahead_s * s.acceleration;
    Point::Map(velocity[k].data()) = of_corners.segment<2>(2 * static_cast<Eigen::Index>(side.edge));
  }
  if (motion.face_s.size() == corners.size()) return;  // they stay
  motion.face_s.clear();
  motion.face_edge.clear();
  for (const auto& [block, side] : corners) {
    motion.face_s.push_back(side.s_from);
    motion.face_edge.push_back({static_cast<std::uint32_t>(block), static_cast<std::uint32_t>(side.described_edge)});
  }
}

}  // namespace

void fill_motion(const Solid& solid, double ahead_s, wire::Motion& motion) {
  const std::size_t n = solid.described();
  const double velocities_ahead_s =
      scene::answers_ahead(solid.scene()) ? scene::velocities_ahead_s(solid.scene()) : ahead_s;
  auto& displacement = motion.displacement.own();
  auto& velocity = motion.velocity.own();
  displacement.resize(n);
  velocity.resize(n);
  for (std::size_t b = 0; b < n; ++b) {
    const BlockState& s = solid.states()[b];
    Vector6::Map(displacement[b].data()) =
        s.displacement + ahead_s * s.velocity + ahead_s * ahead_s / 2 * s.acceleration;
    Vector6::Map(velocity[b].data()) = s.velocity + velocities_ahead_s * s.acceleration;
  }
  tell_corners(solid, velocities_ahead_s, motion);
}

}  // namespace blockweir::solid
