// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_process
// Added masses of a load: the largest ratio is kept, what an explicit schedule cannot carry is refused by name.
#include "solid/watch/added_mass_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "solid/process/coupled_solid.hpp"
#include "tests/own_folder.hpp"

namespace blockweir::solid::added_mass_watch_test {
namespace {

using testing::HasSubstr;
using Row = std::array<double, 6>;

constexpr double mass = 2500 * 2;               // of each block
constexpr double moment = mass * (1 + 4) / 12;  // kg m

/// A floor and two blocks 1 m wide and 2 m high, apart.
scene::Scene two_blocks() {
  scene::Scene scene;
  scene.materials.push_back({"concrete", 50e9, 0.2, 2500});
  scene.blocks.push_back({.name = "floor", .vertices = {{-2, -1}, {6, -1}, {6, 0}, {-2, 0}}, .fixed = true});
  scene.blocks.push_back({.name = "gate", .vertices = {{0, 0}, {1, 0}, {1, 2}, {0, 2}}});
  scene.blocks.push_back({.name = "wall", .vertices = {{3, 0}, {4, 0}, {4, 2}, {3, 2}}});
  scene.coupling.window_s = 0.01;
  scene.analysis.duration_s = 0.1;
  return scene;
}

wire::Load load_of(const Row& gate, const Row& wall) {
  wire::Load load;
  load.upstream_level_m = load.downstream_level_m = 1;
  load.added_mass = {Row{1e9, 0, 0, 1e9, 0, 1e9}, gate, wall};  // the floor does not move
  return load;
}

/// With what gate and wall do to each other along x.
wire::Load coupled(std::uint32_t first, std::uint32_t second, double between) {
  const Row of_each{2 * mass, 0, 0, 0, 0, 0};
  wire::Load load = load_of(of_each, of_each);
  load.coupled = {{first, second}};
  load.added_mass_between = {{between, 0, 0, 0, 0, 0, 0, 0, 0}};
  return load;
}

std::string refusal(const scene::Scene& scene, const wire::Load& load) {
  const Solid solid(scene);
  AddedMassWatch watch;
  try {
    watch.look(load, solid);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(AddedMassWatch, MassesBetweenBlocksAreTakenOverButThoseOfHeldOnes) {
  const auto scene = two_blocks();
  const Solid solid(scene);
  AddedMassWatch watch;
  const auto masses = watch.look(coupled(1, 2, -1.5 * mass), solid);
  ASSERT_EQ(masses.pairs.size(), 1U);
  EXPECT_EQ(masses.pairs[0].mass(0, 0), -1.5 * mass);
  EXPECT_TRUE(watch.look(coupled(0, 2, mass), solid).pairs.empty());
}

TEST(AddedMassWatch, MassesBetweenBlocksThatCannotBeAreRefused) {
  const auto scene = two_blocks();
  EXPECT_EQ(
      refusal(scene, coupled(1, 2, 2.5 * mass)),
      "the added mass between blocks \"gate\" and \"wall\" is larger than their own: the fluid process is at fault");
  EXPECT_EQ(
      refusal(scene, coupled(2, 1, mass)),
      "an added mass between blocks 2 and 1 of 3; expected the lower number first: the fluid process is at fault");
  EXPECT_THAT(refusal(scene, coupled(1, 3, mass)), HasSubstr("between blocks 1 and 3 of 3"));
}

TEST(AddedMassWatch, TheLargestRatioOfTheRunIsKeptWithItsBlock) {
  const auto scene = two_blocks();
  const Solid solid(scene);
  AddedMassWatch watch;
  EXPECT_TRUE(watch.look({}, solid).empty());
  EXPECT_EQ(watch.ratio(), 0);
  const auto masses = watch.look(load_of({1, 2, 3, 4, 5, 60}, {}), solid);
  ASSERT_EQ(masses.own.size(), 3U);
  EXPECT_EQ(masses.own[1], (Eigen::Matrix3d() << 1, 2, 3, 2, 4, 5, 3, 5, 60).finished());
  watch.look(load_of({}, {0.2 * mass, 0, 0, 0.1 * mass, 0, 1.32 * moment}), solid);
  watch.look(load_of({0.5 * mass, 0, 0, 0, 0, 0}, {}), solid);
  EXPECT_NEAR(watch.ratio(), 1.32, 1e-12);
  EXPECT_EQ(watch.block(), "wall");
}

TEST(AddedMassWatch, ModesAreThoseOfTheMatrix) {
  // The water hangs on one point at (0, -1) from the centroid: m (1, 0, 1) (1, 0, 1)^T.
  const auto scene = two_blocks();
  const Solid solid(scene);
  AddedMassWatch watch;
  watch.look(load_of({mass, 0, mass, 0, 0, mass}, {}), solid);
  EXPECT_NEAR(watch.ratio(), 1 + mass / moment, 1e-12);
}

TEST(AddedMassWatch, WithoutTheGuardHeavierWaterIsRefusedWithTheRemedy) {
  auto scene = two_blocks();
  const auto load = load_of({1.32 * mass, 0, 0, 0, 0, 0}, {});
  EXPECT_EQ(refusal(scene, load), "");
  scene.coupling.added_mass_guard = false;
  EXPECT_EQ(
      refusal(scene, load),
      "block \"gate\" has to push water 1.32 times as heavy as itself; without the added-mass guard the exchange is "
      "unstable above 1, whatever the step; set [coupling] added_mass_guard = true");
  EXPECT_EQ(refusal(scene, load_of({0.99 * mass, 0, 0, 0, 0, 0}, {})), "");
  scene.analysis.kind = scene::AnalysisKind::quasi_static;
  EXPECT_EQ(refusal(scene, load), "");
}

TEST(AddedMassWatch, PredictingSchedulesCarryLess) {
  auto scene = two_blocks();
  scene.coupling.added_mass_guard = false;
  scene.coupling.schedule = scene::Schedule::parallel;  // 1 - r^2 = 2 r
  EXPECT_EQ(refusal(scene, load_of({0.41 * mass, 0, 0, 0, 0, 0}, {})), "");
  EXPECT_THAT(refusal(scene, load_of({0.42 * mass, 0, 0, 0, 0, 0}, {})), HasSubstr("unstable above 0.414"));
  scene.coupling.schedule = scene::Schedule::improved;
  scene.coupling.load_in_window = scene::LoadInWindow::linear;
  EXPECT_THAT(refusal(scene, load_of({0.3 * mass, 0, 0, 0, 0, 0}, {})), HasSubstr("unstable above 0.25"));
}

TEST(AddedMassWatch, AScenesOwnLimitGoesOverIt) {
  auto scene = two_blocks();
  scene.coupling.added_mass_guard = false;
  scene.coupling.added_mass_limit = 5;
  EXPECT_EQ(refusal(scene, load_of({4.9 * mass, 0, 0, 0, 0, 0}, {})), "");
  EXPECT_THAT(refusal(scene, load_of({5.1 * mass, 0, 0, 0, 0, 0}, {})), HasSubstr("unstable above 5"));
}

TEST(AddedMassWatch, TheGuardHasALimitToo) {
  EXPECT_EQ(refusal(two_blocks(), load_of({}, {99 * mass, 0, 0, 0, 0, 0})), "");
  EXPECT_THAT(
      refusal(two_blocks(), load_of({}, {132 * mass, 0, 0, 0, 0, 0})),
      HasSubstr("block \"wall\" has to push water 132 times as heavy as itself; the added-mass guard holds up to "
                "100;"));
}

/// Water is trapped under what lands: once a run is on its way that is told at its end, and growth is watched.
TEST(AddedMassWatch, TheGuardsLimitIsForTheStart) {
  auto scene = two_blocks();
  const Solid solid(scene);
  AddedMassWatch watch;
  wire::Load load = load_of({}, {132 * mass, 0, 0, 0, 0, 0});
  load.time_s = 0.5;
  watch.look(load, solid);
  EXPECT_THAT(watch.warning(scene), HasSubstr("block \"wall\" had to push water 132 times as heavy"));
  scene.coupling.added_mass_limit = 120;  // of the scene's own it holds all along
  const Solid limited(scene);
  AddedMassWatch other;
  EXPECT_THROW(other.look(load, limited), SolveError);
}

TEST(AddedMassWatch, WhatIsNoInertiaIsRefused) {
  EXPECT_THAT(refusal(two_blocks(), load_of({0.1 * mass, 0.3 * mass, 0, 0.1 * mass, 0, 0}, {})),
              HasSubstr("states an added mass on block \"gate\" that is -0.2 of its own in one mode"));
  wire::Load load = load_of({}, {});
  load.added_mass.own().pop_back();
  EXPECT_EQ(refusal(two_blocks(), load), "states added masses of 2 blocks; the scene has 3; give both sides one scene");
}

/// A run's results.
class Recorded : public test::OwnFolder {
 protected:
  Recorded() { std::filesystem::create_directories(folder / "frames"); }
  [[nodiscard]] nlohmann::json summary() const {
    std::ifstream stream(folder / "summary.json");
    return nlohmann::json::parse(stream);
  }
};

TEST_F(Recorded, TheSummarySaysTheRatioInOneLine) {
  const auto scene = two_blocks();
  CoupledSolid coupled(scene, folder, results::Begin::anew,
                       {[](double, double, double) {}, [](long) {}, [](std::uint64_t, double, long) {}});
  wire::Motion motion;
  coupled.start(load_of({}, {}));
  coupled.place(motion);
  coupled.advance(load_of({1.32 * mass, 0, 0, 0, 0, 0}, {}), motion, 0, 0.01);
  coupled.finish(nlohmann::json::object(), "", {});
  EXPECT_EQ(summary()["added_mass"]["text"], "added mass 1.32 of block \"gate\"'s own (guarded)");
  EXPECT_EQ(summary()["added_mass"]["block"], "gate");
  EXPECT_EQ(summary()["added_mass"]["guarded"], true);
}

TEST_F(Recorded, ARunIsRefusedAtItsFirstLoad) {
  auto scene = two_blocks();
  scene.coupling.added_mass_guard = false;
  CoupledSolid coupled(scene, folder, results::Begin::anew,
                       {[](double, double, double) {}, [](long) {}, [](std::uint64_t, double, long) {}});
  EXPECT_THROW(coupled.start(load_of({3 * mass, 0, 0, 0, 0, 0}, {})), std::runtime_error);
}

}  // namespace
}  // namespace blockweir::solid::added_mass_watch_test
