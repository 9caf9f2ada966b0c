// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_solve
// A box on a slope: it stands where friction lets it, by forces that balance it inside their cones.
#include "solid/solve/standing_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace blockweir::solid::standing_forces_test {
namespace {

constexpr double enough_m = 1e-7;

/// Of unit mass, wide by 2 and high by 2 `height`; axes along the slope and off it; steps of 0.01 s.
struct Box {
  double height;
  double slope;     ///< tangent
  double friction;  ///< tangent

  [[nodiscard]] Eigen::Vector3d load() const { return Eigen::Vector3d(slope, -1, 0) * (9.81 / std::hypot(slope, 1)); }
  [[nodiscard]] Matrix6 matrix() const {
    Matrix6 m = Matrix6::Identity();
    m.topLeftCorner<3, 3>().diagonal() << 1e4, 1e4, 1e4 * (1 + height * height) / 3;
    return m;
  }
  [[nodiscard]] Eigen::Matrix<double, 2, 3> motions(double x) const {
    Eigen::Matrix<double, 2, 3> rows;  // gap, slip of a lower corner
    rows << 0, 1, x, 1, 0, height;
    return rows;
  }
  [[nodiscard]] ForceSweeps corners() const {
    const Eigen::Matrix3d flexibility = matrix().topLeftCorner<3, 3>().inverse();
    ForceSweeps sweeps;
    sweeps.begin(flexibility * load(), 2);
    for (const double x : {-1.0, 1.0}) {
      sweeps.add_row().rule.friction = friction;
      sweeps.add_end(false, 0, motions(x), flexibility * motions(x).transpose());
    }
    return sweeps;
  }
};

TEST(StandingForces, HoldABoxOnASlopeWhereFrictionLetsThem) {
  constexpr double close = 1e-2;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.1, 2);
  const Unknowns unknowns({3});
  int standing = 0;
  for (int n = 0; n < 300; ++n) {
    const Box box{share(random) / 5, share(random), share(random)};  // too flat to turn over
    if (std::abs(box.slope / box.friction - 1) < close) continue;
    const ForceSweeps corners = box.corners();
    const std::vector<Matrix6> matrix = {box.matrix()};
    StandingForces forces(corners, unknowns, matrix);
    const bool stands = forces.found(box.load(), enough_m);
    ASSERT_EQ(stands, box.slope < box.friction)
        << "height " << box.height << ", slope " << box.slope << ", friction " << box.friction;
    EXPECT_LE(forces.solutions(), 30);
    if (!stands) continue;
    ++standing;
    Eigen::Vector3d left = box.load();
    for (const std::size_t row : {0U, 1U}) {
      const Eigen::Vector2d force = forces.force(row);
      EXPECT_GE(force.x(), 0);
      EXPECT_LE(std::abs(force.y()), box.friction * force.x());
      left += box.motions(row == 0 ? -1 : 1).transpose() * force;
    }
    EXPECT_LE(left.cwiseAbs().maxCoeff(), 1e-4 * 9.81);
  }
  EXPECT_GT(standing, 50);
}

TEST(StandingForces, LetATallBoxTurnOnTheCornerThatSticks) {
  const Box box{3, 0.5, 1};
  const ForceSweeps corners = box.corners();
  const std::vector<Matrix6> matrix = {box.matrix()};
  const Unknowns unknowns({3});
  StandingForces forces(corners, unknowns, matrix);
  EXPECT_TRUE(forces.found(box.load(), enough_m));
  EXPECT_LE(forces.force(0).x(), 1e-4);
  EXPECT_GT(forces.force(1).x(), 1);
}

TEST(StandingForces, AreForDryJointsThatDoNotDilate) {
  EXPECT_TRUE(ForceRule({.friction = 0.5}).is_dry());
  EXPECT_FALSE(ForceRule({.friction = 0.5, .cohesion = 1}).is_dry());
  EXPECT_FALSE(ForceRule({.friction = 0.5, .least_normal = -1}).is_dry());
  EXPECT_FALSE(ForceRule({.friction = 0.5, .opening = {0.1, 0}}).is_dry());
  EXPECT_FALSE(ForceRule({.friction = 0.5, .compliance = {1e-9, 0}}).is_dry());
}

}  // namespace
}  // namespace blockweir::solid::standing_forces_test
