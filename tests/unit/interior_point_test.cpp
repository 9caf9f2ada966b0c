// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_contact
// States that the interior point method finds for a rigid block on level ground under a load with a normal and a
// tangential part, as on a slope.
#include "solid/contact/interior_point.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "solid/contact/search.hpp"

namespace blockweir::solid::interior_point_test {
namespace {

constexpr double friction = 0.5;
constexpr double weight = 1e4;   // N per metre
constexpr double inertia = 1e9;  // N/m per metre: what resists a motion beside contacts

scene::Scene block_on_ground() {
  scene::Scene scene;
  scene.materials.push_back({"rock", 20e9, 0.2, 2000});
  scene.default_joint.friction_angle_deg = std::atan(friction) * 180 / std::numbers::pi;
  scene.default_joint.residual_friction_angle_deg = scene.default_joint.friction_angle_deg;
  scene.blocks.push_back({.name = "ground", .vertices = {{-5, -1}, {5, -1}, {5, 0}, {-5, 0}}, .fixed = true});
  scene.blocks.push_back({.name = "block", .vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  scene.analysis.rigid = scene::Rigid::all;
  return scene;
}

/// Newton's method as a step has it, on the three unknowns of the block.
class Found {
 public:
  Found(const Eigen::Vector3d& load, int most_corrections) {
    for (const Block& block : parts_.blocks) placement_.emplace_back(block.centroid, Vector6::Zero());
    start_ = placement_;
    ContactSearch(parts_, laws_, 1, 0.05, 0.05).update(placement_, contacts);
    for (ContactPoint& c : contacts) c.force = {weight / 2, 0};
    std::vector<int> ids(contacts.size());
    for (std::size_t k = 0; k < ids.size(); ++k) ids[k] = static_cast<int>(k);
    std::vector<Support> supports;
    const IslandContacts island{ids, contacts, {}, supports};
    method_.begin(trial(), {Matrix6::Identity(), inertia * Matrix6::Identity()}, {true, false}, island);
    for (corrections = 0; corrections < most_corrections; ++corrections) {
      Eigen::Vector3d left = residual(load);
      converged = left.cwiseAbs().maxCoeff() <= 1e-8 * weight;
      if (converged) break;
      const Eigen::Vector3d aimed_at_zero = matrix_.lu().solve(left);
      move(aimed_at_zero);
      method_.predict(trial(), island);
      move(-aimed_at_zero);
      left = residual(load);
      const Eigen::Vector3d correction = matrix_.lu().solve(left);
      move(correction);
      fraction = method_.follow_correction(trial(), island);
      all_within = all_within && fraction > 0 && fraction <= 1;
      move((fraction - 1) * correction);
    }
    method_.hand_over(island);
  }

  /// Of all contacts, on the block: along the ground and upward [N per metre].
  [[nodiscard]] Eigen::Vector2d reaction() const {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const ContactPoint& c : contacts) sum += Eigen::Vector2d(-c.multiplier.y(), c.multiplier.x());
    return sum;  // the ground's upper edge runs to the left
  }
  [[nodiscard]] bool all_are(ContactState state) const {
    return std::all_of(contacts.begin(), contacts.end(), [&](const ContactPoint& c) { return c.state == state; });
  }
  [[nodiscard]] const Vector6& motion() const { return increment_[1]; }

  std::vector<ContactPoint> contacts;
  int corrections = 0;
  double fraction = 0;
  bool converged = false;
  bool all_within = true;  ///< each fraction in (0, 1]

 private:
  [[nodiscard]] Trial trial() const { return {parts_.blocks, start_, increment_, turn_, placement_, still_, 0}; }
  void move(const Eigen::Vector3d& by) {
    increment_[1].head<3>() += by;
    turn_[1] = Turn(increment_[1][2]);
    placement_[1] = Placement(parts_.blocks[1].centroid, increment_[1]);
  }
  Eigen::Vector3d residual(const Eigen::Vector3d& load) {
    matrix_ = inertia * Eigen::Matrix3d::Identity();
    Eigen::Vector3d left = load - inertia * increment_[1].head<3>();
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const Interaction action = method_.contact(trial(), static_cast<int>(k), contacts[k]);
      const Eigen::Matrix<double, 2, 3> shape = action.shape(placement_[1], false).leftCols<3>();
      left += shape.transpose() * action.force;
      matrix_ += shape.transpose() * action.stiffness * shape;
    }
    return left;
  }

  const scene::Scene scene_ = block_on_ground();
  const MovingParts parts_ = make_moving_parts(scene_);
  const JointLaws laws_{scene_};
  InteriorPoint method_{laws_, {}};
  std::vector<Placement> start_;
  std::vector<Placement> placement_;
  std::vector<Vector6> increment_{2, Vector6::Zero()};
  std::vector<Turn> turn_{2};
  std::vector<Vector6> still_{2, Vector6::Zero()};
  Eigen::Matrix3d matrix_;
};

constexpr int enough = 60;

TEST(InteriorPoint, ABlockThatFrictionHoldsSticks) {
  const Found found({0.3 * weight, -weight, 0}, enough);
  ASSERT_TRUE(found.converged);
  EXPECT_TRUE(found.all_are(ContactState::stick));
  EXPECT_NEAR(found.reaction().x() / weight, -0.3, 1e-6);
  EXPECT_NEAR(found.reaction().y() / weight, 1, 1e-6);
  EXPECT_LT(found.motion().norm(), 1e-3 * weight / inertia);
}

/// Inertia takes up what friction does not.
TEST(InteriorPoint, ABlockThatFrictionDoesNotHoldSlipsEitherWay) {
  for (const double sign : {-1.0, 1.0}) {
    const Found found({sign * 0.8 * weight, -weight, 0}, enough);
    ASSERT_TRUE(found.converged) << sign;
    EXPECT_TRUE(found.all_are(ContactState::slip)) << sign;
    EXPECT_NEAR(found.reaction().x() / weight, -sign * friction, 1e-6);
    EXPECT_NEAR(found.reaction().y() / weight, 1, 1e-6);
    EXPECT_NEAR(found.motion().x() * inertia / weight, sign * (0.8 - friction), 1e-6);
  }
}

TEST(InteriorPoint, ABlockThatIsLiftedOpens) {
  const Found found({0, 0.2 * weight, 0}, enough);
  ASSERT_TRUE(found.converged);
  EXPECT_TRUE(found.all_are(ContactState::open));
  EXPECT_EQ(found.reaction(), Eigen::Vector2d(0, 0));
  EXPECT_NEAR(found.motion().y() * inertia / weight, 0.2, 1e-6);
}

/// Whoever stops too early has forces that Coulomb's law admits, in some states, and may begin with them.
TEST(InteriorPoint, StoppedBeforeItHasConvergedItHandsOverWhatIsAdmissible) {
  for (int most = 0; most < 8; ++most) {
    const Found found({0.8 * weight, -weight, 0}, most);
    EXPECT_EQ(found.corrections, most);
    EXPECT_FALSE(found.converged) << most;
    EXPECT_TRUE(found.all_within) << most;
    for (const ContactPoint& c : found.contacts) {
      EXPECT_GE(c.multiplier.x(), 0) << most;
      EXPECT_LE(std::abs(c.multiplier.y()), friction * c.multiplier.x() * (1 + 1e-12)) << most;
    }
  }
}

}  // namespace
}  // namespace blockweir::solid::interior_point_test
