// SPDX-License-Identifier: GPL-3.0-or-later
// Figures from the first and last frames of a run, and from what was watched on the way.

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bridge/geometry/polygon.hpp"
#include "solid/expect/quantity_tables.hpp"

namespace blockweir::solid::expect {
namespace {

template <double Failure::*Member>
double of_failure(const Outcome& o, const std::string& subject) {
  const Failure* failure = failure_of(o, subject);
  if (failure == nullptr) throw NoFigure(subject.empty() ? "no failure" : "no failure of " + subject);
  return failure->*Member;
}

/// Against the base.
double displacement(const Outcome& o, const std::string& subject) {
  const std::size_t b = block_index(o.solid, subject);
  return (o.last.blocks[b].centroid_m - o.first.blocks[b].centroid_m - o.last.base_displacement_m).norm();
}

double acceleration(const Outcome& o, const std::string& subject) {
  constexpr double still = 1e-9;  // of the model
  if (displacement(o, subject) <= still * o.solid.model().size_m)
    throw NoFigure("no motion: the block stays where it is");
  return o.acceleration.of(block_index(o.solid, subject));
}

/// Vertical force of all contacts on a block, upwards on its neighbours.
double reaction(const Outcome& o, const std::string& subject) {
  const auto b = static_cast<int>(block_index(o.solid, subject));
  double sum = 0;
  for (const ContactRow& c : o.last.contacts) {
    const Point tangent(-c.normal.y(), c.normal.x());
    const double up = (c.normal_force_n_per_m * c.normal + c.shear_force_n_per_m * tangent).y();
    if (c.edge_block == b) sum += up;
    if (c.vertex_block == b) sum -= up;
  }
  return sum;
}

/// Sum of the normal forces on a joint of that name.
double joint_force(const Outcome& o, const std::string& subject) {
  const auto& joints = o.solid.scene().joints;
  const auto joint =
      std::find_if(joints.begin(), joints.end(), [&](const scene::Joint& j) { return j.name == subject; });
  if (joint == joints.end()) throw std::runtime_error("[[expect]] of = \"" + subject + "\" names no joint");
  double sum = 0;
  for (const ContactRow& c : o.last.contacts) {
    if (c.joint == joint - joints.begin()) sum += c.normal_force_n_per_m;
  }
  return sum;
}

double stress_yy(const Outcome& o, const std::string& subject) {
  return o.last.blocks[block_index(o.solid, subject)].stress_yy_pa;
}

/// Loss of height between the block's lowest and highest vertex, from its strain: positions would lose digits.
double shortening(const Outcome& o, const std::string& subject) {
  const std::size_t b = block_index(o.solid, subject);
  const auto& vertices = o.solid.blocks()[b].vertices;
  const auto by_height = [](const Point& p, const Point& q) { return p.y() < q.y(); };
  const auto [low, high] = std::minmax_element(vertices.begin(), vertices.end(), by_height);
  return -o.solid.states()[b].displacement[4] * (high->y() - low->y());
}

double water_force_x(const Outcome& o, const std::string& subject) {
  return o.last.blocks[block_index(o.solid, subject)].water_force_n_per_m.x();
}
double water_moment(const Outcome& o, const std::string& subject) {
  return o.last.blocks[block_index(o.solid, subject)].water_moment_n;
}
double penetration(const Outcome& o, const std::string&) {
  return o.largest_penetration_m;
}

/// Largest water pressure on the block.
double water_pressure(const Outcome& o, const std::string& subject) {
  const auto b = static_cast<int>(block_index(o.solid, subject));
  double largest = 0;
  for (const PanelRow& p : o.last.panels) {
    if (p.block == b) largest = std::max({largest, p.pressure_from_pa, p.pressure_to_pa});
  }
  return largest;
}

double stress_xx(const Outcome& o, const std::string& subject) {
  return o.last.blocks[block_index(o.solid, subject)].stress_xx_pa;
}
double stress_xy(const Outcome& o, const std::string& subject) {
  return o.last.blocks[block_index(o.solid, subject)].stress_xy_pa;
}
double kinetic_energy(const Outcome& o, const std::string&) {
  return energy_of(o.solid).kinetic;
}
double energy_gain(const Outcome& o, const std::string&) {
  return o.energy.gain();
}

/// Change of the block's area by more than its strain says.
double area_error(const Outcome& o, const std::string& subject) {
  const std::size_t b = block_index(o.solid, subject);
  const auto strain = o.solid.states()[b].displacement.tail<3>();
  const double strained = (1 + strain[0]) * (1 + strain[1]) - strain[2] * strain[2] / 4;
  return std::abs(geometry::signed_area(o.last.blocks[b].vertices_m) / (o.solid.blocks()[b].area * strained) - 1);
}

const BoltRow& bolt_named(const Outcome& o, const std::string& name) {
  const auto& bolts = o.solid.scene().bolts;
  for (std::size_t k = 0; k < bolts.size(); ++k) {
    if (bolts[k].name == name) return o.last.bolts.at(k);
  }
  throw std::runtime_error("[[expect]] of = \"" + name + "\" names no bolt");
}
double bolt_force_now(const Outcome& o, const std::string& subject) {
  return bolt_named(o, subject).force_n_per_m;
}
double bolt_elongation(const Outcome& o, const std::string& subject) {
  return bolt_named(o, subject).elongation_m;
}

/// Are two blocks in contact, and at one end of their joint only: within `reach` of one point?
bool is_hinge(const Outcome& o, const std::string& a, const std::string& b, double reach) {
  const auto joint =
      std::minmax({static_cast<int>(block_index(o.solid, a)), static_cast<int>(block_index(o.solid, b))});
  std::vector<Point> closed;
  for (const ContactRow& c : o.last.contacts) {
    if (c.state != 0 && std::minmax({c.vertex_block, c.edge_block}) == joint) closed.push_back(c.point_m);
  }
  const auto near = [&](const Point& p) { return (p - closed.front()).norm() < reach; };
  return !closed.empty() && std::all_of(closed.begin(), closed.end(), near);
}

/// Joints of an arch, springings included, that bear at one end only.
double hinges(const Outcome& o, const std::string& subject) {
  if (o.failure.failures().empty()) throw NoFigure("no mechanism: the arch stands");
  const scene::Scene& s = o.solid.scene();
  const auto arch = std::find_if(s.arches.begin(), s.arches.end(), [&](const auto& a) { return a.name == subject; });
  if (arch == s.arches.end()) throw std::runtime_error("[[expect]] of = \"" + subject + "\" names no arch");
  std::vector<std::string> ring;
  for (int i = 1; i <= arch->voussoirs; ++i) ring.push_back(subject + std::to_string(i));
  const auto is_block = [&](const std::string& name) {
    return std::any_of(s.blocks.begin(), s.blocks.end(), [&](const auto& b) { return b.name == name; });
  };
  if (is_block(subject + "-left")) ring.insert(ring.begin(), subject + "-left");
  if (is_block(subject + "-right")) ring.push_back(subject + "-right");
  double count = 0;
  for (std::size_t i = 1; i < ring.size(); ++i) count += is_hinge(o, ring[i - 1], ring[i], arch->thickness_m / 2);
  return count;
}

}  // namespace

const Quantities& state_quantities() {
  static const Quantities all = {{"failure_level_m", of_failure<&Failure::level_m>},
                                 {"failure_head_m", of_failure<&Failure::head_m>},
                                 {"failure_time_s", of_failure<&Failure::time_s>},
                                 {"displacement_m", displacement},
                                 {"acceleration_m_per_s2", acceleration},
                                 {"reaction_n_per_m", reaction},
                                 {"joint_force_n_per_m", joint_force},
                                 {"stress_yy_pa", stress_yy},
                                 {"shortening_m", shortening},
                                 {"water_force_x_n_per_m", water_force_x},
                                 {"water_moment_n", water_moment},
                                 {"water_pressure_pa", water_pressure},
                                 {"largest_penetration_m", penetration},
                                 {"stress_xx_pa", stress_xx},
                                 {"stress_xy_pa", stress_xy},
                                 {"kinetic_energy_j_per_m", kinetic_energy},
                                 {"energy_gain", energy_gain},
                                 {"area_error", area_error},
                                 {"bolt_force_n_per_m", bolt_force_now},
                                 {"bolt_elongation_m", bolt_elongation},
                                 {"hinges", hinges}};
  return all;
}

}  // namespace blockweir::solid::expect
