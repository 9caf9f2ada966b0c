// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/limit/connections.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/joint_trace.hpp"
#include "bridge/scene/read/check.hpp"
#include "bridge/scene/structure_size.hpp"
#include "solid/limit/corner_contacts.hpp"
#include "solid/limit/linear_program.hpp"

namespace blockweir::solid::limit {
namespace {

using geometry::Bounds;

/// Pairs whose boxes touch, the lower index first.
std::vector<std::pair<int, int>> neighbours(const scene::Scene& scene, double touching_m) {
  std::vector<Bounds> boxes;
  std::vector<int> by_left;
  for (const scene::Block& block : scene.blocks) {
    by_left.push_back(static_cast<int>(boxes.size()));
    boxes.push_back(geometry::bounds_of(block.vertices));
  }
  std::sort(by_left.begin(), by_left.end(), [&](int i, int j) { return boxes[at(i)].low.x() < boxes[at(j)].low.x(); });
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < by_left.size(); ++i) {
    const Bounds& one = boxes[at(by_left[i])];
    for (std::size_t j = i + 1; j < by_left.size(); ++j) {
      const Bounds& other = boxes[at(by_left[j])];
      if (other.low.x() > one.high.x() + touching_m) break;
      if (other.low.y() > one.high.y() + touching_m || one.low.y() > other.high.y() + touching_m) continue;
      pairs.push_back(std::minmax(by_left[i], by_left[j]));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// `bonded`: the share of the joint's length that has cohesion and tension strength.
Face face_of(const scene::TracePiece& piece, int a, int b, int joint, const scene::JointLaw& law, double bonded) {
  Face face{.a = a, .b = b, .joint = joint, .from_m = piece.from_m, .to_m = piece.to_m};
  const Point along = (face.to_m - face.from_m).normalized();
  // Outlines run counter-clockwise: what lies to the right of an edge is out of its block.
  const Point forwards = piece.s_from_a < piece.s_to_a ? along : Point(-along);
  face.normal = Point(forwards.y(), -forwards.x());
  face.law = &law;
  face.friction = law.friction();
  if (law.bends()) face.tangents = {law.tangent(face.friction, 0)};
  face.cohesion_n_per_m = law.cohesion_pa * bonded * face.length_m();
  face.tension_n_per_m = law.tension_cut_off_pa() * bonded * face.length_m();
  return face;
}

/// Bodies that act on a block: other blocks, or all ground blocks together.
class Bodies {
 public:
  Bodies(const scene::Scene& scene, const std::vector<std::pair<int, int>>& pairs, double touching_m)
      : scene_(scene), touching_m_(touching_m) {
    for (const auto& [a, b] : pairs) {
      if (scene.blocks[at(a)].fixed != scene.blocks[at(b)].fixed) {
        const auto [fixed, moves] = scene.blocks[at(a)].fixed ? std::pair(a, b) : std::pair(b, a);
        on_ground_[moves].push_back(meeting(moves, fixed));
      }
    }
  }
  /// Corners of one of a pair in the other one, as faces of no length.
  [[nodiscard]] std::vector<Face> corners(int a, int b, int joint, const scene::JointLaw& law) const {
    const bool turned = scene_.blocks[at(a)].fixed;
    const int block = turned ? b : a;
    const int other = turned ? a : b;
    const bool ground = scene_.blocks[at(other)].fixed;
    const std::vector<Neighbour> body = ground ? on_ground_.at(block) : std::vector{meeting(block, other)};
    const auto of = std::find_if(body.begin(), body.end(), [&](const Neighbour& n) { return n.index == other; });
    std::vector<Face> faces;
    for (const CornerContact& corner : corner_contacts(scene_.blocks[at(block)], body, *of, touching_m_)) {
      faces.push_back({.a = a,
                       .b = b,
                       .joint = joint,
                       .from_m = corner.at_m,
                       .to_m = corner.at_m,
                       .normal = turned ? Point(-corner.normal) : corner.normal,
                       .in_kink = corner.in_kink,
                       .friction = law.friction()});
    }
    return faces;
  }

 private:
  [[nodiscard]] Neighbour meeting(int block, int other) const {
    const scene::Block& second = scene_.blocks[at(other)];
    return {other, &second, scene::trace_joint(scene_.blocks[at(block)], second, touching_m_)};
  }
  const scene::Scene& scene_;
  double touching_m_;
  std::map<int, std::vector<Neighbour>> on_ground_;  ///< by block that can move
};

}  // namespace

std::vector<Face::Bound> Face::bounds() const {
  if (tangents.empty()) return {{cohesion_n_per_m, friction}};
  std::vector<Bound> all;
  for (const scene::StrengthLine& line : tangents) {
    all.push_back({cohesion_n_per_m + line.cohesion_pa * length_m(), line.friction});
  }
  return all;
}

bool Face::add_tangent(double normal_n_per_m, double shear_n_per_m) {
  constexpr double close = 1e-10;
  constexpr double same = 1e-9;  // of slopes: beyond, programs do not tell them apart
  if (tangents.empty()) return false;
  const double compression = std::max(0.0, normal_n_per_m);
  const scene::StrengthLine line = law->tangent(friction, compression / length_m());
  const double bound = cohesion_n_per_m + line.cohesion_pa * length_m() + line.friction * normal_n_per_m;
  if (shear_n_per_m <= bound + close * (cohesion_n_per_m + compression)) return false;
  const bool known = std::any_of(tangents.begin(), tangents.end(),
                                 [&](const auto& t) { return std::abs(t.friction - line.friction) < same; });
  if (known) return false;
  const auto next =
      std::find_if(tangents.begin(), tangents.end(), [&](const auto& t) { return t.friction < line.friction; });
  tangents.insert(next, line);
  return true;
}

std::vector<Face> faces_of(const scene::Scene& scene) {
  const double touching_m = scene::rounding_ratio * scene::structure_size_m(scene.blocks);
  std::map<std::pair<int, int>, int> joints;
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    joints[std::minmax(scene.joints[j].between[0], scene.joints[j].between[1])] = static_cast<int>(j);
  }
  const std::vector<std::pair<int, int>> pairs = neighbours(scene, touching_m);
  const Bodies bodies(scene, pairs, touching_m);
  std::vector<Face> faces;
  for (const auto& [a, b] : pairs) {
    if (scene.blocks[at(a)].fixed && scene.blocks[at(b)].fixed) continue;
    const scene::JointTrace trace = scene::trace_joint(scene.blocks[at(a)], scene.blocks[at(b)], touching_m);
    const auto found = joints.find({a, b});
    const int joint = found == joints.end() ? -1 : found->second;
    const scene::JointLaw& law = joint < 0 ? scene.default_joint : scene.joints[at(joint)].law;
    const double bonded = law.bonded_length_m ? std::min(1.0, *law.bonded_length_m / trace.length_m) : 1;
    for (const scene::TracePiece& piece : trace.pieces) faces.push_back(face_of(piece, a, b, joint, law, bonded));
    for (const Face& corner : bodies.corners(a, b, joint, law)) faces.push_back(corner);
  }
  return faces;
}

/// Ends that move as far as a failure, and no farther, leave a bolt this force at least [N/m].
double least_force(const scene::Scene& scene, const scene::Bolt& bolt) {
  const auto moves = [&](int block) { return block >= 0 && !scene.blocks[at(block)].fixed; };
  const double shortening_m = static_cast<double>(std::count_if(bolt.blocks.begin(), bolt.blocks.end(), moves)) *
                              scene.analysis.failure_displacement_m;
  const double slack = bolt.takes_compression ? -bolt.yield_n_per_m.value_or(infinite) : 0;
  return std::max(slack, bolt.prestress_n_per_m - bolt.stiffness_n_per_m2 * shortening_m);
}

std::vector<Tie> ties_of(const scene::Scene& scene) {
  std::vector<Tie> ties;
  const auto is_fixed = [&](int block) { return block < 0 || scene.blocks[at(block)].fixed; };
  for (const scene::Support& support : scene.supports) {
    const auto hold = [&](const Point& direction) {
      ties.push_back({.a = support.block,
                      .at_a_m = support.point_m,
                      .at_b_m = support.point_m,
                      .direction = direction,
                      .low_n_per_m = -infinite,
                      .high_n_per_m = infinite});
    };
    if (support.displacement_x_m) hold(Point::UnitX());
    if (support.displacement_y_m) hold(Point::UnitY());
  }
  for (const scene::ViscousFace& face : scene.viscous_faces) {
    for (const Point& end : {face.from_m, face.to_m}) {
      for (const Point& direction : {Point(Point::UnitX()), Point(Point::UnitY())}) {
        if (face.is_side() && direction.y() != 0) continue;
        ties.push_back({.a = face.block,
                        .at_a_m = end,
                        .at_b_m = end,
                        .direction = direction,
                        .low_n_per_m = -infinite,
                        .high_n_per_m = infinite});
      }
    }
  }
  for (const scene::Bolt& bolt : scene.bolts) {
    Tie tie{.a = bolt.blocks[0],
            .b = bolt.blocks[1],
            .at_a_m = bolt.from_m,
            .at_b_m = bolt.to_m,
            .direction = (bolt.to_m - bolt.from_m).normalized(),
            .high_n_per_m = bolt.yield_n_per_m.value_or(infinite)};
    tie.low_n_per_m = least_force(scene, bolt);
    if (tie.a < 0) {
      std::swap(tie.a, tie.b);
      std::swap(tie.at_a_m, tie.at_b_m);
      tie.direction = -tie.direction;
    }
    ties.push_back(tie);
  }
  std::erase_if(ties, [&](const Tie& tie) { return is_fixed(tie.a) && is_fixed(tie.b); });
  return ties;
}

}  // namespace blockweir::solid::limit
