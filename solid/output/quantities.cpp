// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace blockweir::solid::output {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Quantity = double (*)(const Outcome&, const std::string& of);

template <double Failure::*Member>
double of_first_failure(const Outcome& o, const std::string&) {
  return o.failure.failures().empty() ? nan : o.failure.failures().front().*Member;
}

double displacement(const Outcome& o, const std::string& of) {
  const std::size_t b = block_index(o, of);
  return (o.last.blocks[b].centroid_m - o.first.blocks[b].centroid_m).norm();
}

double acceleration(const Outcome& o, const std::string& of) {
  return o.acceleration.of(block_index(o, of));
}

/// Vertical force of all contacts on a block, upwards on its neighbours.
double reaction(const Outcome& o, const std::string& of) {
  const auto b = static_cast<int>(block_index(o, of));
  double sum = 0;
  for (const ContactRow& c : o.last.contacts) {
    const Point tangent(-c.normal.y(), c.normal.x());
    const double up = (c.normal_force_n_per_m * c.normal + c.shear_force_n_per_m * tangent).y();
    if (c.edge_block == b) sum += up;
    if (c.vertex_block == b) sum -= up;
  }
  return sum;
}

double stress_yy(const Outcome& o, const std::string& of) {
  return o.last.blocks[block_index(o, of)].stress_yy_pa;
}

/// Loss of height between the block's lowest and highest vertex, from its strain: positions would lose digits.
double shortening(const Outcome& o, const std::string& of) {
  const std::size_t b = block_index(o, of);
  const auto& vertices = o.solid.blocks()[b].vertices;
  const auto by_height = [](const Point& p, const Point& q) { return p.y() < q.y(); };
  const auto [low, high] = std::minmax_element(vertices.begin(), vertices.end(), by_height);
  return -o.solid.states()[b].displacement[4] * (high->y() - low->y());
}

double water_force_x(const Outcome& o, const std::string& of) {
  return o.last.blocks[block_index(o, of)].water_force_n_per_m.x();
}
double water_moment(const Outcome& o, const std::string& of) {
  return o.last.blocks[block_index(o, of)].water_moment_n;
}
double penetration(const Outcome& o, const std::string&) {
  return o.largest_penetration_m;
}

/// Largest water pressure on the block.
double water_pressure(const Outcome& o, const std::string& of) {
  const auto b = static_cast<int>(block_index(o, of));
  double largest = 0;
  for (const PanelRow& p : o.last.panels) {
    if (p.block == b) largest = std::max({largest, p.pressure_from_pa, p.pressure_to_pa});
  }
  return largest;
}

const std::map<std::string, Quantity>& quantities() {
  static const std::map<std::string, Quantity> all = {{"failure_level_m", of_first_failure<&Failure::level_m>},
                                                      {"failure_head_m", of_first_failure<&Failure::head_m>},
                                                      {"failure_time_s", of_first_failure<&Failure::time_s>},
                                                      {"displacement_m", displacement},
                                                      {"acceleration_m_per_s2", acceleration},
                                                      {"reaction_n_per_m", reaction},
                                                      {"stress_yy_pa", stress_yy},
                                                      {"shortening_m", shortening},
                                                      {"water_force_x_n_per_m", water_force_x},
                                                      {"water_moment_n", water_moment},
                                                      {"water_pressure_pa", water_pressure},
                                                      {"largest_penetration_m", penetration}};
  return all;
}

}  // namespace

std::size_t block_index(const Outcome& o, const std::string& name) {
  const auto& blocks = o.solid.blocks();
  for (const scene::Joint& joint : o.solid.scene().joints) {
    if (joint.name != name) continue;
    const auto a = static_cast<std::size_t>(joint.between[0]);
    const auto b = static_cast<std::size_t>(joint.between[1]);
    return blocks[a].centroid.y() > blocks[b].centroid.y() ? a : b;
  }
  const auto found = std::find_if(blocks.begin(), blocks.end(), [&](const Block& b) { return b.name == name; });
  if (found == blocks.end())
    throw std::runtime_error(fmt::format("of = \"{}\" names no block or joint", name));
  return static_cast<std::size_t>(found - blocks.begin());
}

std::vector<std::string> quantity_names() {
  std::vector<std::string> names;
  for (const auto& [name, function] : quantities()) names.push_back(name);
  return names;
}

double quantity(const Outcome& outcome, const scene::Expectation& expectation) {
  const auto found = quantities().find(expectation.quantity);
  if (found == quantities().end()) {
    throw std::runtime_error(fmt::format("[[expect]] names no quantity: \"{}\"", expectation.quantity));
  }
  return found->second(outcome, expectation.of);
}

}  // namespace blockweir::solid::output
