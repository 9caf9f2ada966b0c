// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/common_slip.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "solid/block/motion.hpp"

namespace blockweir::solid {

bool slips_as_one(const std::vector<Block>& blocks, const std::vector<ContactPoint>& contacts,
                  std::span<const int> joint) {
  constexpr double free = 1e-3;  // of a motion, what a contact may be pressed or opened by; a slip is more than that
  const auto place = [&](const ContactPoint& c) { return Point(blocks[at(c.vertex_part)].centroid + c.vertex_at); };
  std::vector<const ContactPoint*> closed;
  for (const int k : joint) {
    if (contacts[at(k)].state != ContactState::open) closed.push_back(&contacts[at(k)]);
  }
  if (closed.size() < 2) return true;
  const Point origin = place(*closed.front());
  double size = 0;
  for (const ContactPoint* c : closed) size = std::max(size, (place(*c) - origin).norm());
  // Velocity (u, v, turn times size) of the one block against the other, as it moves the contact along `axis`.
  const auto row = [&](const ContactPoint& c, const Point& axis) {
    const Point arm = size > 0 ? Point((place(c) - origin) / size) : Point(Point::Zero());
    return Eigen::RowVector3d(axis.x(), axis.y(), perpendicular(arm).dot(axis));
  };
  const auto tangent = [](const ContactPoint& c) { return Point((c.edge_to - c.edge_from).normalized()); };
  Eigen::Matrix3d stopped = Eigen::Matrix3d::Zero();
  for (const ContactPoint* c : closed) {
    const Eigen::RowVector3d normal = row(*c, perpendicular(tangent(*c)));
    stopped += normal.transpose() * normal;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> motions(stopped);
  const auto stops = [&](Eigen::Index i) { return motions.eigenvalues()[i] > free * free; };
  if (stops(0) || !stops(1)) return !stops(0);
  return std::all_of(closed.begin(), closed.end(), [&](const ContactPoint* c) {
    return c->state != ContactState::slip || std::abs(row(*c, tangent(*c)).dot(motions.eigenvectors().col(0))) > free;
  });
}

}  // namespace blockweir::solid
