// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// A block that slides over an edge tips about it, and leaves it at any angle as its equation of motion has it: the rear
// corner passes the edge along the block's own face.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <string>

#include "tests/verification/scenes.hpp"

namespace blockweir::solid::leaving_edges_test {
namespace {

constexpr double gravity = 9.81;
constexpr double length_m = 2;
constexpr double height_m = 0.5;

struct Leaving {
  double speed;     ///< m/s, as the centroid passes the edge
  double friction;  ///< coefficient, of a slip that goes on
  bool mirrored;
  bool movable;  ///< the table, of a great mass
};

/// (s, turn) of the face's point at the edge from below the centroid, and the force: solves the block's equations.
Eigen::Vector3d accelerations(const Eigen::Vector4d& y, double friction) {
  const Eigen::Rotation2Dd turned(y[1]);
  const Point along = turned * Point(1, 0);
  const Point up = turned * Point(0, 1);
  const Point arm = turned * Point(y[0], -height_m / 2);  // from the centroid to the edge
  const Point across(-arm.y(), arm.x());
  const Point gyrating = -2 * y[3] * y[2] * up + y[3] * y[3] * arm;
  const Point force = up - friction * along;
  Eigen::Matrix3d A;
  A << -along.x(), -across.x(), -force.x(), -along.y(), -across.y(), -force.y(), 0,
      (length_m * length_m + height_m * height_m) / 12, -(arm.x() * force.y() - arm.y() * force.x());
  return A.partialPivLu().solve(Eigen::Vector3d(-gyrating.x(), -gravity - gyrating.y(), 0));
}

/// The spin with which the rear corner passes the edge.
double right_spin(double speed, double friction) {
  constexpr double dt = 1e-5;
  const auto rate = [&](const Eigen::Vector4d& y) {
    const Eigen::Vector3d a = accelerations(y, friction);
    return Eigen::Vector4d(y[2], y[3], a[0], a[1]);
  };
  // The pressure's middle lies ahead of the centroid by friction times its height.
  Eigen::Vector4d y(friction * height_m / 2, 0, -speed, 0);
  while (y[0] > -length_m / 2) {
    const Eigen::Vector4d k1 = rate(y);
    const Eigen::Vector4d k2 = rate(y + dt / 2 * k1);
    const Eigen::Vector4d k3 = rate(y + dt / 2 * k2);
    y += dt / 6 * (k1 + 2 * k2 + 2 * k3 + rate(y + dt * k3));
  }
  return y[3];
}

double spin(const Leaving& l, double step_s) {
  auto scene = empty_scene();
  scene.analysis.start = scene::Start::unstressed;
  scene.analysis.rigid = scene::Rigid::all;
  scene.analysis.step_s = step_s;
  scene.analysis.max_displacement_ratio = 1;
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg =
      std::atan(l.friction) * 180 / std::numbers::pi;
  const double sign = l.mirrored ? -1 : 1;
  const auto box = [&](double from, double low, double to, double high) {
    return l.mirrored ? std::vector<Point>{{-to, low}, {-from, low}, {-from, high}, {-to, high}}
                      : std::vector<Point>{{from, low}, {to, low}, {to, high}, {from, high}};
  };
  if (l.movable) {
    add(scene, box(-400, -200, 0, -100), true);
    add(scene, box(-400, -100, 0, 0));
  } else {
    add(scene, box(-10, -30, 0, 0), true);
  }
  const double ahead = l.friction * height_m / 2;
  add(scene, box(-length_m / 2 - ahead, 0, length_m / 2 - ahead, height_m));
  scene.blocks.back().initial_velocity_m_per_s = Point(sign * l.speed, 0);
  Solid solid(scene);
  run(solid, 1.3 * length_m / l.speed);
  return sign * solid.states().back().velocity[2];
}

std::string text(const Leaving& l) {
  return std::to_string(l.speed) + " m/s, friction " + std::to_string(l.friction) + (l.mirrored ? ", mirrored" : "") +
         (l.movable ? ", off a movable block" : "");
}

TEST(LeavingEdges, ABlockKeepsTheSpinThatItHasTippedTo) {
  for (const double speed : {3.0, 4.0, 4.5, 5.0, 6.0, 8.0, 12.0}) {
    for (const double degrees : {0.0, 2.0, 10.0}) {
      const double friction = std::tan(degrees * std::numbers::pi / 180);
      const double right = right_spin(speed, friction);
      for (const bool mirrored : {false, true}) {
        for (const bool movable : {false, true}) {
          const Leaving leaving{speed, friction, mirrored, movable};
          EXPECT_NEAR(spin(leaving, 1e-3) / right, 1, 0.015) << text(leaving);
        }
      }
    }
  }
}

TEST(LeavingEdges, TheShorterTheStepTheNearer) {
  for (const double speed : {4.5, 6.0, 8.0}) {
    EXPECT_NEAR(spin({speed, 0, false, false}, 1e-4) / right_spin(speed, 0), 1, 0.001) << speed << " m/s";
  }
}

}  // namespace
}  // namespace blockweir::solid::leaving_edges_test
