// SPDX-License-Identifier: GPL-3.0-or-later
// How contacts and supports are enforced: the interface that penalty, Lagrange multipliers and the augmented Lagrangian
// share.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "bridge/scene/scene.hpp"
#include "solid/contact/force_rule.hpp"
#include "solid/contact/joint_laws.hpp"
#include "solid/contact/lagged_bounds.hpp"
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
  bool swept = false;                       ///< what overlaps as the step begins is not closed in it, whoever left it
  double lasting_overlap_m = 0;             ///< what overlaps by more as a step begins is not closed in it; 0: all is
};

/// What an island hands over: indices of its contacts and supports, and all of them.
struct Held {
  std::span<const int> contact_ids;
  std::vector<ContactPoint>& contacts;
  std::span<const int> support_ids;
  std::vector<Support>& supports;
};

class Formulation {
 public:
  virtual ~Formulation() = default;

  /// A step of an island; `matrix[b]` is block b's own matrix in it (inertia and elasticity). Frozen blocks do not
  /// move.
  virtual void begin(const Trial& trial, const std::vector<Matrix6>& matrix, const std::vector<bool>& frozen,
                     const Held& held);

  /// Contacts begin with the forces that they ended the step before with, to the last digit.
  virtual void keep_forces(const Trial& /*trial*/, const Held& /*held*/) {}

  /// Admissible force of contact `index` at the trial positions, with its linearization; sets the contact's state. May
  /// be asked for several contacts at a time.
  virtual Interaction contact(const Trial& trial, int index, ContactPoint& point) = 0;
  virtual Interaction support(const Trial& trial, int index, Support& point) = 0;

  /// Called in equilibrium: true when contacts and supports are within tolerance; else their memory was updated and
  /// equilibrium is to be found again.
  virtual bool sweep(const Held& held) = 0;

  /// How far forces still are from those that a sweep would leave alone [N per metre]; equilibrium need not be found
  /// much more closely before it.
  [[nodiscard]] virtual double unsettled(const Held& /*held*/) const { return 0; }

  /// Can shear be bounded by normal forces that lag?
  [[nodiscard]] virtual bool can_lag_friction() const { return false; }
  /// Bounds of shear by the normal forces of now, until the next call of this or the following.
  void lag_friction(const Held& held);
  /// Bounds of shear nearer to what the normal forces of now allow: true when they were there.
  bool follow_with_friction(const Held& held);

  /// Where forces are unknowns of the system: what they fulfil, as the last contact() or support() has it.
  [[nodiscard]] virtual std::span<const Constraint> constraints_of_contact(int /*index*/) const { return {}; }
  [[nodiscard]] virtual std::span<const Constraint> constraints_of_support(int /*index*/) const { return {}; }
  [[nodiscard]] virtual bool solves_for_forces() const { return false; }
  /// Their correction, as solved for.
  virtual void correct_contact(int /*index*/, ContactPoint& /*point*/, const Eigen::Vector2d& /*force*/) {}
  virtual void correct_support(int /*index*/, Support& /*point*/, const Eigen::Vector2d& /*force*/) {}

  /// For a solver of forces: what a contact or support resists at the trial, and what bounds its forces.
  virtual Ruled ruled_contact(const Trial& trial, int index, const ContactPoint& c);
  virtual Ruled ruled_support(const Trial& trial, int index, const Support& s);
  /// What that solver has found acts, with the state that goes with it.
  virtual Interaction take_contact(const Trial& trial, int index, ContactPoint& c, const RuledForce& found);
  Interaction take_support(const Trial& trial, int index, Support& s, const Eigen::Vector2d& force);

  /// Gap of a contact under the force that it has: a spring gives way [m].
  [[nodiscard]] virtual double gap_under_force_m(const ContactPoint& /*c*/) const { return 0; }

  /// Is a velocity along a closed contact an error of the time integration? Not where contacts are springs.
  [[nodiscard]] virtual bool holds_exactly() const { return true; }

  /// The step is not to be: what contacts and supports remember is what they did as it began.
  void undo(const Held& held) const;
  /// Slip, dilation and anchors of an accepted step; does any contact slip?
  bool accept(const Trial& trial, const Held& held) const;

  /// Has any contact closed, opened, begun or ceased to slip, or turned its slip round in the step?
  [[nodiscard]] bool changed(const Held& held) const;
  /// d(gap)/d(slip) of a contact of the step: what dilates opens as it slips.
  [[nodiscard]] double opening_slope(int index, const ContactPoint& c) const {
    return -dilation_slope(c, contacts_[static_cast<std::size_t>(index)]);
  }
  /// By how much the energy of what is a spring has risen in the step [J per metre].
  [[nodiscard]] virtual double stored(int /*index*/, const ContactPoint& /*c*/) const { return 0; }
  [[nodiscard]] virtual double stored(int /*index*/, const Support& /*s*/) const { return 0; }
  /// As the step began.
  [[nodiscard]] const ContactMemory& before(int index) const {
    return contacts_before_[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] const Support& support_before(int index) const {
    return supports_before_[static_cast<std::size_t>(index)];
  }

  FormulationSettings& settings() { return settings_; }
  /// Counted up by one for each contact whose state differs from the evaluation before.
  [[nodiscard]] long state_changes() const { return state_changes_; }

  template <class Archive>
  void serialize(Archive& archive) {
    long changes = state_changes_;
    archive(changes);
    state_changes_ = changes;
  }

 protected:
  Formulation(const JointLaws& laws, const FormulationSettings& settings) : laws_(laws), settings_(settings) {}

  /// Of a contact or support, in the step at hand.
  struct Progress {
    Eigen::Vector2d separation = Eigen::Vector2d::Zero();  ///< that is resisted, at the trial [m]
    double round_off = 0;                                  ///< uncertainty of the force [N per metre]
    double slip_force = 0;  ///< shear force of the evaluation before, whose sign is the direction of slip
    double last_violation = std::numeric_limits<double>::infinity();  ///< at the sweep before
    double stiffness = 0;  ///< of the blocks against the contact [N/m per metre]
    double overlap = 0;    ///< as the step began, not above zero: where its gap aims [m]
    bool swept = false;    ///< its forces are a sweep's: of what sticks some slip may be left
    bool turning = false;  ///< slip was about to reverse and is tried as stick; not a state to end in

    /// The largest part of the separation that should be zero in this state; a support sticks.
    [[nodiscard]] double violation(ContactState state) const {
      return std::max(state == ContactState::open ? 0 : std::abs(separation.x()),
                      state == ContactState::stick ? std::abs(separation.y()) : 0);
    }
  };

  /// What a formulation does of its own as a step begins; of several contacts at a time.
  virtual void begin_contact(const Trial& trial, const std::vector<bool>& frozen, int index, ContactPoint& c) = 0;
  virtual void begin_support(const Trial& trial, int index, Support& s) = 0;

  /// Separation that the contact resists: the gap less what dilation has opened, and the slip.
  Progress& follow(const Trial& trial, int index, const ContactPoint& c, const EdgeFrame& edge);
  Progress& follow(const Trial& trial, int index, const Support& s);
  Progress& follow_dilation(const Trial& trial, const ContactPoint& c, const EdgeFrame& edge, Progress& progress) const;

  /// State and admissible force from those that would act if the contact stuck.
  JointForce judge(int index, ContactPoint& c, const Eigen::Vector2d& stuck);

  /// By which iterates judge: only forces that have converged open a bond (pull_off).
  [[nodiscard]] Strength iterated_strength(const ContactPoint& c, double normal) const;

  /// d(resisted gap)/d(slip) of a slipping contact that dilates; else 0.
  [[nodiscard]] double dilation_slope(const ContactPoint& c, const Progress& progress) const;

  const JointLaws& laws_;
  FormulationSettings settings_;
  std::vector<Progress> contacts_;
  std::vector<Progress> supports_;
  LaggedBounds bounds_;  ///< while friction lags

 private:
  [[nodiscard]] double shear_bound(const ContactPoint& c) const;

  std::vector<ContactMemory> contacts_before_;  ///< as the step began
  std::vector<Support> supports_before_;
  std::atomic<long> state_changes_ = 0;
};

std::unique_ptr<Formulation> make_penalty(const JointLaws& laws, const FormulationSettings& settings);
std::unique_ptr<Formulation> make_lagrange_multiplier(const JointLaws& laws, const FormulationSettings& settings);
std::unique_ptr<Formulation> make_augmented_lagrangian(const JointLaws& laws, const FormulationSettings& settings);
std::unique_ptr<Formulation> make_formulation(scene::ContactFormulation which, const JointLaws& laws,
                                              const FormulationSettings& settings);

}  // namespace blockweir::solid
