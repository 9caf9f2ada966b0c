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
#include "tests/still_water.hpp"

namespace blockweir::hydrostatic {
namespace {

using tests::scene_of;

constexpr double weight_n_per_m3 = 9810;
constexpr double aperture = 2e-4;

/// Blocks by these outlines, the first of them fixed; water flows through all joints.
scene::Scene flowing(const std::vector<std::vector<Point>>& outlines, double upstream_m) {
  scene::Scene scene = scene_of(outlines, upstream_m);
  scene.blocks[0].fixed = true;
  scene.default_joint.uplift = scene::Uplift::flow;
  scene.default_joint.hydraulic_aperture_m = aperture;
  scene.analysis.gravity_m_per_s2 = 9.81;
  scene.water.elements_per_face = 1;
  return scene;
}

wire::Motion at_rest(const scene::Scene& scene) {
  wire::Motion motion;
  motion.displacement.own().resize(scene.blocks.size());
  motion.velocity.own().resize(scene.blocks.size());
  return motion;
}

struct Joint {
  double force = 0;   ///< N/m
  double moment = 0;  ///< about the edge's first vertex, N
};

/// Of the water in joints, along an edge of a block.
Joint joint_water(const scene::Scene& scene, const wire::Load& load, std::uint32_t block, std::uint32_t edge) {
  const auto& outline = scene.blocks[block].vertices;
  const double length = (outline[(edge + 1) % outline.size()] - outline[edge]).norm();
  Joint sum;
  for (std::size_t i = load.cracks_from; i < load.block.size(); ++i) {
    if (load.block[i] != block || load.edge[i] != edge) continue;
    const double a = length * load.s_from[i];
    const double b = length * load.s_to[i];
    const double p = load.pressure_from_pa[i];
    const double q = load.pressure_to_pa[i];
    sum.force += (b - a) * (p + q) / 2;
    sum.moment += (b - a) / 6 * (p * (2 * a + b) + q * (a + 2 * b));
  }
  return sum;
}

const std::vector<Point> ground = {{-20, -5}, {30, -5}, {30, 0}, {-20, 0}};

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
    const Joint water = joint_water(scene, load, 1, 0);
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

TEST(JointNetwork, ADrainHoldsItsHeadAndTakesItsShare) {
  scene::Scene scene = flowing({ground, {{0, 0}, {8, 0}, {3, 10}, {0, 10}}}, 9);
  for (const double efficiency : {1.0, 0.6}) {
    scene.joint_flow.drains = {{"curtain", {2, -1}, {2, 1}, 0.0, efficiency}};
    HydrostaticModel model(scene);
    wire::Load load;
    model.advance(at_rest(scene), 0, load);
    const double mouth = 9 * weight_n_per_m3;
    const double at_drain = (1 - efficiency) * mouth * 6 / 8;
    EXPECT_NEAR(joint_water(scene, load, 1, 0).force, (mouth + at_drain) / 2 * 2 + at_drain / 2 * 6, 1e-10 * 8 * mouth);
    const double g = std::pow(aperture, 3) / (12 * scene.joint_flow.viscosity_pa_s);
    EXPECT_NEAR(model.flow_in_joints().balance().to_drain[0], g * ((mouth - at_drain) / 2 - at_drain / 6),
                1e-10 * g * mouth);
  }
}

TEST(JointNetwork, ADrainGivesNoWater) {
  scene::Scene scene = flowing({ground, {{0, 0}, {8, 0}, {3, 10}, {0, 10}}}, 3);
  scene.joint_flow.drains = {{"gallery", {4, -1}, {4, 1}, 7.0, 1.0}};
  HydrostaticModel model(scene);
  wire::Load load;
  model.advance(at_rest(scene), 0, load);
  EXPECT_EQ(model.flow_in_joints().balance().to_drain[0], 0);
  EXPECT_NEAR(joint_water(scene, load, 1, 0).force, 3 * weight_n_per_m3 * 8 / 2, 1e-9 * 3 * weight_n_per_m3 * 8);
}

TEST(JointNetwork, GroutTakesTheHeadUpstreamOfIt) {
  scene::Scene scene = flowing({ground, {{0, 0}, {8, 0}, {3, 10}, {0, 10}}}, 9);
  scene.joint_flow.grouts = {{"curtain", {{1, -2}, {3, -2}, {3, 1}, {1, 1}}, 0.25}};
  HydrostaticModel model(scene);
  wire::Load load;
  model.advance(at_rest(scene), 0, load);
  const double mouth = 9 * weight_n_per_m3;
  const double total = 1 + 2 * 64 + 5;
  const double p1 = mouth * (1 - 1 / total);
  const double p3 = mouth * 5 / total;
  EXPECT_NEAR(joint_water(scene, load, 1, 0).force, (mouth + p1) / 2 + (p1 + p3) + p3 / 2 * 5, 1e-9 * 8 * mouth);
}

TEST(JointNetwork, TheModelsEndsInTheGroundLetNoWaterOut) {
  // Two beds of rock under a dam: the joint between them ends on the model's sides.
  const scene::Scene scene = flowing({{{-20, -10}, {30, -10}, {30, -5}, {-20, -5}},
                                      {{-20, -5}, {4, -5}, {4, 0}, {-20, 0}},
                                      {{4, -5}, {30, -5}, {30, 0}, {4, 0}},
                                      {{0, 0}, {8, 0}, {3, 10}, {0, 10}}},
                                     9);
  scene::Scene held = scene;
  for (std::size_t b : {1U, 2U}) held.blocks[b].fixed = true;
  HydrostaticModel model(held);
  wire::Load load;
  model.advance(at_rest(held), 0, load);
  // Nothing flows down there: the joint below has the head of the dam's base above its upright joint, the middle's.
  const auto& flow = model.flow_in_joints();
  for (std::size_t i = 0; i < flow.joints().places().size(); ++i) {
    if (flow.joints().places()[i].at.y() > -4.9) continue;
    EXPECT_NEAR(flow.filling().pressure_pa[i], (9 * 0.5 + 5) * weight_n_per_m3, 1) << i;
    EXPECT_EQ(flow.joints().network().nodes[i].kind, joints::NodeKind::inside);
  }
}

TEST(JointNetwork, AStepBesideTheHeelIsNoJoint) {
  // A joint of the rock ends 24 mm upstream of the heel, and the rock before it stands 1.2 mm higher.
  scene::Scene scene = flowing({{{-30, -6}, {-0.024, -6}, {-0.024, 0.0012}, {-30, 1.5}},
                                {{-0.024, -6}, {20, -6}, {20, 0}, {-0.024, 0}},
                                {{0, 0}, {4, 0}, {4, 10}, {0, 10}}},
                               6);
  scene.blocks[1].fixed = true;
  scene.water.open_crack_width_m = 0.025;
  HydrostaticModel model(scene);
  wire::Load load;
  model.advance(at_rest(scene), 0, load);
  EXPECT_NEAR(joint_water(scene, load, 2, 0).force, 6 * weight_n_per_m3 * 4 / 2, 1e-6 * 6 * weight_n_per_m3);
}

TEST(JointNetwork, AMouthOnTheModelsSideLetsNoTailwaterIn) {
  for (const double depth : {0.05, 0.09, 0.15}) {
    scene::Scene scene = flowing({{{-20, -5}, {30, -5}, {30, -depth}, {-20, -depth}},
                                  {{-20, -depth}, {30, -depth}, {30, 0}, {-20, 0}},
                                  {{0, 0}, {8, 0}, {3, 10}, {0, 10}}},
                                 9);
    scene.blocks[1].fixed = true;
    scene.water.downstream_level_m = scene::TimeTable::constant(2);
    HydrostaticModel model(scene);
    wire::Load load;
    model.advance(at_rest(scene), 0, load);
    const double q = std::pow(aperture, 3) / (12 * scene.joint_flow.viscosity_pa_s) * weight_n_per_m3 * 7 / 8;
    EXPECT_NEAR(model.flow_in_joints().balance().from_open_water / q, 1, 1e-9) << depth;
  }
}

TEST(JointNetwork, SteadyFlowStaysSteadyInTransientFlow) {
  // The lift joint seeps out at the top of a wide joint that begins there.
  scene::Scene scene = flowing(
      {ground, {{0, 0}, {4, 0}, {4, 5}, {0, 5}}, {{4, 0}, {9, 0}, {9, 5}, {4, 5}}, {{0, 5}, {4, 5}, {4, 10}, {0, 10}}},
      8);
  scene.joint_flow.kind = scene::FlowKind::transient;
  HydrostaticModel model(scene);
  wire::Load load;
  model.advance(at_rest(scene), 0, load);
  const joints::FlowBalance before = model.flow_in_joints().balance();
  for (int i = 1; i <= 20; ++i) model.advance(at_rest(scene), 0.1 * i, load);
  const joints::FlowBalance after = model.flow_in_joints().balance();
  EXPECT_NEAR(after.from_open_water / before.from_open_water, 1, 1e-9);
  EXPECT_NEAR(after.to_air / before.to_air, 1, 1e-9);
  EXPECT_NEAR(after.stored / before.stored, 1, 1e-9);
}

TEST(JointNetwork, ADrainTakesNoMoreThanComesBeyondWhatTheJointBelowCarries) {
  // A falling joint, drained halfway without a head: what its lower half carries at no pressure goes on.
  for (const double below : {1.5, 1.0, 0.5}) {
    scene::Scene scene =
        flowing({{{-20, -9}, {30, -9}, {30, -4}, {8, -4}, {0, 0}, {-20, 0}}, {{0, 0}, {8, -4}, {8, 8}, {0, 8}}}, 6);
    scene.joint_flow.drains = {{"drain", {4, -5}, {4, 0}, std::nullopt, 1.0}};
    scene.joint_flow.grouts = {{"below", {{4, -6}, {9, -6}, {9, 1}, {4, 1}}, below}};
    HydrostaticModel model(scene);
    wire::Load load;
    model.advance(at_rest(scene), 0, load);
    const double g = std::pow(aperture, 3) / (12 * scene.joint_flow.viscosity_pa_s);
    const double half = std::hypot(4, 2);
    const double comes = g * weight_n_per_m3 * (6 + 2) / half;
    const double goes_on = g * std::pow(below, 3) * weight_n_per_m3 * 2 / half;
    const joints::FlowBalance balance = model.flow_in_joints().balance();
    EXPECT_NEAR(balance.to_drain[0] / (comes - goes_on), 1, 1e-6) << below;
    EXPECT_NEAR(balance.to_air / goes_on, 1, 1e-6) << below;
  }
}

TEST(JointNetwork, WaterThatFallsThroughAnUnevenGapHasNoSuction) {
  const scene::Scene scene =
      flowing({{{-20, -9}, {30, -9}, {30, -2}, {4, -2}, {0, 0}, {-20, 0}}, {{0, 0}, {4, -1.994}, {4, 8}, {0, 8}}}, 5);
  HydrostaticModel model(scene);
  wire::Load load;
  model.advance(at_rest(scene), 0, load);
  for (std::size_t i = 0; i < load.block.size(); ++i) {
    EXPECT_GE(load.pressure_from_pa[i], 0);
    EXPECT_GE(load.pressure_to_pa[i], 0);
  }
  EXPECT_GT(joint_water(scene, load, 1, 0).force, 0);
}

TEST(JointNetwork, AMouthInAHollowIsToldOf) {
  scene::Scene scene =
      flowing({{{-20, -5}, {30, -5}, {30, 2.5}, {4, 0}, {-20, 0}}, {{0, 0}, {4, 0}, {4, 10}, {0, 10}}}, 8);
  scene.water.downstream_level_m = scene::TimeTable::constant(2);
  HydrostaticModel model(scene);
  wire::Load load;
  model.advance(at_rest(scene), 0, load);
  EXPECT_THAT(model.report().warnings,
              testing::Contains(testing::HasSubstr("ends in air at (4, 0) m, below the downstream")));
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
    EXPECT_GT(one.flow_in_joints().kept_factors(), 10);
    EXPECT_EQ(other.flow_in_joints().kept_factors(), 0);
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
}  // namespace blockweir::hydrostatic
