// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic solid_block
// Joints of blocks as a network of water: where they meet, what holds their ends, and what presses on the blocks.
#include "fluid/joints/joint_network.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/at.hpp"
#include "tests/joint_water.hpp"

namespace blockweir::hydrostatic::joint_network_test {
namespace {

using namespace tests;

TEST(JointNetwork, ABlockTurnedAboutItsToeHasTheWedgesPressure) {
  for (const double angle : {1e-6, 1e-5, 1e-4, 1e-3}) {
    const scene::Scene scene = flowing({ground, {{0, 0}, {8, 0}, {3, 10}, {0, 10}}}, 9);
    HydrostaticModel model(scene);
    wire::Motion motion = at_rest(scene);
    const Point centroid = geometry::centroid(scene.blocks[1].vertices);
    const Point toe(8, 0);
    const Point arm = toe - centroid;
    const Point turned(std::cos(angle) * arm.x() + std::sin(angle) * arm.y(),
                       -std::sin(angle) * arm.x() + std::cos(angle) * arm.y());
    const Point shift = arm - turned;
    motion.displacement.own()[1] = {shift.x(), shift.y(), -angle, 0, 0, 0};
    wire::Load load;
    model.advance(motion, 0, load);
    // The heel has risen by a little, which is all that is beyond the level wedge.
    const double w1 = aperture + 2 * 8 * std::sin(angle / 2);
    const double w2 = aperture;
    const double mouth = weight_n_per_m3 * (9 - model.flow_in_joints().joints().places()[0].at.y());
    const JointWater water = joint_water(scene, load, 1, 0);
    EXPECT_NEAR(water.force / (8 * mouth * w1 / (w1 + w2)), 1, 0.5 * angle + 1e-9) << angle;
  }
}

/// A wall of bricks of random lengths in courses, between a pool on its left and air.
struct Wall {
  std::vector<std::vector<Point>> outlines = {ground};
  std::vector<double> bed_m;                 ///< heights of the bed joints, from the ground up
  std::vector<std::vector<double>> heads_m;  ///< by course: where its head joints stand
  double length_m = 0;
};
Wall random_wall(std::mt19937_64& random) {
  const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  Wall wall;
  wall.length_m = between(3, 6);
  const int courses = static_cast<int>(between(2, 6));
  double y = 0;
  for (int course = 0; course < courses; ++course) {
    wall.bed_m.push_back(y);
    const double height = between(0.6, 1.5);
    std::vector<double> heads;
    for (double x = between(0.5, 1.5); x < wall.length_m - 0.4; x += between(0.5, 1.5)) heads.push_back(x);
    double from = 0;
    for (std::size_t i = 0; i <= heads.size(); ++i) {
      const double to = i < heads.size() ? heads[i] : wall.length_m;
      wall.outlines.push_back({{from, y}, {to, y}, {to, y + height}, {from, y + height}});
      from = to;
    }
    wall.heads_m.push_back(heads);
    y += height;
  }
  wall.bed_m.push_back(y);
  return wall;
}

/// Seepage to the right when all joints are full, by a dense matrix of the wall's crossings.
double seepage(const Wall& wall, double level_m, double viscosity) {
  std::map<std::pair<int, double>, int> node;
  std::vector<std::array<double, 3>> links;  // two nodes, length
  std::vector<double> known;                 // potential, or NaN
  const std::size_t courses = wall.heads_m.size();
  const auto number = [&](int bed, double x, double potential) {
    const auto [at, is_new] = node.try_emplace({bed, x}, static_cast<int>(known.size()));
    if (is_new) known.push_back(potential);
    return at->second;
  };
  const double unknown = std::nan("");
  for (std::size_t bed = 0; bed < courses; ++bed) {
    std::vector<double> xs = wall.heads_m[bed];
    if (bed > 0) xs.insert(xs.end(), wall.heads_m[bed - 1].begin(), wall.heads_m[bed - 1].end());
    std::sort(xs.begin(), xs.end());
    int last = number(static_cast<int>(bed), 0, weight_n_per_m3 * level_m);
    double from = 0;
    for (const double x : xs) {
      const int next = number(static_cast<int>(bed), x, unknown);
      links.push_back({double(last), double(next), x - from});
      last = next;
      from = x;
    }
    const int end = number(static_cast<int>(bed), wall.length_m, weight_n_per_m3 * wall.bed_m[bed]);
    links.push_back({double(last), double(end), wall.length_m - from});
  }
  for (std::size_t course = 0; course < courses; ++course) {
    for (const double x : wall.heads_m[course]) {
      const double top = course + 1 < courses ? unknown : weight_n_per_m3 * level_m;  // the crest is flooded
      const int low = number(static_cast<int>(course), x, unknown);
      const int high = number(static_cast<int>(course) + 1, x, top);
      links.push_back({double(low), double(high), wall.bed_m[course + 1] - wall.bed_m[course]});
    }
  }
  const auto n = static_cast<Eigen::Index>(known.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  const auto conductance = [&](double length) { return std::pow(aperture, 3) / (12 * viscosity * length); };
  for (const auto& [a, b, length] : links) {
    const auto i = static_cast<Eigen::Index>(a);
    const auto k = static_cast<Eigen::Index>(b);
    const double g = conductance(length);
    matrix(i, i) += g, matrix(k, k) += g, matrix(i, k) -= g, matrix(k, i) -= g;
  }
  const Eigen::MatrixXd whole = matrix;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (std::isnan(known[static_cast<std::size_t>(i)])) continue;
    matrix.row(i).setZero();
    matrix(i, i) = 1;
    right[i] = known[static_cast<std::size_t>(i)];
  }
  const Eigen::VectorXd potential = matrix.partialPivLu().solve(right);
  const Eigen::VectorXd supply = whole * potential;
  double out = 0;
  for (const auto& [at, i] : node) {
    if (at.second == wall.length_m) out -= supply[i];
  }
  return out;
}

TEST(JointNetwork, RandomWallsUnderWaterSeepAsTheirCrossingsSay) {
  std::mt19937_64 random(20261126);
  for (int i = 0; i < 60; ++i) {
    const Wall wall = random_wall(random);
    const double level_m = wall.bed_m.back() + 0.5;
    scene::Scene scene = flowing(wall.outlines, level_m);
    scene.water.may_overtop = true;
    // Water on the crest, and nowhere else to the right.
    HydrostaticModel model(scene);
    wire::Load load;
    model.advance(at_rest(scene), 0, load);
    const auto& joints = model.flow_in_joints().joints();
    std::size_t junctions = 0;
    for (std::size_t bed = 0; bed < wall.heads_m.size(); ++bed) {
      junctions += 2 + wall.heads_m[bed].size() + (bed > 0 ? wall.heads_m[bed - 1].size() : 0);
    }
    junctions += wall.heads_m.back().size();
    EXPECT_EQ(joints.network().nodes.size(), junctions) << i;
    // The crest's joints are in air where no water presses on the crest: they give nothing then.
    const bool crest_is_wet = std::any_of(
        joints.network().nodes.begin(), joints.network().nodes.end(),
        [&](const auto& n) { return n.height_m > wall.bed_m.back() - 1e-9 && n.kind == joints::NodeKind::held; });
    const joints::FlowBalance balance = model.flow_in_joints().balance();
    EXPECT_NEAR(balance.to_air, balance.from_open_water - balance.to_open_water, 1e-12 * balance.to_air) << i;
    if (crest_is_wet) {
      EXPECT_NEAR(balance.to_air / seepage(wall, level_m, scene.joint_flow.viscosity_pa_s), 1, 1e-9) << i;
    }
  }
}

TEST(JointNetwork, FactorsThatServeAgainChangeNoPressure) {
  std::mt19937_64 random(5);
  const Wall wall = random_wall(random);
  for (const double share : {1.1, 0.7}) {  // all joints full; some dry
    scene::Scene scene = flowing(wall.outlines, share * wall.bed_m.back());
    scene.water.may_overtop = true;
    scene::Scene without = scene;
    without.analysis.reuse_factors = false;
    HydrostaticModel one(scene);
    HydrostaticModel other(without);
    wire::Motion motion = at_rest(scene);
    wire::Load a;
    wire::Load b;
    for (int i = 0; i < 20; ++i) {
      for (std::size_t k = 1; k < scene.blocks.size(); ++k) {
        motion.displacement.own()[k][1] = 1e-8 * static_cast<double>(i) * static_cast<double>(k % 3);
      }
      one.advance(motion, 0.01 * i, a);
      other.advance(motion, 0.01 * i, b);
      ASSERT_EQ(a.pressure_from_pa.size(), b.pressure_from_pa.size());
      for (std::size_t k = 0; k < a.pressure_from_pa.size(); ++k) {
        EXPECT_NEAR(a.pressure_from_pa[k], b.pressure_from_pa[k], 1e-9 * weight_n_per_m3 * wall.bed_m.back());
      }
    }
    EXPECT_GT(one.flow_in_joints().solver().kept(), 10);
    EXPECT_EQ(other.flow_in_joints().solver().kept(), 0);
    EXPECT_THAT(one.report().skips, testing::Contains(testing::HasSubstr("factors of the flow through joints")));
  }
}

TEST(JointNetwork, AStateThatIsRestoredGivesTheSameBits) {
  std::mt19937_64 random(3);
  const Wall wall = random_wall(random);
  scene::Scene scene = flowing(wall.outlines, 0.8 * wall.bed_m.back());
  scene.joint_flow.kind = scene::FlowKind::transient;
  scene.joint_flow.bulk_modulus_pa = 2e9;
  HydrostaticModel one(scene);
  HydrostaticModel other(scene);
  wire::Motion motion = at_rest(scene);
  wire::Load a;
  one.advance(motion, 0, a);
  motion.displacement.own()[3][1] = 1e-4;
  one.advance(motion, 0.01, a);
  other.restore(one.state());
  motion.displacement.own()[3][1] = 2e-4;
  wire::Load b;
  one.advance(motion, 0.02, a);
  other.advance(motion, 0.02, b);
  EXPECT_EQ(a.pressure_from_pa.values(), b.pressure_from_pa.values());
  EXPECT_EQ(a.s_to.values(), b.s_to.values());
}

}  // namespace
}  // namespace blockweir::hydrostatic::joint_network_test
