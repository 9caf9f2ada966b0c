// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// [[viscous_boundary]]: which faces it takes, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bridge/scene/viscous_ground.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_viscous_boundary_test {
using namespace blockweir::scene;
using sample::expect_error;
using sample::warnings;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

namespace {

/// A wall on rock of two blocks; further sections begin on line 25.
std::string on_rock(const std::string& sections) {
  return R"([analysis]
duration_s = 1
[material.rock]
youngs_modulus_pa = 2e10
poissons_ratio = 0.25
density_kg_per_m3 = 2600
[material.soil]
youngs_modulus_pa = 2e8
poissons_ratio = 0.3
density_kg_per_m3 = 1900
[joint]
friction_angle_deg = 40
[[block]]
name = "left"
material = "rock"
vertices_m = [[-20, -10], [0, -10], [0, 0], [-20, 0]]
[[block]]
name = "right"
material = "rock"
vertices_m = [[0, -10], [20, -10], [20, 0], [0, 0]]
[[block]]
name = "wall"
material = "rock"
vertices_m = [[-2, 0], [2, 0], [2, 5], [-2, 5]]
)" + sections;
}

Scene scene_of(const std::string& sections) {
  return read_text(on_rock(sections), "s.toml").scene;
}

TEST(SceneViscousBoundary, TakesTheModelsBottomAndEnds) {
  const Scene scene = scene_of("[[viscous_boundary]]\n");
  ASSERT_EQ(scene.viscous_faces.size(), 4U);
  double below = 0;
  double beside = 0;
  for (const ViscousFace& face : scene.viscous_faces) {
    (face.is_side() ? beside : below) += face.length_m();
    EXPECT_EQ(face.material, 0);
    EXPECT_LT(face.normal().y(), 0.5);
    EXPECT_EQ(face.normal().x() > 0.5, face.is_side() && face.block == 1);
  }
  EXPECT_DOUBLE_EQ(below, 40);
  EXPECT_DOUBLE_EQ(beside, 20);
  EXPECT_TRUE(rests_on_viscous_ground(scene, 0));
  EXPECT_FALSE(is_viscous_ground(scene, 2));
}

TEST(SceneViscousBoundary, TakesAStatedFaceWhicheverWayItRuns) {
  for (const char* ends : {"from_m = [5, -10]\nto_m = [15, -10]\n", "from_m = [15, -10]\nto_m = [5, -10]\n"}) {
    const Scene scene = scene_of("[[viscous_boundary]]\nblock = \"left\"\n[[viscous_boundary]]\nblock = \"right\"\n" +
                                 std::string(ends) + "material = \"soil\"\n");
    const ViscousFace& face = scene.viscous_faces.back();
    EXPECT_EQ(face.normal().y(), -1);
    EXPECT_EQ(face.length_m(), 10);
    EXPECT_EQ(face.material, 1);
  }
}

TEST(SceneViscousBoundary, SaysWhatIsWrong) {
  const auto refuses = [](const std::string& section, int line, const std::vector<std::string>& words) {
    expect_error(on_rock(section), line, words);
  };
  const std::string all = "[[viscous_boundary]]\n";
  const std::string right = all + "block = \"right\"\n";
  refuses(all + "block = \"rihgt\"\n", 26, {"names no block: \"rihgt\"", "right"});
  refuses(all + "material = \"sand\"\n", 26, {"names no material: \"sand\""});
  refuses(all + "block = \"wall\"\n", 25, {"block \"wall\" has no edge on the model's bottom", "from_m and to_m"});
  refuses(right + "from_m = [0, -10]\n", 25, {"states one end of its face", "state the other end"});
  refuses(all + "from_m = [0, -10]\nto_m = [20, -10]\n", 25, {"has no \"block\""});
  refuses(right + "from_m = [0, -10]\nto_m = [20, 0]\n", 27, {"no part of one edge of block \"right\""});
  refuses(right + "from_m = [5, 0]\nto_m = [20, 0]\n", 25, {"a face that looks up", "state a lower face"});
  refuses(all + right, 26, {"covers a face that another one covers"});
  refuses(
      all +
          "[[block]]\nname = \"r\"\nmaterial = \"rock\"\nfixed = true\nvertices_m = [[30, -10], [40, -10], [35, 0]]\n" +
          all + "block = \"r\"\n",
      32, {"block \"r\" is fixed", "fixed = true"});
}

TEST(SceneViscousBoundary, BearsNoWeightWithoutASettledState) {
  std::string scene = on_rock("[[viscous_boundary]]\n");
  scene.insert(scene.find("[material.rock]"), "start = \"unstressed\"\n");
  expect_error(scene, 26, {"bears no weight", "start = \"equilibrium\""});
}

TEST(SceneViscousBoundary, BesideTheModelAWaveComesUpInOneMaterial) {
  const std::string base = "[base_motion]\nacceleration_x_m_per_s2 = 0.1\n";
  const std::string soil = "[[viscous_boundary]]\nblock = \"left\"\nmaterial = \"soil\"\n";
  expect_error(on_rock(base + soil + "[[viscous_boundary]]\nblock = \"right\"\n"), 27,
               {"materials \"soil\" and \"rock\"", "[base_motion]", "below the model only"});
  EXPECT_EQ(scene_of(soil + "[[viscous_boundary]]\nblock = \"right\"\n").viscous_faces.size(), 4U);
}

TEST(SceneViscousBoundary, WarnsOfLoadsThatMoveTheGroundForGood) {
  const auto warned = [](const std::string& load) {
    // The soil is not idle.
    return warnings(
        on_rock("[[viscous_boundary]]\nblock = \"left\"\nmaterial = \"rock\"\n[[viscous_boundary]]\nblock = "
                "\"right\"\nmaterial = \"soil\"\n" +
                load));
  };
  const auto water = [&](const std::string& level) { return warned("[water]\nupstream_level_m = " + level + "\n"); };
  // Rock: c_s = 1,754 m/s, c_p = 3,038 m/s; soil: 201 and 376 m/s. Each below 20 m and beside 10 m.
  EXPECT_THAT(water("{ from = 2, rate_per_s = 1 }"),
              ElementsAre(AllOf(StartsWith("s.toml:25: warning: the upstream level changes in the run and stays so"),
                                HasSubstr("by 5.41 mm in every second"), HasSubstr("from time 0 on"))));
  EXPECT_THAT(warned("[[point_load]]\nblock = \"wall\"\npoint_m = [0, 5]\n"
                     "force_x_n_per_m = { table = [[0, 0], [1, 1000]] }\n"),
              ElementsAre(HasSubstr("a [[point_load]] changes")));
  EXPECT_THAT(water("2"), IsEmpty());
  EXPECT_THAT(water("{ table = [[0, 2], [0.5, 3], [1, 2]] }"), IsEmpty());
}

}  // namespace
}  // namespace blockweir::scene_viscous_boundary_test
