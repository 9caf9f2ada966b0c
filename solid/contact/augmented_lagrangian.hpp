// SPDX-License-Identifier: GPL-3.0-or-later
// Augmented Lagrangian (7)-(8): force = multiplier - penalty * separation, multiplier <- force, until the
// penetration is below its tolerance and the forces have stopped moving.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "bridge/scene/scene.hpp"
#include "solid/contact/contact_point.hpp"
#include "solid/contact/interaction.hpp"
#include "solid/contact/joint_laws.hpp"
#include "solid/contact/support.hpp"

namespace blockweir::solid {

/// The blocks as a step tries to move them.
struct Trial {
  const std::vector<Block>& blocks;
  const std::vector<Placement>& start;      ///< at the start of the step
  const std::vector<Vector6>& increment;    ///< tried so far
  const std::vector<Placement>& placement;  ///< start plus increment
};

struct MultiplierSettings {
  double penetration_tolerance_m = 1e-9;
  double force_tolerance_n = 1e-4;        ///< N per metre
  double position_round_off_m = 0;        ///< separations below this are zero, as coordinates know no better
  std::optional<double> initial_penalty;  ///< N/m per metre; default: 100 times the blocks' own stiffness
  double penalty_ratio = 1e4;             ///< penalty a step starts with, over the blocks' own stiffness
  bool joints_held = false;               ///< every contact in touch sticks, whatever its law says
};

class AugmentedLagrangian {
 public:
  AugmentedLagrangian(const JointLaws& laws, const MultiplierSettings& settings) : laws_(laws), settings_(settings) {}

  MultiplierSettings& settings() { return settings_; }

  /// Bounds each penalty by the stiffness with which the blocks themselves resist at the contact; `matrix[b]` is
  /// block b's own matrix in this step (inertia and elasticity). Frozen blocks do not move.
  void begin_step(const Trial& trial, const std::vector<Matrix6>& matrix, const std::vector<bool>& frozen,
                  std::vector<ContactPoint>& contacts, std::vector<Support>& supports);

  /// Admissible force of contact `index` at the trial positions, with its linearization; sets the contact's state.
  Interaction contact(const Trial& trial, int index, ContactPoint& point);
  Interaction support(const Trial& trial, int index, Support& point);

  /// One sweep (8) over the given contacts and supports, to be called in equilibrium. True when all were already
  /// within tolerance; else multipliers are updated, and penalties whose gap did not shrink fourfold are raised.
  bool sweep(const std::vector<int>& contact_ids, std::vector<ContactPoint>& contacts,
             const std::vector<int>& support_ids, std::vector<Support>& supports);

  /// Breaks the bonds that the converged forces exceed; true if there were any. A contact that opens has lost its
  /// own. In shear the joint of two blocks breaks as a whole, once no contact of it sticks: before, one that slips
  /// hands its share to the others, wherever along the joint the bond is.
  bool break_bonds(const std::vector<int>& contact_ids, std::vector<ContactPoint>& contacts) const;

  /// Slip and anchors of an accepted step.
  void accept(const Trial& trial, std::vector<ContactPoint>& contacts);

  /// Counted up by one for each contact whose state differs from the evaluation before.
  [[nodiscard]] long state_changes() const { return state_changes_; }

 private:
  /// Per contact or support, for the step at hand.
  struct Progress {
    Eigen::Vector2d separation = Eigen::Vector2d::Zero();  ///< (gap, slip) at the trial [m]
    Eigen::Vector2d force = Eigen::Vector2d::Zero();       ///< admissible force there
    Eigen::Vector2d violated = Eigen::Vector2d::Zero();    ///< part of the separation that should be zero
    double round_off = 0;                                  ///< uncertainty of the force [N per metre]
    double slip_force = 0;  ///< shear force of the evaluation before, whose sign is the direction of slip
    bool turning = false;   ///< slip was about to reverse and is tried as stick; not a state to end in
    double last_violation = std::numeric_limits<double>::infinity();  ///< at the sweep before
    double stiffness = 0;  ///< of the blocks against the contact [N/m per metre]
  };
  [[nodiscard]] Strength strength(const ContactPoint& point) const;
  [[nodiscard]] bool settled(const Progress& p, const Eigen::Vector2d& multiplier) const;
  void raise_if_slow(Progress& progress, double& penalty) const;
  [[nodiscard]] double bounded_penalty(double kept, double stiffness) const;

  const JointLaws& laws_;
  MultiplierSettings settings_;
  std::vector<Progress> contacts_;
  std::vector<Progress> supports_;
  long state_changes_ = 0;
};

}  // namespace blockweir::solid
