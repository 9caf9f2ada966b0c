// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_joints
// What is said of a flow that is no longer laminar: when it was, and not of what a breach has opened.
#include "fluid/joints/turbulence.hpp"

#include <gmock/gmock.h>

namespace blockweir::test::turbulence_test {
namespace {

using testing::HasSubstr;

wire::Load at_level(double level_m, bool breached) {
  wire::Load load;
  load.upstream_level_m = level_m;
  load.breached = breached;
  return load;
}

TEST(Turbulence, IsToldWithItsMomentAndNotAfterABreach) {
  scene::Scene scene;
  scene.water.upstream_level_m = scene::TimeTable{.time_s = {0, 40}, .value = {14, 18}};
  joints::Turbulence turbulence;
  EXPECT_EQ(turbulence.warning(scene), "");
  turbulence.look(at_level(17, false), 30, 900, "base");
  EXPECT_EQ(turbulence.warning(scene), "");
  turbulence.look(at_level(17.25, false), 32.5, 2000, "base");
  turbulence.look(at_level(17.5, true), 35, 1e7, "lift");
  turbulence.look(at_level(17.6, false), 36, 1e6, "lift");
  EXPECT_THAT(turbulence.warning(scene),
              HasSubstr("flow in joint \"base\" has a Reynolds number of 2e+03 at a level of "
                        "17.25 m, above 1000"));
  scene.water.upstream_level_m = scene::TimeTable::constant(17.25);
  EXPECT_THAT(turbulence.warning(scene), HasSubstr("2e+03 at 32.5 s, above 1000"));
}

}  // namespace
}  // namespace blockweir::test::turbulence_test
