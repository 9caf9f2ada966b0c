// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic nlohmann_json::nlohmann_json bridge_scene_read
// A joint through a gallery: what is hollow bears nothing in its table.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::test::gallery_joint_test {
namespace {

TEST(GalleryJoint, ItsVoidBearsNoStress) {
  const std::string text = R"(analysis = { duration_s = 1 }
joint = { friction_angle_deg = 45 }
material.m = { youngs_modulus_pa = 20e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }
water = { upstream_level_m = 20 }
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-20, -5], [50, -5], [50, 0], [-20, 0]]
[[block]]
name = "dam"
material = "m"
vertices_m = [[0, 0], [3, 0], [3, 2], [5, 2], [5, 0], [30, 0], [6, 36], [0, 36]]
)";
  const auto row = process::safety_answer(scene::read_text(text, "gallery.toml").scene, hydrostatic::make)["joints"][0];
  EXPECT_NEAR(row["compressed_length_m"].get<double>(), 28, 1e-2);
  // By hand: area, centroid and inertia of the two faces, weight and thrust of the water about the heel.
  const double area = 28;
  const double centre = (3 * 1.5 + 25 * 17.5) / area;
  const double inertia =
      27.0 / 12 + 3 * (1.5 - centre) * (1.5 - centre) + 25.0 * 25 * 25 / 12 + 25 * (17.5 - centre) * (17.5 - centre);
  const double unit = 2400 * 9.81;
  const double normal = unit * (6 * 36 + 24 * 36 / 2.0 - 4);
  const double moment = unit * (6 * 36 * 3 + 24 * 36 / 2.0 * 14 - 4 * 4.0) + 9810 * 20.0 * 20 * 20 / 6;
  const double lever = moment / normal - centre;
  EXPECT_NEAR(row["normal_n_per_m"].get<double>() / normal, 1, 1e-6);
  EXPECT_NEAR(-row["heel_stress_pa"].get<double>() / (normal / area - normal * lever * centre / inertia), 1, 2e-3);
  EXPECT_NEAR(-row["toe_stress_pa"].get<double>() / (normal / area + normal * lever * (30 - centre) / inertia), 1,
              2e-3);
}

}  // namespace
}  // namespace blockweir::test::gallery_joint_test
