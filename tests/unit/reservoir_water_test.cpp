// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_reservoir
// Added masses of walls against closed forms: PHYSICS of Westergaard's series, basins and parts of a wall.
#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "fluid/reservoir/added_mass.hpp"
#include "tests/unit/reservoir_wall.hpp"

namespace blockweir::reservoir::reservoir_water_test {
namespace {

struct Solved {
  WaterMesh mesh;
  WaterAnswer answer;
  Eigen::Index top;  ///< first mode of the uppermost block
};

/// By a field of acceleration on the sides that move, at the node nearest to x.
double pressure(const WaterMesh& mesh, const PressureEquation::Moves& moves, const Point& along, const Point& x) {
  const PressureEquation equation(mesh, {}, {true, false, false}, 1);
  const Eigen::VectorXd p = equation.pressure(equation.flux(moves, [&](const Point&) { return along; }));
  return p[node_nearest(mesh, x)];
}

Solved solve(const Wall& wall, double ratio) {
  const WaterMesh mesh =
      mesh_of(wall, ratio, {wall.far_wall_m.value_or(-6 * wall.H - 100), wall.far_wall_m.has_value(), {}});
  const auto outlines = wall.outlines();
  std::vector<bool> fixed(outlines.size(), false);
  fixed[0] = true;
  const auto moves = [&](const process::FacePoint& point) -> process::PointMotion {
    if (point.block == 0) return {};
    const auto& outline = outlines[at(point.block)];
    const Point& from = outline[at(point.edge)];
    const Point x = from + point.s * (outline[(at(point.edge) + 1) % outline.size()] - from);
    const int first = 3 * point.block;  // turns are about the origin
    return {{first, first + 1, first + 2}, (Eigen::Matrix2Xd(2, 3) << 1, 0, -x.y(), 0, 1, x.x()).finished()};
  };
  Solved solved{mesh, answer_of(mesh, PressureEquation(mesh, {}, fixed, 1), moves), 0};
  for (std::size_t k = 0; k < solved.answer.modes.size(); ++k) {
    if (solved.answer.modes[k].motion == static_cast<int>(wall.outlines().size()) - 1 &&
        solved.answer.modes[k].axis == 0)
      solved.top = static_cast<Eigen::Index>(k);
  }
  return solved;
}

double force(const Solved& s) {
  return s.answer.mass(s.top, s.top);
}

TEST(ReservoirWater, ARigidWallHasWestergaardsSeries) {
  constexpr double H = 20;
  const Solved s = solve({}, 0.25);
  const auto wall = [](const BoundarySide& side) { return side.block == 1; };
  EXPECT_NEAR(pressure(s.mesh, wall, {-1, 0}, {0, 0}) / (rho * H), 0.742454, 1e-4 * 0.742454);
  EXPECT_NEAR(force(s) / (rho * H * H), 0.5427545, 1e-4 * 0.5427545);
  EXPECT_NEAR(-s.answer.mass(s.top, s.top + 2) / (rho * H * H * H), 0.217875, 1e-4 * 0.217875);
}

TEST(ReservoirWater, TheForceConvergesWithTheSquareOfTheSize) {
  const double exact = 0.54275453 * rho * 400;  // 16 zeta(3) (1 - 1/8)/pi^3
  const double coarse = std::abs(force(solve({}, 0.4)) - exact);
  const double fine = std::abs(force(solve({}, 0.1)) - exact);
  EXPECT_GT(std::log(coarse / fine) / std::log(4), 1.7);
}

TEST(ReservoirWater, AFarWallAddsToTheMass) {
  for (const auto& [depths, expected] : {std::pair{1.0, 0.58937}, {2.0, 0.54469}}) {
    EXPECT_NEAR(force(solve({.far_wall_m = -20 * depths}, 0.25)) / (rho * 400), expected, 1e-4 * expected) << depths;
  }
}

TEST(ReservoirWater, ABasinShakenAsAWholeHasTheSeriesWithTanh) {
  const Solved s = solve({.far_wall_m = -20}, 0.25);
  const Eigen::Index ground = s.answer.mass.cols() - 2;
  const double both = s.answer.mass(s.top, s.top) + s.answer.mass(s.top, ground);
  EXPECT_NEAR(both / (rho * 400), 0.36479, 1e-4 * 0.36479);
}

TEST(ReservoirWater, ThePartOfAWallAboveACrackHasItsOwnMass) {
  EXPECT_NEAR(force(solve({.H = 22, .cut_m = 15}, 0.25)), 21957, 1e-4 * 21957);
  EXPECT_NEAR(force(solve({.H = 20.57, .cut_m = 3.5}, 0.25)), 145401, 1e-4 * 145401);
}

TEST(ReservoirWater, ASlopingFaceIsPushedLess) {
  const auto check = [](double degrees, double x, double y) {
    const Solved s = solve({.lean = degrees * pi / 180}, 0.2);
    EXPECT_NEAR(force(s) / (rho * 400), x, 1.5e-4) << degrees;
    EXPECT_NEAR(std::abs(s.answer.mass(s.top, s.top + 1)) / (rho * 400), y, 1.5e-4) << degrees;
  };
  check(30, 0.3744, 0.2162);
  check(60, 0.2106, 0.3647);
}

TEST(ReservoirWater, GroundThatRisesLiftsAllOfTheWater) {
  const Solved s = solve({}, 0.4);
  double worst = 0;
  const auto ground = [](const BoundarySide& side) { return side.block == 0 || side.kind == BoundarySide::Kind::bed; };
  const auto dam = [](const BoundarySide& side) { return side.block == 1; };
  for (const double y : {0.0, 7.0, 13.0}) {
    const Point x(-90, y);
    const auto nearest = s.mesh.node.begin() + node_nearest(s.mesh, x);
    const double lifted = pressure(s.mesh, ground, {0, 1}, *nearest) + pressure(s.mesh, dam, {0, 1}, *nearest);
    worst = std::max(worst, std::abs(lifted / (rho * (20 - nearest->y())) - 1));
  }
  EXPECT_LT(worst, 1e-12);
}

TEST(ReservoirWater, TheAddedMassesOfAllBlocksAreOneSymmetricPositiveMatrix) {
  const Solved s = solve({.cut_m = 8}, 0.25);
  const auto& M = s.answer.mass;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(M);
  EXPECT_GT(modes.eigenvalues().minCoeff(), -1e-9 * modes.eigenvalues().maxCoeff());
  // Both parts together are the wall.
  EXPECT_NEAR(M(0, 0) + 2 * M(0, 3) + M(3, 3), 0.5427545 * rho * 400, 1e-4 * 217000);
}

}  // namespace
}  // namespace blockweir::reservoir::reservoir_water_test
