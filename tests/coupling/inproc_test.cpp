// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Still water, or a reservoir, within the solid's process: the bits of two processes, and the same words when it goes
// wrong.
#include "tests/same_results.hpp"

namespace blockweir::test::inproc_test {
namespace {

using testing::HasSubstr;

class Inproc : public SameResults {
 protected:
  [[nodiscard]] static std::string command(const std::string& scene, const std::string& more) {
    return programs + "/blockweir run " + cases + scene + " --quiet " + more;
  }
};

TEST_F(Inproc, GivesTheBitsOfTwoProcesses) {
  for (const std::string scene : {"cracked-dam-upper --set output.reservoir=true", "monolith-overturns",
                                  "cracked-dam-upper --set coupling.schedule=improved --variant \"full uplift\"",
                                  "cracked-dam-upper --set coupling.schedule=parallel"}) {
    SCOPED_TRACE(scene);
    const std::string to_failure = scene + " --set analysis.duration_s=4";
    ASSERT_EQ(shell(command(to_failure, "--out two")), 0) << text("out");
    ASSERT_EQ(shell(command(to_failure, "--out one --inproc")), 0) << text("out");
    EXPECT_FALSE(fs::exists(folder / "one/hydrostatic.log"));
    expect_same("two", "one");
    const auto summary = nlohmann::json::parse(text("one/summary.json"));
    EXPECT_GT(summary["counts"]["fluid_updates"], 10);
    EXPECT_GT(summary["profile_s"]["fluid_mapping"], 0);
    fs::remove_all(folder / "one");
    fs::remove_all(folder / "two");
  }
}

TEST_F(Inproc, AReservoirThatRespondsGivesThemToo) {
  const std::string scene =
      "reservoir-slide --set coupling.schedule=improved --set analysis.duration_s=0.4 --set "
      "coupling.window_s=0.005 --set "
      "fluid.reservoir.surface=waves ";
  ASSERT_EQ(shell(command(scene, "--set expect=[] --out two")), 0) << text("out");
  ASSERT_EQ(shell(command(scene, "--set expect=[] --out one --inproc")), 0) << text("out");
  EXPECT_FALSE(fs::exists(folder / "one/reservoir.log"));
  expect_same("two", "one");
  EXPECT_GT(nlohmann::json::parse(text("one/summary.json"))["counts"]["fluid_reservoir solutions"], 1);
}

TEST_F(Inproc, ASceneWithoutWaterNeedsNeither) {
  EXPECT_EQ(shell(command("incline", "--out o --inproc")), 0) << text("out");
}

TEST_F(Inproc, AFluidThatNeedsAProcessIsRefusedAndNothingIsTouched) {
  EXPECT_EQ(shell(command("water-column", "--out o --inproc")), 2);
  EXPECT_THAT(text("out"),
              HasSubstr("--inproc: found model = \"column\" in [fluid]; only \"hydrostatic\" and \"reservoir\""));
  EXPECT_FALSE(fs::exists(folder / "o"));
  EXPECT_EQ(shell(programs + "/blockweir-inproc " + cases + "water-column --out o"), 2);
  EXPECT_THAT(text("out"), HasSubstr("[fluid] model: found \"column\"; expected \"hydrostatic\""));
}

TEST_F(Inproc, IsStoppedAndGoesOnEitherWay) {
  const std::string scene = "cracked-dam-upper --set analysis.duration_s=6 ";
  ASSERT_EQ(shell(command(scene, "--out whole")), 0) << text("out");
  for (const std::string how : {"", " --inproc"}) {
    const pid_t run = start(command(scene, "--out parts --inproc"), "log");
    ASSERT_TRUE(under_way("parts"));
    kill(run, SIGINT);
    ASSERT_EQ(end_of(run, 20), 130) << text("log");
    EXPECT_THAT(text("log"), HasSubstr("STOPPED on request; the results so far stand; \"blockweir resume parts\""));
    ASSERT_EQ(shell(programs + "/blockweir resume parts --quiet" + how), 0) << text("out");
    expect_same("whole", "parts");
    fs::remove_all(folder / "parts");
  }
}

TEST_F(Inproc, WhatGoesWrongInTheWaterIsSaidOnce) {
  ASSERT_EQ(shell("mkdir -p o/reservoir.pvd"), 0);  // where a file is to go
  EXPECT_EQ(shell(programs + "/blockweir-inproc " + cases + "cracked-dam-upper --set output.reservoir=true --out o"),
            1);
  EXPECT_THAT(text("out"), HasSubstr("reservoir.pvd"));
}

}  // namespace
}  // namespace blockweir::test::inproc_test
