// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step bridge_checkpoint
// Many blocks at once: they settle, stand and slide as few do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "bridge/checkpoint/archive.hpp"
#include "solid/block/parallel.hpp"
#include "solid/step/solid.hpp"
#include "tests/large_checks.hpp"
#include "tests/large_scenes.hpp"

namespace blockweir::solid::large_test {
namespace {

/// Each block rests on two, at four points of two forces: contacts are many times more than motions.
TEST(Large, APyramidOfBase100SettlesAndStandsStill) {
  auto scene = pyramid(100);
  scene.analysis.sleep = false;
  Solid solid(scene);
  ASSERT_EQ(solid.blocks().size(), 5051U);
  solid.settle({});
  EXPECT_EQ(solid.counts().factorizations, 1);  // of many solutions
  run_steps(solid, 5);
  EXPECT_LT(solid.largest_displacement_m(), 1e-9);
  EXPECT_LT(std::abs(reaction_error(solid)), 1e-8);
}

/// Separations are known to the last digit at any height: a step finds the forces of the one before in balance.
TEST(Large, AHighColumnThatStandsSolvesNothing) {
  auto scene = large_scene(1);
  scene.analysis.sleep = false;
  add_block(scene, box(-20, -1, 41, 1), true);
  for (int i = 0; i < 200; ++i) add_block(scene, box(0, i, 1, 1));
  Solid solid(scene);
  solid.settle({});
  const long solved = solid.counts().iterations;
  run_steps(solid, 20);
  EXPECT_EQ(solid.counts().iterations, solved);
  EXPECT_GE(solid.counts().skipped_searches, 18);
  EXPECT_LT(std::abs(reaction_error(solid)), 1e-8);
}

TEST(Large, ContactsThatAreNotSearchedAgainAreThoseThatASearchWouldFind) {
  auto scene = pyramid(20);
  scene.analysis.sleep = false;
  Solid solid(scene);
  solid.settle({});
  run_steps(solid, 10);
  EXPECT_GE(solid.counts().skipped_searches, 8);
  std::vector<ContactPoint> found = solid.contacts();
  const double reach = 0.05;  // of a block, as the solid's own
  ContactSearch(solid.parts(), solid.laws(), solid.model().size_m, reach, reach).update(solid.placements(), found);
  ASSERT_EQ(found.size(), solid.contacts().size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    const ContactPoint& kept = solid.contacts()[k];
    ASSERT_TRUE(found[k].same_key(kept));
    ASSERT_EQ(found[k].gap, kept.gap);
    ASSERT_EQ(found[k].anchor, kept.anchor);
    ASSERT_EQ(found[k].separation, kept.separation);
    ASSERT_EQ(found[k].length, kept.length);
    ASSERT_EQ(found[k].multiplier, kept.multiplier);
    ASSERT_EQ(found[k].state, kept.state);
  }
}

/// Blocks that wait while others settle belong to no island, nor do their contacts with the ground.
TEST(Large, ABlockThatHoversOverTheGroundWaitsAndThenFalls) {
  auto scene = pyramid(2);
  add_block(scene, box(-3, 0.001, 1, 1));
  Solid solid(scene);
  solid.settle({});
  EXPECT_EQ(solid.states()[4].displacement[1], 0);
  run_steps(solid, 6);
  EXPECT_NEAR(solid.states()[4].displacement[1], -0.001, 1e-8);
}

/// What settling takes does not depend on how large the ground is drawn.
TEST(Large, AWideGroundMakesSettlingNoSofter) {
  auto scene = pyramid(5);
  const auto iterations = [&] {
    Solid solid(scene);
    solid.settle({});
    return solid.counts().iterations;
  };
  const long narrow = iterations();
  for (auto& vertex : scene.blocks[0].vertices) {
    vertex.x() *= 10;
    if (vertex.y() < 0) vertex.y() = -10;
  }
  EXPECT_EQ(iterations(), narrow);
}

/// A search that looks only as far as blocks are expected to move would let this one into the wall.
TEST(Large, ABlockThatCrossesAGapInAStepIsStoppedByWhatIsBehindIt) {
  auto scene = large_scene(0.6);
  scene.analysis.max_displacement_ratio = 10;
  scene.analysis.gravity_m_per_s2 = 0;
  add_block(scene, box(0.15, -1, 1, 3), true);
  add_block(scene, box(-1, 0, 1, 1));
  scene.blocks[1].initial_velocity_m_per_s = scene::Point(60, 0);
  Solid solid(scene);
  run_steps(solid, 1);
  EXPECT_NEAR(solid.states()[1].displacement[0], 0.15, 1e-8);
}

TEST(Large, ASlopeStandsWithTheFrictionOfItsDipAndSlidesAsTheFormulaSaysWithLess) {
  const double dip = 20 * std::numbers::pi / 180;
  for (const double friction : {0.6, 0.3}) {
    auto scene = rock_slope(100, friction);
    Solid solid(scene);
    solid.settle({});
    run_steps(solid, 30);
    const double acceleration = std::max(0.0, 9.81 * (std::sin(dip) - friction * std::cos(dip)));
    EXPECT_NEAR(solid.states()[1].displacement.head<2>().norm(), acceleration * 0.5 * 0.5 / 2, 1e-6) << friction;
  }
}

/// The whole law, whose states run in circles, gives way after two solutions; an interior point takes hardly more
/// factorizations for five times as many blocks.
TEST(Large, ASlopeOfThousandsSettlesWithAsManyFactorizationsAsOneOfAThousand) {
  const auto settle = [](int blocks) {
    const auto scene = rock_slope(blocks, 0.6);
    Solid solid(scene);
    solid.settle({});
    EXPECT_EQ(solid.counts().lagged_steps, 1) << blocks;
    EXPECT_LT(worst_against_coulomb(solid, 0.6), 2e-10) << blocks;
    EXPECT_LT(solid.largest_displacement_m(), 1e-10) << blocks;
    return solid.counts().factorizations;
  };
  const long of_a_thousand = settle(1000);
  EXPECT_LT(of_a_thousand, 25);  // 37 by the whole law
  EXPECT_LT(static_cast<double>(settle(5000)), 1.3 * static_cast<double>(of_a_thousand));
}

/// Its acceleration does not change from one quasi-static step to the next.
TEST(Large, AStartThatSlidesIsNotWaitedFor) {
  const auto scene = rock_slope(100, 0.3);
  Solid solid(scene);
  solid.settle({});
  EXPECT_LT(solid.counts().settling_steps, 20);  // of 200 at most
  for (const BlockState& state : solid.states()) EXPECT_LT(state.displacement.norm(), 1e-9);
}

/// Contact forces of rigid blocks are many times more than their motions, and leave most contacts of a slope that
/// begins to slide near their bounds. What Newton's method does not find sweeps find, and Newton's method makes it
/// exact; a resumed run goes on with the same bits.
TEST(Large, ASlopeOf300BlocksSlidesAsTheFormulaSays) {
  const double dip = 20 * std::numbers::pi / 180;
  auto scene = rock_slope(300, 0.3);
  Solid solid(scene);
  solid.settle({});
  const double dt = scene.analysis.step_s;
  const auto advance = [dt](Solid& one, int n) {
    const Counts before = one.counts();
    one.advance(n * dt, (n + 1) * dt, {});
    return std::pair(one.counts().swept_islands - before.swept_islands, one.counts().iterations - before.iterations);
  };
  EXPECT_EQ(advance(solid, 0).first, 1);
  Solid resumed(scene);
  checkpoint::unpack(checkpoint::pack(solid), resumed);
  EXPECT_EQ(advance(resumed, 1), advance(solid, 1));
  for (std::size_t b = 0; b < solid.states().size(); ++b) {
    ASSERT_EQ(resumed.states()[b].displacement, solid.states()[b].displacement) << b;
  }
  for (int n = 2; n < 12; ++n) advance(solid, n);
  const double acceleration = 9.81 * (std::sin(dip) - 0.3 * std::cos(dip));
  EXPECT_EQ(solid.counts().steps, 12);  // none was cut
  EXPECT_NEAR(solid.states()[1].displacement.head<2>().norm(), acceleration * 0.2 * 0.2 / 2, 1e-6);
  EXPECT_LT(worst_against_coulomb(solid, 0.3), 2e-10);
}

/// Displacements, velocities, accelerations, then multipliers, forces, penalties and states of contacts, on so many
/// threads.
std::vector<double> all_of_it(const scene::Scene& scene, int steps, std::size_t on_threads) {
  const std::size_t before = threads();
  set_threads(on_threads);
  Solid solid(scene);
  if (scene.analysis.start == scene::Start::equilibrium) solid.settle({});
  run_steps(solid, steps);
  set_threads(before);
  std::vector<double> all;
  for (const BlockState& s : solid.states()) {
    for (const Vector6* part : {&s.displacement, &s.velocity, &s.acceleration, &s.force}) {
      all.insert(all.end(), part->data(), part->data() + 6);
    }
  }
  for (const ContactPoint& c : solid.contacts()) {
    all.insert(all.end(), {c.multiplier.x(), c.multiplier.y(), c.force.x(), c.force.y(), c.separation.x(),
                           c.separation.y(), c.penalty, c.slip_m, static_cast<double>(c.state)});
  }
  return all;
}

TEST(Large, AWallThatIsShakenIsTheSameOnAnyNumberOfThreads) {
  auto scene = brick_wall(4200);
  scene.base_motion.emplace();
  scene.base_motion->acceleration_x_m_per_s2 = scene::TimeTable::constant(1);
  EXPECT_EQ(all_of_it(scene, 1, 1), all_of_it(scene, 1, 2));
}

TEST(Large, BlocksThatSlideAreTheSameOnAnyNumberOfThreads) {
  auto scene = large_scene(0.6);
  scene.analysis.start = scene::Start::unstressed;
  scene.analysis.islands = false;
  const int count = 4200;
  add_block(scene, box(-10, -1, 2 * count + 20, 1), true);
  for (int i = 0; i < count; ++i) {
    add_block(scene, box(2 * i, 0, 1, 0.2));
    scene.blocks.back().initial_velocity_m_per_s = scene::Point(1, 0);
  }
  const std::vector<double> alone = all_of_it(scene, 4, 1);
  EXPECT_NEAR(alone[24], 4.0 / 60 - 0.6 * 9.81 * std::pow(4.0 / 60, 2) / 2, 1e-6);  // of the first
  EXPECT_EQ(all_of_it(scene, 4, 2), alone);
}

}  // namespace
}  // namespace blockweir::solid::large_test
