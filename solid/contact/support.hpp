// SPDX-License-Identifier: GPL-3.0-or-later
// A point of a block that is held or led along a given path, by the same multipliers as a contact.
#pragma once

#include "bridge/scene/scene.hpp"
#include "solid/contact/interaction.hpp"
#include "solid/contact/joint_law.hpp"

namespace blockweir::solid {

struct Support {
  static constexpr ContactState state = ContactState::stick;  ///< always

  int block = 0;
  Point material;  ///< m, relative to the centroid
  const scene::Support* described = nullptr;

  Point separation = Point::Zero();  ///< from where the point should be at the end of the step [m]
  Point led = Point::Zero();         ///< by its target and the base in the step [m]
  Point multiplier = Point::Zero();  ///< force on the block [N per metre]
  Point force = Point::Zero();       ///< what acts: multiplier less penalty times separation
  Point inertial = Point::Zero();    ///< its part in mass times acceleration: the force, but for generalized-alpha
  double penalty = 0;
  Point stood = Point::Zero();  ///< the target that the last step has led it to [m]
  double share = 1;             ///< of the way to the target: a static analysis begins with the point as drawn

  [[nodiscard]] Point target(double time_s) const {
    const auto& [bx, by] = std::pair(described->displacement_x_m, described->displacement_y_m);
    return share * Point(bx ? bx->at(time_s) : 0.0, by ? by->at(time_s) : 0.0);
  }
  /// Of the target about the time [m/s]. In a row of a table it is the mean of before and after: that before would lag
  /// behind a motion whose rows are as far apart as steps.
  [[nodiscard]] Point target_rate(double time_s, double dt) const {
    const double shortly = 1e-3 * dt;
    return (target(time_s + shortly) - target(time_s - shortly)) / (2 * shortly);
  }
  [[nodiscard]] Point held() const {
    return {described->displacement_x_m ? 1.0 : 0.0, described->displacement_y_m ? 1.0 : 0.0};
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(separation, multiplier, force, inertial, penalty, stood, share);
  }
};

}  // namespace blockweir::solid
