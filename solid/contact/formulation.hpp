// SPDX-License-Identifier: GPL-3.0-or-later
// How contacts and supports are enforced: the interface that penalty, Lagrange multipliers and the augmented Lagrangian
// share.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "bridge/scene/scene.hpp"
#include "solid/contact/force_constraints.hpp"
#include "solid/contact/force_rule.hpp"
#include "solid/contact/joint_laws.hpp"
#include "solid/contact/lagged_friction.hpp"
#include "solid/contact/memory_before.hpp"
#include "solid/contact/step_progress.hpp"
#include "solid/contact/trial.hpp"

namespace blockweir::solid {

struct FormulationSettings {
  double penetration_tolerance_m = 1e-9;
  double force_tolerance_n = 1e-4;  ///< N per metre
  double position_round_off_m = 0;  ///< separations below this are zero, as coordinates know no better
  /// That a gap may have without asking for another sweep: one that closes it leaves others a little wider, and among
  /// hundreds of contacts there is always one beyond a single round-off.
  double closed_round_offs = 4;
  std::optional<double> initial_penalty;    ///< augmented Lagrangian; N/m per metre
  std::optional<double> contact_stiffness;  ///< penalty method; N/m per metre
  double dashpot_ratio = 0;                 ///< penalty method; of critical damping
  double largest_modulus_pa = 0;            ///< of the scene's materials
  double penalty_ratio = 1e4;               ///< penalty a step starts with, over the blocks' own stiffness
  bool joints_held = false;                 ///< every contact in touch sticks, whatever its law says
  bool friction_lags = false;               ///< shear is bounded by what lag_friction found, whatever acts now
  bool states_stand = false;                ///< contacts without a bond to lose keep their states, whatever acts now
  bool swept = false;                       ///< overlap at the start of the step is not closed in it
  double lasting_overlap_m = 0;             ///< what overlaps by more as a step begins is not closed in it; 0: all is
};

class Formulation {
 public:
  virtual ~Formulation() = default;

  /// A step of an island; `matrix[b]` is block b's own matrix in it (inertia and elasticity). Frozen blocks do not
  /// move.
  virtual void begin(const Trial& trial, const std::vector<Matrix6>& matrix, const std::vector<bool>& frozen,
                     const IslandContacts& island);

  /// Contacts begin with the forces that they ended the step before with, to the last digit.
  virtual void keep_forces(const Trial& /*trial*/, const IslandContacts& /*island*/) {}

  /// Admissible force of contact `index` at the trial positions, with its linearization; sets the contact's state. May
  /// be asked for several contacts at a time.
  virtual Interaction contact(const Trial& trial, int index, ContactPoint& point) = 0;
  virtual Interaction support(const Trial& trial, int index, Support& point) = 0;

  /// Called in equilibrium: true when contacts and supports are within tolerance; else their memory was updated and
  /// equilibrium is to be found again.
  virtual bool sweep(const IslandContacts& island) = 0;

  /// Distance of the forces from those of a converged sweep [N per metre]; equilibrium need not be found much more
  /// accurately before that.
  [[nodiscard]] virtual double unsettled(const IslandContacts& /*island*/) const { return 0; }

  /// Where shear can be bounded by normal forces that lag; else null.
  [[nodiscard]] virtual LaggedFriction* lagged_friction() { return nullptr; }
  /// Where forces are unknowns of the system; else null.
  [[nodiscard]] virtual const ForceConstraints* force_constraints() const { return nullptr; }

  /// For a solver of forces: resistance of a contact or support at the trial, and the bounds of its forces. `edge`: the
  /// contact's at the trial.
  virtual Ruled ruled_contact(const Trial& trial, int index, const ContactPoint& c, const EdgeFrame& edge);
  virtual Ruled ruled_support(const Trial& trial, int index, const Support& s);
  /// Applies the forces found by that solver, with the corresponding state.
  virtual Interaction take_contact(const Trial& trial, int index, ContactPoint& c, const RuledForce& found);
  Interaction take_support(const Trial& trial, int index, Support& s, const Eigen::Vector2d& force);

  /// Gap of a contact under the force that it has: a spring gives way [m].
  [[nodiscard]] virtual double gap_under_force_m(const ContactPoint& /*c*/) const { return 0; }

  /// Is a velocity along a closed contact an error of the time integration? Not where contacts are springs.
  [[nodiscard]] virtual bool holds_exactly() const { return true; }

  /// Undoes the step: contacts and supports get back their memory of its start.
  void undo(const IslandContacts& island) const { before_.restore(island); }
  /// Slip, dilation and anchors of an accepted step; does any contact slip?
  bool accept(const Trial& trial, const IslandContacts& island) const;

  /// As the step began.
  [[nodiscard]] const MemoryBefore& before() const { return before_; }
  [[nodiscard]] StepProgress& progress() { return progress_; }
  [[nodiscard]] const StepProgress& progress() const { return progress_; }

  FormulationSettings& settings() { return settings_; }

 protected:
  Formulation(const JointLaws& laws, const FormulationSettings& settings)
      : laws_(laws), settings_(settings), progress_(laws), lagged_(laws) {}

  /// What a formulation does of its own as a step begins; of several contacts at a time.
  virtual void begin_contact(const Trial& trial, const std::vector<bool>& frozen, int index, ContactPoint& c) = 0;
  virtual void begin_support(const Trial& trial, int index, Support& s) = 0;

  /// State and admissible force from those that would act if the contact stuck.
  JointForce judge(int index, ContactPoint& c, const Eigen::Vector2d& stuck);

  const JointLaws& laws_;
  FormulationSettings settings_;
  StepProgress progress_;
  LaggedFriction lagged_;

 private:
  [[nodiscard]] bool goes_along(const ContactPoint& c, const Progress& progress) const;

  MemoryBefore before_;
};

std::unique_ptr<Formulation> make_penalty(const JointLaws& laws, const FormulationSettings& settings);
std::unique_ptr<Formulation> make_lagrange_multiplier(const JointLaws& laws, const FormulationSettings& settings);
std::unique_ptr<Formulation> make_augmented_lagrangian(const JointLaws& laws, const FormulationSettings& settings);
std::unique_ptr<Formulation> make_formulation(scene::ContactFormulation which, const JointLaws& laws,
                                              const FormulationSettings& settings);

}  // namespace blockweir::solid
