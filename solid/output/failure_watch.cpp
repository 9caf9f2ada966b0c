// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/failure_watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace blockweir::solid::output {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

FailureWatch::FailureWatch(const Solid& solid) : solid_(solid), rest_(solid.blocks().size()) {}

double FailureWatch::speed(std::size_t b) const {
  double fastest = 0;
  for (const Point& X : solid_.blocks()[b].vertices) {
    fastest = std::max(fastest, (solid_.placements()[b].shape(X) * solid_.states()[b].velocity).norm());
  }
  return fastest;
}

/// Farthest that a vertex has come since the block's last rest [m].
double FailureWatch::travel(std::size_t b) const {
  const Placement then(solid_.blocks()[b].centroid, rest_[b].displacement);
  double farthest = 0;
  for (const Point& X : solid_.blocks()[b].vertices) {
    farthest = std::max(farthest, (solid_.placements()[b].position(X) - then.position(X)).norm());
  }
  return farthest;
}

/// A contact that sticks and another that is closed, elsewhere, leave a block no rigid motion of its own: it strains,
/// or is carried.
bool FailureWatch::held(std::size_t b) const {
  const auto point = [&](const ContactPoint& c) -> Point {
    const auto v = at(c.vertex_block);
    return solid_.placements()[v].position(solid_.blocks()[v].vertices[at(c.vertex)]);
  };
  const auto closed = [&](const ContactPoint& c) {
    return c.state != ContactState::open && (at(c.vertex_block) == b || at(c.edge_block) == b);
  };
  const auto& contacts = solid_.contacts();
  const auto sticking = std::find_if(contacts.begin(), contacts.end(), [&](const ContactPoint& c) {
    return closed(c) && c.state == ContactState::stick;
  });
  if (sticking == contacts.end()) return false;
  const Point pivot = point(*sticking);
  const double elsewhere = 1e-3 * solid_.blocks()[b].radius;
  return std::any_of(contacts.begin(), contacts.end(),
                     [&](const ContactPoint& c) { return closed(c) && (point(c) - pivot).norm() > elsewhere; });
}

bool FailureWatch::at_rest(std::size_t b) const {
  constexpr double straining = 100;  // speeds of loads that come fast, far below those of a block that is carried away
  const double rest = solid_.scene().analysis.rest_speed_m_per_s;
  const double fastest = speed(b);
  return fastest <= rest || (fastest <= straining * rest && held(b));
}

void FailureWatch::look(double time_s, double upstream_level_m) {
  const scene::Analysis& analysis = solid_.scene().analysis;
  for (std::size_t b = 0; b < rest_.size(); ++b) {
    if (solid_.blocks()[b].fixed || rest_[b].failed) continue;
    if (at_rest(b) || time_s == 0) {
      rest_[b] = {.time_s = time_s, .level_m = upstream_level_m, .displacement = solid_.states()[b].displacement};
    } else if (travel(b) > analysis.failure_displacement_m) {
      rest_[b].failed = true;
      failures_.push_back(describe(b));
    }
  }
  std::stable_sort(failures_.begin(), failures_.end(),
                   [](const auto& a, const auto& b) { return a.time_s < b.time_s; });
  if (failures_.empty()) update_margins(time_s, upstream_level_m);
}

/// Of the neighbours that do not come along, the one whose joint begins farthest upstream; blocks that had no joint
/// with this one count when they touch it now. -1 when there is none.
int FailureWatch::neighbour_left_behind(std::size_t b) const {
  int farthest = -1;
  double farthest_x = 0;
  for (const ContactPoint& c : solid_.contacts()) {
    const bool is_vertex = at(c.vertex_block) == b;
    if (!is_vertex && at(c.edge_block) != b) continue;
    const int other = is_vertex ? c.edge_block : c.vertex_block;
    if (!solid_.blocks()[at(other)].fixed && speed(at(other)) >= speed(b) / 2) continue;
    const auto trace = joint_trace(b, at(other));
    if (trace.pieces.empty() && c.state == ContactState::open) continue;
    const double x = trace.pieces.empty() ? std::numeric_limits<double>::max() : trace.mouth().x();
    if (farthest >= 0 && x >= farthest_x) continue;
    farthest = other;
    farthest_x = x;
  }
  return farthest;
}

scene::JointTrace FailureWatch::joint_trace(std::size_t a, std::size_t b) const {
  const auto& blocks = solid_.scene().blocks;
  return scene::trace_joint(blocks[a], blocks[b], 1e-6 * solid_.size_m());
}

Failure FailureWatch::describe(std::size_t b) const {
  Failure failure{.block = static_cast<int>(b), .time_s = rest_[b].time_s, .level_m = rest_[b].level_m, .head_m = nan};
  const double turned =
      std::abs(solid_.states()[b].displacement[2] - rest_[b].displacement[2]) * solid_.blocks()[b].radius;
  const double share =
      turned / travel(b);  // 0: pure translation; a block that turns about its toe has about 1/2 or more
  const int other = neighbour_left_behind(b);
  if (other < 0) {
    failure.mode = "falling";
    return failure;
  }
  failure.mode = share < 0.1 ? "sliding" : share > 0.4 ? "overturning" : "sliding and overturning";
  failure.joint = joint_name(static_cast<int>(b), other);
  const auto trace = joint_trace(b, at(other));
  if (!trace.pieces.empty()) failure.head_m = failure.level_m - trace.mouth().y();
  return failure;
}

std::string FailureWatch::joint_name(int a, int b) const {
  const scene::Scene& scene = solid_.scene();
  const int joint = solid_.laws()[solid_.laws().between(a, b)].joint;
  return joint >= 0 ? scene.joints[at(joint)].name : scene.blocks[at(a)].name + " on " + scene.blocks[at(b)].name;
}

namespace {

/// What the contacts of one joint bear together.
struct JointSum {
  double strength = 0;
  double shear = 0;
  double normal = 0;
  Point moment = Point::Zero();  ///< sum of normal force times place
  Point low = Point::Zero();     ///< ends of the joint, as far as contacts reach
  Point high = Point::Zero();

  void add(const ContactPoint& c, const JointProperties& law, const Point& place) {
    if (normal == 0 && strength == 0 && low.isZero() && high.isZero()) low = high = place;
    const auto before = [](const Point& p, const Point& q) { return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y(); };
    if (before(place, low)) low = place;
    if (before(high, place)) high = place;
    if (c.state == ContactState::open) return;
    strength +=
        c.bonded ? law.cohesion_pa * c.bond_length + c.force.x() * law.friction : c.force.x() * law.residual_friction;
    // Shear is counted along the edge of one block: seen from the other it keeps its sign.
    shear += c.force.y();
    normal += c.force.x();
    moment += c.force.x() * place;
  }
  /// Of the resultant from the nearer end, over the joint's length; negative outside.
  [[nodiscard]] double end_distance() const {
    const Point along = high - low;
    const double s = along.dot(moment / normal - low) / along.squaredNorm();
    return std::min(s, 1 - s);
  }
};

void keep_lowest(std::optional<FailureWatch::Margin>& lowest, const FailureWatch::Margin& now) {
  if (!lowest || now.value < lowest->value) lowest = now;
}

}  // namespace

void FailureWatch::update_margins(double time_s, double level_m) {
  constexpr double negligible = 1e-6;
  std::map<std::pair<int, int>, JointSum> joints;
  for (const ContactPoint& c : solid_.contacts()) {
    const auto v = at(c.vertex_block);
    joints[std::minmax(c.vertex_block, c.edge_block)].add(
        c, solid_.laws()[c.law], solid_.placements()[v].position(solid_.blocks()[v].vertices[at(c.vertex)]));
  }
  for (const auto& [pair, sum] : joints) {
    const auto margin = [&, &of = pair](double value) {
      return Margin{value, time_s, level_m, joint_name(of.first, of.second)};
    };
    if (std::abs(sum.shear) > negligible * (std::abs(sum.strength) + std::abs(sum.normal))) {
      keep_lowest(sliding_, margin(sum.strength / std::abs(sum.shear)));
    }
    if (sum.normal > 0 && (sum.high - sum.low).norm() > negligible * solid_.size_m()) {
      keep_lowest(overturning_, margin(sum.end_distance()));
    }
  }
}

}  // namespace blockweir::solid::output
