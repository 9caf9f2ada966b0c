// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step bridge_scene_read
// Dams with a mesh on rock that joints cut, many of whose contacts are redundant: the start of all formulations.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bridge/scene/at.hpp"
#include "bridge/scene/read/read.hpp"
#include "tests/verification/campaign.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::solid::jointed_rock_test {
namespace {

constexpr const char* dam_and_rock = R"(
[analysis]
duration_s = 1
step_s = 0.01
[contact]
formulation = "{0}"
[material.concrete]
youngs_modulus_pa = 25e9
poissons_ratio = 0.2
density_kg_per_m3 = 2400
[material.rock]
youngs_modulus_pa = 40e9
poissons_ratio = 0.25
density_kg_per_m3 = 2650
[joint]
friction_angle_deg = 45
[section]
material = "rock"
outline_m = [[-20, -15], [50, -15], [50, 0], [-20, 0]]
[[region]]
material = "rock"
fixed = true
outline_m = [[-20, -15], [50, -15], [50, -12], [-20, -12]]
[[joint_set]]
name = "bedding"
dip_deg = {1}
spacing_m = {2}
offset_m = 1
[[joint_set]]
name = "steep"
dip_deg = {3}
spacing_m = {4}
offset_m = 1
persistence = {5}
trace_length_m = 8
seed = {6}
[[block]]
name = "base"
material = "concrete"
vertices_m = [[0, 0], [15.5, 0], [9.4175, 11.6361], [0, 15]]
mesh_size_m = {7}
[[block]]
name = "top"
material = "concrete"
vertices_m = [[0, 15], [9.4175, 11.6361], [4, 22], [0, 22]]
mesh_size_m = {7}
[[joints]]
name = "crack"
between = ["base", "top"]
[[face_pressure]]
block = "base"
from_m = [0, 0]
to_m = [0, 15]
pressure_from_pa = {8}
pressure_to_pa = {9}
)";

std::string dam_on_rock(test::Random& random, const std::string& formulation) {
  const double water = random.between(15, 20);
  const double dip = random.between(-25, 25);
  const double spacing = random.between(3, 6);
  const double steep_dip = (random.between(0, 1) < 0.5 ? -1 : 1) * random.between(60, 85);
  const double steep_spacing = random.between(4, 8);
  const double persistence = random.between(0.6, 1);
  const int seed = random.integer(1, 1000);
  const double mesh_size = random.between(2, 4);
  return fmt::format(dam_and_rock, formulation, dip, spacing, steep_dip, steep_spacing, persistence, seed, mesh_size,
                     9810 * water, 9810 * (water - 15));
}

/// What acts from above on blocks that do not move.
double held_by_what_is_fixed(const Solid& solid) {
  double sum = 0;
  for (const ContactPoint& c : solid.contacts()) {
    const bool vertex_fixed = solid.blocks()[at(c.vertex_part)].fixed;
    if (c.state == ContactState::open || vertex_fixed == solid.blocks()[at(c.edge_part)].fixed) continue;
    const Point span = solid.placements()[at(c.edge_part)].vector(c.edge_to - c.edge_from).normalized();
    const Point on_vertex = c.force.x() * Point(span.y(), -span.x()) + c.force.y() * span;
    sum += (vertex_fixed ? -1 : 1) * on_vertex.y();
  }
  return sum;
}

TEST(JointedRock, ItsRedundantContactsSettleWithLagrangeMultipliers) {
  for (int seed = 1; seed <= test::campaign(2); ++seed) {
    test::Random random(static_cast<unsigned>(seed));
    const auto read = scene::read_text(dam_on_rock(random, "lagrange-multiplier"), "rock.toml");
    Solid solid(read.scene);
    ASSERT_NO_THROW(solid.settle({})) << "seed " << seed;
    double weight = 0;
    for (std::size_t b = 0; b < solid.described(); ++b) {
      const Block& block = solid.blocks()[b];
      if (!block.fixed) weight += block.mass_per_m() * 9.81;
    }
    EXPECT_NEAR(held_by_what_is_fixed(solid) / weight, 1, 1e-6) << "seed " << seed;
    ASSERT_NO_THROW(run(solid, 0.05)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace blockweir::solid::jointed_rock_test
