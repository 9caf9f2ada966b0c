// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/failed_joint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "bridge/scene/at.hpp"
#include "bridge/scene/joint_trace.hpp"
#include "solid/contact/outline.hpp"
#include "solid/watch/joint_name.hpp"

namespace blockweir::solid {
namespace {

/// A joint that a body leaves.
struct LeftJoint {
  int inside;                 ///< block of the body
  int outside;                ///< the one that it leaves
  double normal;              ///< N/m, with which they press on each other
  scene::JointTrace trace{};  ///< in the scene's outline
};

/// Do both lie in one direction, as what slides on a plane does on all of its pieces?
bool is_one_surface(const LeftJoint& a, const LeftJoint& b) {
  constexpr double sine = 0.1;
  if (a.trace.pieces.empty() || b.trace.pieces.empty()) return &a == &b;
  const Point u = a.trace.end() - a.trace.mouth();
  const Point v = b.trace.end() - b.trace.mouth();
  return std::abs(cross(u, v)) <= sine * u.norm() * v.norm();
}

/// Is the joint the straight continuation of one that bears? The ends of a body press little on the plane that it
/// slides on, or not at all.
bool continues_a_bearing_one(const LeftJoint& joint, const std::vector<LeftJoint>& left, double least_normal) {
  constexpr double on_line = 1e-4;  // of the bearing joint's length
  if (joint.trace.pieces.empty()) return false;
  return std::any_of(left.begin(), left.end(), [&](const LeftJoint& bearing) {
    if (bearing.trace.pieces.empty() || bearing.normal <= least_normal) return false;
    const Point from = bearing.trace.mouth();
    const Point along = bearing.trace.end() - from;
    const auto off = [&](const Point& p) { return std::abs(cross(along, p - from)); };
    return std::max(off(joint.trace.mouth()), off(joint.trace.end())) <= on_line * along.squaredNorm();
  });
}

}  // namespace

FailedJoint failed_joint(const Solid& solid, const MovingBody& body, const PairMotions& pairs, bool turns,
                         bool from_downstream) {
  constexpr double bears = 1e-2;  // of all that the body presses with
  const auto& blocks = solid.scene().blocks;
  std::vector<LeftJoint> left;
  double whole = 0;
  for (const auto& [inside, outside] : body.left) {
    const double normal = std::max(0.0, pairs.at(std::minmax(inside, outside)).normal);
    left.push_back({inside, outside, normal,
                    scene::trace_joint(blocks[at(inside)], blocks[at(outside)], 1e-6 * solid.model().size_m)});
    whole += normal;
  }
  const bool slides = !turns && whole > 0;
  // Joints that touch only because the body moved are not named if another joint carries load.
  const auto bears_from_the_start = [&](const LeftJoint& j) {
    return !j.trace.pieces.empty() && j.normal > bears * whole;
  };
  if (slides && std::any_of(left.begin(), left.end(), bears_from_the_start)) {
    std::erase_if(left, [](const LeftJoint& j) { return j.trace.pieces.empty(); });
  }
  std::vector<double> borne(left.size(), 0);  // by the whole surface of each
  for (std::size_t i = 0; i < left.size(); ++i) {
    for (const LeftJoint& other : left) borne[i] += is_one_surface(left[i], other) ? other.normal : 0;
  }
  const double most = left.empty() ? 0 : *std::max_element(borne.begin(), borne.end());
  const auto name_of = [&](const LeftJoint& joint) {
    const std::string set = joint_set(solid, joint.inside, joint.outside);
    return set.empty() ? joint_name(solid, joint.inside, joint.outside) : set;
  };
  FailedJoint failed;
  bool opens = false;
  double farthest = std::numeric_limits<double>::infinity();  // downstream of the pool, m
  for (std::size_t i = 0; i < left.size(); ++i) {
    const LeftJoint& joint = left[i];
    const bool pressed = joint.normal > bears * whole;
    const bool untouched = joint.trace.pieces.empty();
    if (!pressed && untouched) continue;
    if (!pressed && slides && !continues_a_bearing_one(joint, left, bears * whole)) continue;
    if (slides && borne[i] < most) continue;
    double x = std::numeric_limits<double>::max();
    if (!untouched) x = from_downstream ? -joint.trace.end().x() : joint.trace.mouth().x();
    if (x >= farthest) continue;
    farthest = x;
    failed = {.name = name_of(joint)};
    opens = !pressed && !slides;
    if (!untouched) failed.line = {joint.trace.mouth(), joint.trace.end()};
  }
  if (!opens || whole <= 0) return failed;
  const std::string bearing = name_of(*std::max_element(
      left.begin(), left.end(), [](const LeftJoint& a, const LeftJoint& b) { return a.normal < b.normal; }));
  if (bearing != failed.name) failed.turns_on = bearing;
  return failed;
}

}  // namespace blockweir::solid
