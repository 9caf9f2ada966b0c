// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/mobility.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "bridge/scene/at.hpp"
#include "solid/solve/symmetric_modes.hpp"

namespace blockweir::solid {
namespace {

constexpr int most_bodies = 12;       ///< that are looked at together
constexpr double free_motion = 1e-6;  ///< square of the largest violation of a motion that counts as free, rows being 1

/// One direction in which two bodies cannot move against each other, or only to one side.
struct Hold {
  int of = 0;  ///< body
  int on = 0;
  Point at;                    ///< m
  Point direction;             ///< of unit length
  bool both = true;            ///< holds to both sides; else velocities of `of` against `on` along `direction` are free
  double radius_m = 0;         ///< of the smaller of the two blocks
  const Bolt* bolt = nullptr;  ///< that holds here
  double weight = 1;           ///< of its row: less for a spring that gives way
};

/// Bodies: blocks joined so far. All blocks at rest form one of them.
class Bodies {
 public:
  explicit Bodies(std::size_t blocks) : parent_(blocks + 1) { std::iota(parent_.begin(), parent_.end(), 0); }
  [[nodiscard]] int standing() const { return static_cast<int>(parent_.size()) - 1; }
  [[nodiscard]] int of(int block) {
    int body = block;
    while (parent_[at(body)] != body) body = parent_[at(body)] = parent_[at(parent_[at(body)])];
    return body;
  }
  void join(int a, int b) { parent_[at(of(a))] = of(b); }

 private:
  std::vector<int> parent_;
};

/// Rates (u, v, turn times size) of a body about `origin`, as they move the hold's point along its direction.
Eigen::RowVector3d row(const Hold& hold, const Point& origin, double size) {
  const Point arm = (hold.at - origin) / size;
  return hold.weight * Eigen::RowVector3d(hold.direction.x(), hold.direction.y(),
                                          arm.x() * hold.direction.y() - arm.y() * hold.direction.x());
}

/// Motions of `bodies` that no hold to both sides stops: columns, of unit length.
Eigen::MatrixXd free_motions(const Eigen::MatrixXd& stopped) {
  const SymmetricModes modes = symmetric_modes(stopped.transpose() * stopped);
  Eigen::Index free = 0;
  while (free < modes.values.size() && modes.values[free] < free_motion) ++free;
  return modes.vectors.leftCols(free);
}

/// A single motion that slips one way here and the other way there is stopped by one-sided holds.
bool stopped_both_ways(const Eigen::VectorXd& rates) {
  const double tolerance = std::sqrt(free_motion);
  return rates.size() > 0 && rates.maxCoeff() > tolerance && rates.minCoeff() < -tolerance;
}

/// What the bodies that these holds name can do, the standing one excepted: true for each that no free motion moves.
/// Points nearer to each other than some thousandth of a block's radius hold no turn: a toe that presses on a corner
/// has two contacts as far apart as these are pressed in.
std::map<int, bool> held_bodies(const std::vector<Hold>& holds, int standing) {
  std::map<int, Eigen::Index> column;
  Point origin = Point::Zero();
  for (const Hold& hold : holds) {
    origin += hold.at / static_cast<double>(holds.size());
    for (const int body : {hold.of, hold.on}) {
      if (body != standing) column.try_emplace(body, 3 * static_cast<Eigen::Index>(column.size()));
    }
  }
  double size = 0;
  for (const Hold& hold : holds) size = std::max({size, hold.radius_m, (hold.at - origin).norm()});
  const auto both = std::count_if(holds.begin(), holds.end(), [](const Hold& h) { return h.both; });
  const auto unknowns = 3 * static_cast<Eigen::Index>(column.size());
  Eigen::MatrixXd stopped = Eigen::MatrixXd::Zero(both, unknowns);
  Eigen::MatrixXd one_way = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(holds.size()) - both, unknowns);
  Eigen::Index i = 0;
  Eigen::Index j = 0;
  for (const Hold& hold : holds) {
    auto line = hold.both ? stopped.row(i++) : one_way.row(j++);
    if (hold.of != standing) line.segment<3>(column[hold.of]) += row(hold, origin, size);
    if (hold.on != standing) line.segment<3>(column[hold.on]) -= row(hold, origin, size);
  }
  Eigen::MatrixXd motions = free_motions(stopped);
  if (motions.cols() == 1 && stopped_both_ways(one_way * motions)) motions.resize(unknowns, 0);
  std::map<int, bool> held;
  for (const auto& [body, first] : column) {
    held[body] = motions.cols() == 0 || motions.middleRows<3>(first).cwiseAbs().maxCoeff() < 1e-6;
  }
  return held;
}

/// A spring does not constrain a motion that changes its compression by less than the present one within the failure
/// displacement: a block sliding on soft springs past a shallow corner keeps its toe on them.
double weight_of(const Solid& solid, const ContactPoint& c) {
  const double unheld = std::max(0.0, -c.gap) / solid.scene().analysis.failure_displacement_m;
  return std::sqrt(free_motion) / std::max(unheld, std::sqrt(free_motion));
}

void hold(const Solid& solid, const ContactPoint& c, std::vector<Hold>& holds) {
  const Placement& edge = solid.placements()[at(c.edge_part)];
  const Point t = edge.vector(c.edge_to) - edge.vector(c.edge_from);
  const Point along = t / t.norm();
  const auto radius = [&](int block) { return solid.blocks()[at(block)].radius; };
  const auto add = [&](const Point& direction, bool both) {
    const double smaller_m = std::min(radius(c.vertex_block), radius(c.edge_block));
    holds.push_back({c.vertex_block, c.edge_block, solid.state().place(c), direction, both, smaller_m});
  };
  add(perpendicular(along), true);
  holds.back().weight = weight_of(solid, c);
  if (c.state == ContactState::stick && !c.slid) {
    add(along, true);
  } else if (c.state == ContactState::slip && c.force.y() != 0) {
    add(c.force.y() < 0 ? along : Point(-along), false);
  }
}

/// A bolt below its yield stops its stretch.
void hold(const Solid& solid, const Bolt& bolt, std::vector<Hold>& holds) {
  if (bolt.acting.state != BoltState::elastic) return;
  const auto end = [&](std::size_t k) -> Point {
    const int part = bolt.part[k];
    if (part >= 0) return solid.placements()[at(part)].position(bolt.material[k]);
    return bolt.material[k] + solid.model().base.displacement(solid.time_s());
  };
  const auto [a, b] = bolt.described->blocks;
  const std::size_t held = a >= 0 ? 0 : 1;
  const Point along = (end(0) - end(1)).normalized();
  const int of = bolt.described->blocks[held];
  holds.push_back({of, held == 0 ? b : a, end(held), along, true, solid.blocks()[at(of)].radius, &bolt});
}

/// Rate of the six unknowns, against the base.
Vector6 rate(const Solid& solid, int part) {
  Vector6 velocity = solid.velocity(at(part));
  velocity.head<2>() -= solid.model().base.velocity(solid.time_s());
  return velocity;
}

/// Rate at which the bolt stretches [m/s].
double stretch_rate(const Solid& solid, const Bolt& bolt, const Point& along) {
  std::array<Point, 2> velocity{Point::Zero(), Point::Zero()};
  for (std::size_t k = 0; k < 2; ++k) {
    const int part = bolt.part[k];
    if (part >= 0) velocity[k] = solid.placements()[at(part)].shape(bolt.material[k]) * rate(solid, part);
  }
  return along.dot(velocity[0] - velocity[1]);
}

/// Bolts hold a group if they can stop it: at its present rates they would store more than its kinetic energy within
/// the failure displacement.
bool bolts_support(const Solid& solid, const std::vector<Hold>& group, int standing) {
  std::set<int> blocks;
  std::map<const Bolt*, double> rates;
  for (const Hold& h : group) {
    blocks.insert({h.of, h.on});
    if (h.bolt != nullptr) rates[h.bolt] = stretch_rate(solid, *h.bolt, h.direction);
  }
  blocks.erase(standing);
  double kinetic = 0;  // J/m
  double fastest = 0;  // m/s
  for (const int b : blocks) {
    const Block& block = solid.blocks()[at(b)];
    const Vector6 velocity = rate(solid, b);
    kinetic += velocity.dot(block.inertia * velocity) / 2;
    for (const Point& X : block.vertices) {
      fastest = std::max(fastest, (solid.placements()[at(b)].shape(X) * velocity).norm());
    }
  }
  if (fastest == 0) return true;
  const double passed_s = solid.scene().analysis.failure_displacement_m / fastest;
  double stored = 0;  // J/m
  for (const auto& [bolt, rate_m_per_s] : rates) {
    stored += bolt->described->stiffness_n_per_m2 * std::pow(rate_m_per_s * passed_s, 2) / 2;
  }
  return kinetic < stored;
}

/// Holds of contacts, supports and bolts at which what moves is involved, by blocks; -1 for the ground.
std::vector<Hold> holds_of(const Solid& solid, const std::vector<bool>& moves) {
  std::vector<Hold> holds;
  for (const ContactPoint& c : solid.contacts()) {
    if (c.state != ContactState::open && (moves[at(c.vertex_block)] || moves[at(c.edge_block)])) hold(solid, c, holds);
  }
  for (const scene::Support& s : solid.scene().supports) {
    if (!moves[at(s.block)]) continue;
    const Block& block = solid.blocks()[at(s.block)];
    const Point place = solid.placements()[at(s.block)].position(s.point_m - block.centroid);
    if (s.displacement_x_m) holds.push_back({s.block, -1, place, Point::UnitX(), true, block.radius});
    if (s.displacement_y_m) holds.push_back({s.block, -1, place, Point::UnitY(), true, block.radius});
  }
  for (const scene::ViscousFace& face : solid.scene().viscous_faces) {
    if (!moves[at(face.block)]) continue;
    const Block& block = solid.blocks()[at(face.block)];
    for (const Point& end : {face.from_m, face.to_m}) {
      const Point place = solid.placements()[at(face.block)].position(end - block.centroid);
      holds.push_back({face.block, -1, place, Point::UnitX(), true, block.radius});
      holds.push_back({face.block, -1, place, Point::UnitY(), true, block.radius});
    }
  }
  for (const Bolt& bolt : solid.bolts()) {
    const auto [a, b] = bolt.described->blocks;
    if ((a >= 0 && moves[at(a)]) || (b >= 0 && moves[at(b)])) hold(solid, bolt, holds);
  }
  return holds;
}

/// Bodies that their holds connect, the standing one connecting nothing; each group's holds.
std::vector<std::vector<Hold>> groups_of(const std::vector<Hold>& holds, std::size_t blocks, int standing) {
  Bodies connected(blocks);
  for (const Hold& h : holds) {
    if (h.of != standing && h.on != standing) connected.join(h.of, h.on);
  }
  std::map<int, std::vector<Hold>> groups;
  for (const Hold& h : holds) groups[connected.of(h.of != standing ? h.of : h.on)].push_back(h);
  std::vector<std::vector<Hold>> list;
  for (auto& [body, group] : groups) list.push_back(std::move(group));
  return list;
}

/// Leaves out bolts that cannot stop what moves.
void leave_out_bolts(const Solid& solid, int standing, std::vector<Hold>& holds) {
  std::vector<Hold> kept;
  for (std::vector<Hold>& group : groups_of(holds, solid.described(), standing)) {
    if (!bolts_support(solid, group, standing)) std::erase_if(group, [](const Hold& h) { return h.bolt != nullptr; });
    kept.insert(kept.end(), group.begin(), group.end());
  }
  holds = std::move(kept);
}

/// Joins each two bodies that have no rigid motion against each other; true while there are any.
bool join_pairs(std::vector<Hold>& holds, Bodies& bodies) {
  const auto pair = [](const Hold& h) { return std::minmax(h.of, h.on); };
  std::sort(holds.begin(), holds.end(), [&](const Hold& a, const Hold& b) { return pair(a) < pair(b); });
  bool joined = false;
  for (auto first = holds.begin(), end = first; first != holds.end(); first = end) {
    end = std::find_if(first, holds.end(), [&](const Hold& h) { return pair(h) != pair(*first); });
    if (std::distance(first, end) < 3) continue;
    const auto [low, high] = std::pair(std::min(first->of, first->on), std::max(first->of, first->on));
    if (bodies.of(low) == bodies.of(high)) continue;
    if (!held_bodies({first, end}, high).at(low)) continue;
    bodies.join(low, high);
    joined = true;
  }
  return joined;
}

/// Names bodies instead of blocks, and leaves out what two parts of one body hold.
void rename(std::vector<Hold>& holds, Bodies& bodies) {
  for (Hold& h : holds) h.of = bodies.of(h.of), h.on = bodies.of(h.on);
  std::erase_if(holds, [](const Hold& h) { return h.of == h.on; });
}

}  // namespace

Mobility mobility(const Solid& solid, const std::vector<bool>& moves) {
  Mobility found{std::vector<bool>(moves.size(), false), std::vector<bool>(moves.size(), false)};
  if (std::find(moves.begin(), moves.end(), true) == moves.end()) return found;
  Bodies bodies(moves.size());
  const int standing = bodies.standing();
  std::vector<Hold> holds = holds_of(solid, moves);
  for (Hold& h : holds) {
    if (!moves[at(h.of)]) h.of = standing;
    if (h.on < 0 || !moves[at(h.on)]) h.on = standing;
  }
  if (!solid.bolts().empty()) leave_out_bolts(solid, standing, holds);
  while (join_pairs(holds, bodies)) rename(holds, bodies);
  std::set<int> unknown;
  for (const std::vector<Hold>& group : groups_of(holds, moves.size(), bodies.of(standing))) {
    std::set<int> together;
    for (const Hold& h : group) together.insert({h.of, h.on});
    if (together.size() > most_bodies + 1) {
      unknown.merge(together);
      continue;
    }
    for (const auto& [body, is_held] : held_bodies(group, bodies.of(standing))) {
      if (is_held) bodies.join(body, standing);
    }
  }
  for (std::size_t b = 0; b < moves.size(); ++b) {
    const int body = bodies.of(static_cast<int>(b));
    found.only_strains[b] = moves[b] && body == bodies.of(standing);
    found.unknown[b] = moves[b] && body != bodies.of(standing) && unknown.contains(body);
  }
  return found;
}

}  // namespace blockweir::solid
