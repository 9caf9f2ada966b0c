// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// What interFoam and its plugin leave out while hardly anything moves, and that the forces stay what they are.
#include "tests/openfoam.hpp"

namespace blockweir::test::openfoam_skips_test {
namespace {

using testing::HasSubstr;

class OpenFoamSkips : public OpenFoam {
 protected:
  [[nodiscard]] nlohmann::json summary(const std::string& out) const {
    return nlohmann::json::parse(text(out + "/summary.json"), nullptr, false);
  }
  /// Of the two blocks' water forces at the end, over the force on the dam.
  [[nodiscard]] double difference(const std::string& a, const std::string& b) const {
    double largest = 0;
    for (const double y : {7.5, 18.5}) {
      const Force one = water_force(a, {4, y}, 9);
      const Force two = water_force(b, {4, y}, 9);
      largest = std::max({largest, (one.force - two.force).norm() / one.force.norm(),
                          std::abs(one.moment - two.moment) / std::abs(one.moment)});
    }
    return largest;
  }
};

using Cuts = OpenFoamSkips;

/// The dam bends a little as the level rises.
TEST_F(Cuts, OfBlocksThatHaveHardlyMovedAreLeftOut) {
  const std::string more = cells(10) + set("water.upstream_level_m={table=[[0,20],[1,20.1]]}") +
                           set("analysis.duration_s=1") + set("output.checkpoint_every_s=0");
  ASSERT_EQ(run(cases + "cracked-dam-upper", "few", more), 0) << text("out");
  EXPECT_THAT(text("few/summary.json"), HasSubstr("cutting moved blocks out of cells, "));
  ASSERT_EQ(run(cases + "cracked-dam-upper", "all", more + set("fluid.move_tolerance=0")), 0) << text("out");
  const auto few = summary("few");
  const auto all = summary("all");
  EXPECT_EQ(all["counts"]["fluid_skipped_cuts"], 0);
  EXPECT_GT(few["counts"]["fluid_skipped_cuts"], 20);
  EXPECT_LT(few["counts"]["fluid_cuts"], all["counts"]["fluid_cuts"]);
  const double off = difference("few", "all");
  std::printf("blocks cut out %s times instead of %s, in %.4f s instead of %.4f s: forces differ by %.1e\n",
              few["counts"]["fluid_cuts"].dump().c_str(), all["counts"]["fluid_cuts"].dump().c_str(),
              few["profile_s"]["fluid_cut"].get<double>(), all["profile_s"]["fluid_cut"].get<double>(), off);
  EXPECT_LT(off, 1e-6);
}

class AtRest : public OpenFoamSkips {
 protected:
  static constexpr double tolerance = 1e-5;
  void compare(const std::string& more, long least) const {
    ASSERT_EQ(run(cases + "cracked-dam-upper", "steps", more), 0) << text("out");
    ASSERT_EQ(run(cases + "cracked-dam-upper", "rests", more + set("fluid.rest_tolerance=1e-5")), 0) << text("out");
    EXPECT_THAT(text("rests/summary.json"), HasSubstr(" windows: water and blocks were at rest, saved about "));
    const auto rests = summary("rests");
    const auto steps = summary("steps");
    const long passed = rests["counts"]["fluid_windows_at_rest"];
    EXPECT_EQ(steps["counts"]["fluid_windows_at_rest"], 0);
    EXPECT_EQ(rests["counts"]["fluid_windows"].get<long>() + passed, steps["counts"]["fluid_windows"].get<long>());
    EXPECT_GT(passed, least);
    EXPECT_EQ(rests["outcome"], steps["outcome"]);
    const double off = difference("rests", "steps");
    std::printf("%ld of %s windows at rest: interFoam took %.2f s instead of %.2f s, forces differ by %.1e\n", passed,
                steps["counts"]["fluid_windows"].dump().c_str(), rests["profile_s"]["fluid_step"].get<double>(),
                steps["profile_s"]["fluid_step"].get<double>(), off);
    EXPECT_LT(off, 3 * tolerance);
  }
};

TEST_F(AtRest, StillWaterIsNotSolvedFor) {
  compare(cells(20) + set("water.upstream_level_m=21") + set("analysis.duration_s=2"), 90);
}

/// Asleep between two rises of the level, and at the end.
TEST_F(AtRest, ItGoesOnWhereTheLevelDoes) {
  compare(cells(20) + set("water.upstream_level_m={table=[[0,20],[1,20],[1.2,20.5],[9,20.5]]}") +
              set("analysis.duration_s=4"),
          50);
}

/// A rise that comes in at the mesh's end as a wave, runs to the dam and back.
TEST_F(AtRest, WavesAreSolvedForAtTheirTurnToo) {
  const std::string more = cells(10) + set("water.upstream_level_m={table=[[0,20],[0.5,20],[1,20.5]]}") +
                           set("fluid.level_control=inflow") + set("fluid.upstream_depths=1") +
                           set("analysis.duration_s=6");
  ASSERT_EQ(run(cases + "cracked-dam-upper", "steps", more), 0) << text("out");
  ASSERT_EQ(run(cases + "cracked-dam-upper", "rests", more + set("fluid.rest_tolerance=1e-5")), 0) << text("out");
  const auto counts = summary("rests")["counts"];
  EXPECT_GT(counts["fluid_windows_at_rest"], 20);
  EXPECT_LE(counts["fluid_windows_at_rest"], 25);  // until the level rises, and never again
  EXPECT_LT(difference("rests", "steps"), 3 * tolerance);
}

}  // namespace
}  // namespace blockweir::test::openfoam_skips_test
