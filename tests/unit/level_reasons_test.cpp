// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers bridge_scene_read
// Why blocks that strain fail at another level than blocks that do not, in words that hold.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bridge/scene/read/read.hpp"
#include "solid/answers/found_levels.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::solid::level_reasons_test {
namespace {

using limit::Filled;
using testing::HasSubstr;
using testing::Not;

std::string reason(const scene::Scene& scene, const StaticLevel& blocks, Filled others, double others_m) {
  FoundLevels levels{.scene = scene, .limit = {}, .blocks = {}, .rigid = {}};
  levels.limit.value = limit::LimitLevel{.outcome = others, .level_m = others_m};
  levels.rigid.value = StaticLevel{.outcome = others, .level_m = others_m};
  levels.blocks.value = blocks;
  return levels.reason();
}

scene::Scene with_bonds(double cohesion_pa) {
  scene::Scene scene = scene::read_text(scene::sample::text, "s.toml").scene;
  for (scene::Joint& joint : scene.joints) joint.law.cohesion_pa = 0;
  scene.default_joint.cohesion_pa = cohesion_pa;
  return scene;
}

TEST(LevelReasons, BlocksThatStandAtEveryLevelAreNotSaidToFail) {
  const scene::Scene scene = with_bonds(0);
  const StaticLevel fails{.outcome = Filled::fails, .level_m = 3};
  EXPECT_EQ(reason(scene, fails, Filled::fails, 3.5),
            "deformation: blocks that do not strain fail at the level of limit analysis");
  EXPECT_EQ(reason(scene, fails, Filled::stands_full, 4),
            "deformation: blocks that do not strain stand at every level, as by limit analysis");
  EXPECT_EQ(reason(scene, {.outcome = Filled::stands_full, .level_m = 4}, Filled::does_not_stand_empty, 0),
            "deformation: blocks that do not strain do not stand empty, as by limit analysis");
}

TEST(LevelReasons, BondsThatBreakInTurnAreTold) {
  const scene::Scene scene = with_bonds(35e3);
  const char* in_turn = "; as blocks strain, bonds break one after the other, and limit analysis lets all act at once";
  EXPECT_THAT(reason(scene, {.outcome = Filled::does_not_stand_empty}, Filled::stands_full, 4), HasSubstr(in_turn));
  EXPECT_THAT(reason(scene, {.outcome = Filled::fails, .level_m = 3}, Filled::fails, 3.5), HasSubstr(in_turn));
  EXPECT_THAT(reason(scene, {.outcome = Filled::fails, .level_m = 3.5}, Filled::fails, 3), Not(HasSubstr(in_turn)));
}

}  // namespace
}  // namespace blockweir::solid::level_reasons_test
