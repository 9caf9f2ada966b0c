// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_output
// What is said of a failure's level: of the speed of filling only where the level changes, of water only where it is to
// blame.
#include "solid/output/level_doubt.hpp"

#include <gmock/gmock.h>

#include "bridge/scene/constant_loads.hpp"

namespace blockweir::solid::output::level_doubt_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

scene::Scene filled(scene::TimeTable level) {
  scene::Scene scene;
  scene.fluid = scene::FluidModel::hydrostatic;
  scene.analysis.duration_s = 10;
  scene.water.upstream_level_m = std::move(level);
  return scene;
}
const scene::TimeTable constant{.time_s = {0}, .value = {28}};
const scene::TimeTable rises{.time_s = {0, 10}, .value = {13, 15}};

Failure slides(bool bound) {
  return {.time_s = 1,
          .level_m = 14,
          .head_m = 12,
          .bound = bound,
          .level_uncertainty_m = 0.2,
          .mode = "sliding",
          .joint = "base"};
}

TEST(LevelDoubt, OfAFillingNamesTheCommandThatFindsTheStaticLevel) {
  EXPECT_EQ(level_doubt(filled(rises), slides(false)),
            "this level depends on the speed of filling, by some 0.2 m; \"blockweir level SCENE\" finds the static "
            "level, which may differ by more, as friction depends on how the loads came: go by the lower one");
}

TEST(LevelDoubt, OfAConstantLevelIsNotOfTheSpeedOfFilling) {
  EXPECT_THAT(level_doubt(filled(constant), slides(false)), HasSubstr("another load brings the failure"));
  EXPECT_THAT(level_doubt(filled(constant), slides(true)),
              HasSubstr("under a level that does not change: \"blockweir level SCENE\""));
  scene::Scene shaken = filled(constant);
  shaken.base_motion.emplace();
  EXPECT_THAT(level_doubt(shaken, slides(false)), IsEmpty());
}

TEST(LevelDoubt, OfWhatMovesFromTheStartBlamesTheLevelOnlyWhereItMayBeTheCause) {
  EXPECT_THAT(level_doubt(filled(rises), slides(true)), HasSubstr("begin with a lower level"));
  scene::Scene shaken = filled(rises);
  shaken.base_motion.emplace();
  EXPECT_THAT(level_doubt(shaken, slides(true)), HasSubstr("while the ground shakes: a lower level may not hold it"));
  Failure falls = slides(true);
  falls.joint.clear();
  EXPECT_EQ(level_doubt(filled(rises), falls), "it falls from the start: nothing holds it where it is drawn");
  falls.mode = "lifting";
  EXPECT_THAT(level_doubt(filled(rises), falls), HasSubstr("begin with a lower level"));
}

/// Of all levels: no lower one is advised once the failed blocks lie above the water.
TEST(LevelDoubt, OfBlocksThatTheWaterDoesNotReachTheLevelIsNotToBlame) {
  scene::Scene scene = filled(rises);
  scene.blocks.resize(2);
  scene.blocks[0].vertices = {{0, 0}, {3, 0}, {3, 2}, {0, 2}};
  scene.blocks[1].vertices = {{0, 2}, {3, 2}, {3, 4}, {0, 4}};
  Failure failure = slides(true);
  for (const double level_m : {-5.0, 0.0, 1.0, 2.0, 3.0, 5.0}) {
    failure.level_m = level_m;
    failure.blocks = {1};
    EXPECT_EQ(level_doubt(scene, failure).find("begin with a lower level") == std::string::npos, level_m <= 2)
        << level_m;
    failure.blocks = {0, 1};
    EXPECT_EQ(level_doubt(scene, failure).find("begin with a lower level") == std::string::npos, level_m <= 0)
        << level_m;
  }
  failure.level_m = 1;
  failure.blocks = {1};
  EXPECT_THAT(level_doubt(scene, failure), HasSubstr("the water lies below it"));
}

TEST(ConstantLoads, ChangeWithALevelALoadASupportAndAGroundThatShakes) {
  EXPECT_TRUE(scene::loads_are_constant(filled(constant)));
  EXPECT_FALSE(scene::loads_are_constant(filled(rises)));
  scene::Scene pushed = filled(constant);
  pushed.point_loads.push_back({.force_x_n_per_m = rises, .force_y_n_per_m = constant});
  EXPECT_FALSE(scene::loads_are_constant(pushed));
  EXPECT_TRUE(scene::level_is_constant(pushed, false));
  EXPECT_FALSE(scene::level_is_constant(pushed, true)) << "no such pool";
  scene::Scene moved = filled(constant);
  moved.supports.push_back({.displacement_x_m = rises});
  EXPECT_FALSE(scene::loads_are_constant(moved));
  scene::Scene shaken = filled(constant);
  shaken.base_motion.emplace();
  EXPECT_FALSE(scene::loads_are_constant(shaken));
}

}  // namespace
}  // namespace blockweir::solid::output::level_doubt_test
