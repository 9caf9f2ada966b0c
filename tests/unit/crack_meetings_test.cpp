// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic
// Where a crack ends on another, laws that know a crack's own ends alone are told of, if their pressures differ.
#include "fluid/hydrostatic/crack_meetings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fluid/hydrostatic/hydrostatic_model.hpp"

namespace blockweir::hydrostatic::crack_meetings_test {
namespace {

/// A dam that stands 4 m deep in rock; the bank upstream is a block of its own, or not there.
scene::Scene keyed_dam(bool bank) {
  scene::Scene scene;
  scene.water.open_crack_width_m = 0.01;
  scene.water.upstream_level_m = scene::TimeTable::constant(22);
  const auto add = [&](const char* name, bool fixed, std::vector<Point> vertices) {
    scene.blocks.push_back({.name = name, .vertices = std::move(vertices), .fixed = fixed});
  };
  const auto join = [&](const char* name, std::array<int, 2> between) {
    scene.joints.push_back({.name = name, .between = between, .law = {.uplift = scene::Uplift::triangular}});
  };
  add("rock", true, {{-40, -20}, {60, -20}, {60, -4}, {-40, -4}});
  add("dam", false, {{0, -4}, {22, -4}, {4, 22}, {4, 26}, {0, 26}});
  join("base", {0, 1});
  if (!bank) return scene;
  add("bank", true, {{-40, -4}, {0, -4}, {0, 0}, {-40, 0}});
  join("heel", {1, 2});
  join("under the bank", {0, 2});
  return scene;
}

std::vector<std::string> warnings(const scene::Scene& scene) {
  HydrostaticModel model(scene);
  wire::Motion motion;
  motion.displacement.own().resize(scene.blocks.size());
  motion.velocity.own().resize(scene.blocks.size());
  wire::Load load;
  model.advance(motion, 0, load);
  return model.report().warnings;
}

/// Heads by hand: of 26 m at (-40, -4), 22/62 are left at (0, -4); the crack at the heel falls from 22 m to nothing.
TEST(CrackMeetings, WithPressuresThatDifferAreToldOf) {
  EXPECT_THAT(warnings(keyed_dam(true)),
              testing::Contains(testing::AllOf(testing::HasSubstr("joint \"heel\" ends at (0, -4) m on joint"),
                                               testing::HasSubstr("has 0 kPa there, that of the other 90.5"),
                                               testing::HasSubstr("uplift = \"flow\" of both"))));
  EXPECT_THAT(warnings(keyed_dam(false)), testing::Not(testing::Contains(testing::HasSubstr("one pressure"))));
}

/// A joint of the ground alone cannot be set apart by uplift = "none".
TEST(CrackMeetings, AnEndBetweenFixedBlocksHasARemedyThatIsAccepted) {
  EXPECT_THAT(warnings(keyed_dam(true)),
              testing::Contains(testing::AllOf(testing::HasSubstr("no open water reaches the upstream end"),
                                               testing::HasSubstr("drawn as one have no joint between them"))));
}

}  // namespace
}  // namespace blockweir::hydrostatic::crack_meetings_test
