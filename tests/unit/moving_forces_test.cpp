// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_solve
// Flat boxes that slide down slopes, alone or one on the other, as friction lets them: Coulomb's law, which no
// associated flow has.
#include "solid/solve/moving_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace blockweir::solid::moving_forces_test {
namespace {

constexpr double enough_m = 1e-8;
constexpr double g = 9.81;

/// Of unit mass, wide by 2 and high by 2 `height`; axes along the slope and off it; d = a dt^2/2 in steps of 0.01 s.
struct Slope {
  double height;
  double slope;                  ///< tangent
  std::vector<double> friction;  ///< tangents, below each box from the lowest up

  [[nodiscard]] Eigen::VectorXd loads() const {
    Eigen::VectorXd all(3 * static_cast<Eigen::Index>(friction.size()));
    for (Eigen::Index b = 0; b < all.size(); b += 3) {
      all.segment<3>(b) = Eigen::Vector3d(slope, -1, 0) * (g / std::hypot(slope, 1));
    }
    return all;
  }
  [[nodiscard]] Matrix6 matrix() const {
    Matrix6 m = Matrix6::Identity();
    m.topLeftCorner<3, 3>().diagonal() << 2e4, 2e4, 2e4 * (1 + height * height) / 3;
    return m;
  }
  [[nodiscard]] ForceSweeps corners() const {
    const Eigen::Matrix3d flexibility = matrix().topLeftCorner<3, 3>().inverse();
    Eigen::VectorXd moved = loads();
    for (Eigen::Index b = 0; b < moved.size(); b += 3) moved.segment<3>(b) = flexibility * moved.segment<3>(b);
    ForceSweeps sweeps;
    sweeps.begin(moved, 2 * friction.size());
    for (std::size_t box = 0; box < friction.size(); ++box) {
      for (const double x : {-1.0, 1.0}) {
        Eigen::Matrix<double, 2, 3> upper;  // gap and slip of its lower corner
        upper << 0, 1, x, 1, 0, height;
        Eigen::Matrix<double, 2, 3> lower;
        lower << 0, -1, -x, -1, 0, height;
        sweeps.add_row().rule.friction = friction[box];
        const auto first = 3 * static_cast<Eigen::Index>(box);
        sweeps.add_end(false, first, upper, flexibility * upper.transpose());
        if (box > 0) sweeps.add_end(true, first - 3, lower, flexibility * lower.transpose());
      }
    }
    return sweeps;
  }
  /// Shear below a box [N per metre], where each slides on what is below it.
  [[nodiscard]] double shear(std::size_t box) const {
    return friction[box] * static_cast<double>(friction.size() - box) * g / std::hypot(slope, 1);
  }
};

struct Found {
  double left_m;
  int solutions;
  std::vector<double> shear;  ///< below each box
};

Found found(const Slope& scene) {
  const ForceSweeps corners = scene.corners();
  const std::vector<Matrix6> matrix(scene.friction.size(), scene.matrix());
  const Unknowns unknowns(std::vector<int>(scene.friction.size(), 3));
  MovingForces forces(corners, unknowns, matrix);
  Found all{.left_m = forces.find(scene.loads(), enough_m), .solutions = forces.solutions(), .shear = {}};
  for (std::size_t box = 0; box < scene.friction.size(); ++box) {
    all.shear.push_back(-(forces.force(2 * box).y() + forces.force(2 * box + 1).y()));
  }
  return all;
}

TEST(MovingForces, SlideABoxDownASlopeThatIsTooSteep) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.1, 1);
  for (int n = 0; n < 200; ++n) {
    const double friction = share(random);
    const Slope scene{share(random) / 10, friction * (1 + 3 * share(random)), {friction}};  // too flat to turn over
    const Found forces = found(scene);
    EXPECT_LE(forces.left_m, enough_m);
    EXPECT_LE(forces.solutions, 40);
    EXPECT_NEAR(forces.shear[0], scene.shear(0), 1e-3) << "friction " << friction << ", slope " << scene.slope;
  }
}

/// What slows a box, between what is below and what is above it, is the less the higher it lies.
TEST(MovingForces, SlideBoxesOnEachOther) {
  constexpr std::size_t boxes = 5;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> share(0.1, 0.9);
  for (int n = 0; n < 100; ++n) {
    std::vector<double> friction(boxes);
    double slows = 0;
    double sum = 0;
    for (std::size_t box = boxes; box-- > 0;) {
      slows += share(random) / 5;
      sum += slows;
      friction[box] = sum / static_cast<double>(boxes - box);
    }
    const Slope scene{0.02, slows + share(random), friction};
    const Found forces = found(scene);
    EXPECT_LE(forces.left_m, enough_m) << n;
    for (std::size_t box = 0; box < boxes; ++box) EXPECT_NEAR(forces.shear[box], scene.shear(box), 1e-2) << n;
  }
}

TEST(MovingForces, HoldWhatStands) {
  const Slope scene{0.1, 0.5, {0.6}};
  const Found forces = found(scene);
  EXPECT_LE(forces.left_m, enough_m);
  EXPECT_NEAR(forces.shear[0], scene.loads()[0], 1e-3);
}

}  // namespace
}  // namespace blockweir::solid::moving_forces_test
