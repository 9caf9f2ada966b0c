// SPDX-License-Identifier: GPL-3.0-or-later
// The DDA solid: blocks, contacts and the time step that moves them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bridge/scene/scene.hpp"
#include "solid/block/base_motion.hpp"
#include "solid/block/loads.hpp"
#include "solid/block/water_course.hpp"
#include "solid/contact/bolt.hpp"
#include "solid/contact/bonds.hpp"
#include "solid/contact/coulomb_forces.hpp"
#include "solid/contact/formulation.hpp"
#include "solid/contact/search.hpp"
#include "solid/solve/force_sweeps.hpp"
#include "solid/solve/incidence.hpp"
#include "solid/solve/islands.hpp"
#include "solid/solve/saddle_point.hpp"
#include "solid/step/added_mass_guard.hpp"
#include "solid/step/counts.hpp"
#include "solid/step/energy_balance.hpp"
#include "solid/step/newmark.hpp"
#include "solid/step/sleep.hpp"
#include "solid/step/step_mode.hpp"
#include "solid/step/water_work.hpp"

namespace blockweir::solid {

class Solid {
 public:
  explicit Solid(const scene::Scene& scene);

  /// Lets weight and first loads settle with all joints held, then releases them: the state at time 0.
  /// Throws SolveError when no equilibrium is found.
  void settle(const std::vector<Panel>& water);

  /// `meanwhile` is called as each step begins and after each solution of a linear system, of the start and of steps;
  /// what it throws ends the run, and the solid is of no more use.
  void call_meanwhile(std::function<void()> meanwhile) { meanwhile_ = std::move(meanwhile); }

  /// What the water that acts in a window answers: the inertia in its forces, for the added-mass guard of dynamic
  /// analyses where the scene has it on, with velocities (u0, v0, r0) of the scene's blocks and the time that it was
  /// told.
  struct Answered {
    const AddedMasses& masses;
    const std::vector<Eigen::Vector3d>& velocities;
    double time_s;
  };
  /// Moves the blocks from `from_s` to `to_s` under the given water, in as many steps as accuracy asks for.
  void advance(double from_s, double to_s, WaterCourse& water, const Answered& answered);
  /// The same under water that is held, and answers the velocities that the blocks have now.
  void advance(double from_s, double to_s, const std::vector<Panel>& water, const AddedMasses& masses = {});

  [[nodiscard]] const scene::Scene& scene() const { return scene_; }
  [[nodiscard]] const Parts& parts() const { return parts_; }
  /// The scene's blocks in its order, then the triangles of meshes; so are states and placements. A block with a mesh
  /// has the mean motion of its triangles.
  [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }
  [[nodiscard]] std::size_t described() const { return scene_.blocks.size(); }  ///< number of the scene's blocks
  [[nodiscard]] const std::vector<BlockState>& states() const { return states_; }
  [[nodiscard]] const std::vector<Placement>& placements() const { return start_; }
  [[nodiscard]] const std::vector<ContactPoint>& contacts() const { return contacts_; }
  /// Rate of the six unknowns, of a triangle as of any block.
  [[nodiscard]] Vector6 velocity(std::size_t b) const { return rate(b, start_[b], states_[b].velocity); }
  /// Where the vertex of a contact is now [m].
  [[nodiscard]] Point place(const ContactPoint& c) const {
    return start_[static_cast<std::size_t>(c.vertex_part)].position(c.vertex_at);
  }
  [[nodiscard]] const std::vector<Bolt>& bolts() const { return bolts_; }
  [[nodiscard]] const JointLaws& laws() const { return laws_; }
  [[nodiscard]] const BaseMotion& base() const { return base_; }
  /// Of a static analysis, as the last advance left it.
  [[nodiscard]] const Rest& rest() const { return rest_; }
  [[nodiscard]] const WaterWork& water_work() const { return water_work_; }
  [[nodiscard]] const EnergyBalance& energy_balance() const { return energy_balance_; }
  [[nodiscard]] Counts counts() const;
  [[nodiscard]] const Profile& profile() const { return profile_; }
  [[nodiscard]] double weight_n_per_m() const { return force_scale_; }  ///< of all that can move
  [[nodiscard]] double size_m() const { return size_; }  ///< half the height of what can move, at least half its width

  /// Largest displacement of any vertex since the scene's outline, against the base [m].
  [[nodiscard]] double largest_displacement_m() const;
  [[nodiscard]] double time_s() const { return time_s_; }
  /// Has settling found a state of rest? Known as the run begins.
  [[nodiscard]] bool starts_at_rest() const { return starts_at_rest_; }

  /// What a step changes.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(states_, contacts_, contacts_stand_, next_dt_, started_, time_s_, rest_, sleep_, guard_, water_work_,
            energy_balance_, smooth_steps_, search_, counts_, profile_, *formulation_);
    for (Support& support : supports_) archive(support);
    for (Bolt& bolt : bolts_) archive(bolt);
    if (substitute_) archive(*substitute_);
    std::vector<KeptFactors> kept = kept_factors();
    archive(links_, kept, whole_law_, finish_);
    if (Archive::is_loading::value) follow_states(std::move(kept));
  }

 private:
  /// A force that is solved for, of a contact or a support: what a unit of it exerts (normal, shear).
  struct UnknownForce {
    bool support;
    int index;
    Eigen::Vector2d force;
  };
  struct IslandSystem {
    IslandSystem(Island of, std::unique_ptr<Unknowns> its)
        : island(std::move(of)),
          unknowns(std::move(its)),
          system(make_linear_system(*unknowns, island.couples)),
          saddle(*unknowns),
          residual(unknowns->total),
          correction(unknowns->total) {}
    Island island;
    std::vector<int> bolts;
    std::unique_ptr<Unknowns> unknowns;
    std::unique_ptr<LinearSystem> system;
    SaddlePoint saddle;  ///< instead of it while there are unknown forces
    std::vector<UnknownForce> unknown_forces;
    std::vector<Interaction> actions;  ///< of contacts, supports and bolts, in this order, at the trial
    Incidence incidence;               ///< of them
    bool symmetric = true;             ///< are their stiffnesses?
    Eigen::VectorXd residual;
    Eigen::VectorXd correction;
    Eigen::VectorXd forces;
    ForceSweeps sweeps;          ///< where Newton's method does not find the states
    bool swept = false;          ///< in the step at hand
    bool asleep = false;         ///< in the step at hand
    std::vector<int> couplings;  ///< indices into Parts::couplings
    Eigen::VectorXd uncertain;   ///< round-off of the residual at nodes
  };

  /// An island without the forces of its contacts.
  struct Released {
    std::vector<int> ids;  ///< of contacts that may close
    CoulombContacts contacts;
    Eigen::MatrixXd moves_by;  ///< what unit forces of theirs do to the unknowns
  };

  /// Of Shi's scheme, after a step in which contacts have changed: its acceleration is that of the forces that act,
  /// which a rule of second order goes on from.
  static constexpr int smooth_steps_before_restart = 1;
  static constexpr int most_settling_steps = 200;
  static constexpr int few_unknowns = 60;   ///< of an island in which Newton's method may go on as long as it likes
  static constexpr int large_island = 200;  ///< unknowns above which states that run in circles are not waited for
  static constexpr double lagging_penalty_ratio = 1e-2;  ///< penalties while friction lags, of a step's own

  /// The motion (u0, v0, r0) of a block with a mesh, whose inertia in water its triangles share.
  struct MeanMotion {
    std::size_t block = 0;
    std::vector<Eigen::Matrix<double, 3, 6>> of_corners;  ///< its rates by the velocities of each triangle's corners
    Eigen::Vector3d history;                              ///< what its inertia remembers
    /// Are its triangles, all joined, in this island?
    [[nodiscard]] bool in(const Parts& parts, const Island& island) const;
  };

  /// What steps that are to be undone change.
  struct Standing {
    std::vector<BlockState> states;
    std::vector<Placement> start;
    std::vector<ContactPoint> contacts;
    std::vector<Support> supports;
    std::vector<Bolt> bolts;
  };
  [[nodiscard]] Standing standing() const;
  void stand_as(const Standing& before);

  void follow_states(std::vector<KeptFactors> kept);
  [[nodiscard]] std::vector<KeptFactors> kept_factors() const;
  double take_out_rounding();
  void bond_touching_contacts();
  void begin_window(const Answered& answered);
  void guard(double dt);
  void relax(const Stretch& pseudo_step, const StepMode& mode);
  void start_moving(const Stretch& pseudo_step, double acceleration, const Standing& held, const StepMode& mode);
  void start_acceleration(const std::vector<Panel>& water, double from_s);
  Outcome make_step(const Stretch& stretch);
  void act_by_end_rates(std::size_t b, double dt);
  [[nodiscard]] bool contacts_change();
  [[nodiscard]] long touching_contacts() const;
  Outcome try_step(const Stretch& stretch, const StepMode& mode);
  Outcome attempt(const Stretch& stretch, const StepMode& mode);
  Outcome attempt_with_lagging_friction(const Stretch& stretch, const StepMode& mode);
  Outcome attempt_softly(const Stretch& stretch, const StepMode& mode);
  Outcome attempt_by_substitute(const Stretch& stretch, const StepMode& mode);
  [[nodiscard]] double timed() const;
  bool find_contacts();
  void predict(std::size_t b);
  void find_sliding_blocks();
  [[nodiscard]] double retardation_s(std::size_t b) const { return blocks_[b].retardation.of(slides_[b]); }
  void prepare_matrices(double dt, const Newmark& scheme);
  void prepare_islands();
  bool find_equilibrium(IslandSystem& island, const StepMode& mode);
  /// Static analyses ask for round-off, which sweeps do not reach; steps that are to be smooth for states that stay.
  [[nodiscard]] bool may_sweep(const StepMode& mode) const {
    return (mode.sweeps || mode.in_motion()) && !mode.smooth_only && !formulation_->solves_for_forces();
  }
  [[nodiscard]] bool may_pivot(const IslandSystem& island, const StepMode& mode) const;
  bool release_contacts(IslandSystem& island, Released& released);
  bool find_equilibrium_by_pivoting(IslandSystem& island, const StepMode& mode);
  bool find_equilibrium_by_sweeps(IslandSystem& island, const StepMode& mode);
  /// Twice that of a fall from rest through the step: a measure of what the integrator is off by.
  [[nodiscard]] double fall_m() const { return scene_.analysis.gravity_m_per_s2 * matrices_dt_ * matrices_dt_; }
  double sweep(IslandSystem& island, int most, double enough_m);
  bool finish_swept(IslandSystem& island, const StepMode& mode);
  void start_again(const IslandSystem& island);
  bool linearize(IslandSystem& island);
  void add_row(IslandSystem& island, const Ruled& ruled, const Interaction& action, const Eigen::Vector2d& force);
  void add_end_of_mesh(IslandSystem& island, bool second, int block, const Matrix26& shape);
  void take_forces(IslandSystem& island);
  bool push_apart(const IslandSystem& island);
  void push_once(const IslandSystem& island);
  [[nodiscard]] EdgeFrame frame_now(const ContactPoint& c) const;
  [[nodiscard]] double gap_now(const ContactPoint& c) const;
  void displace(std::size_t block, const Eigen::Vector3d& by);
  void settle_swept_velocities(IslandSystem& island, double dt);
  [[nodiscard]] Eigen::Vector2d rate_of_fixed(const Interaction& action, bool to_mean, double dt) const;
  bool update_multipliers(IslandSystem& island);
  bool find_equilibrium_with_lagging_friction(IslandSystem& island, const StepMode& mode);
  enum class Approach { nothing, near, states };  ///< what the interior point has come to
  Approach approach(IslandSystem& island, double change_n);
  bool finish(IslandSystem& island, const StepMode& mode);
  bool or_undone(IslandSystem& island, const std::function<bool()>& search);
  bool minimize(IslandSystem& island, int most_solutions);
  double search_along_correction(IslandSystem& island);
  bool correct(IslandSystem& island);
  bool solve_linearized(IslandSystem& island);
  void move(IslandSystem& island, double fraction);
  void correct_forces(IslandSystem& island);
  void start_where_it_rests(const IslandSystem& island);
  double unbalanced(IslandSystem& island);
  double unbalanced_in_these_states(IslandSystem& island, const StepMode& mode);
  void balance_own(std::size_t b);
  void balance_alone(IslandSystem& island);
  double find_residual(IslandSystem& island, const std::function<void(std::size_t)>& also_acts);
  void let_act(IslandSystem& island);
  void take_up(const IslandSystem& island, std::size_t k);
  double add_residual(IslandSystem& island, std::size_t k);
  void assemble(IslandSystem& island);
  void set_block_matrices(IslandSystem& island);
  template <class System>
  void add_stiffness(System& system, const Interaction& action) const;
  template <class System>
  void add_columns(System& system, const Interaction& action, bool of_second) const;
  [[nodiscard]] Held held_by(const IslandSystem& s) {
    return {s.island.contacts, contacts_, s.island.supports, supports_};
  }
  /// Has this block, -1 for the ground, unknowns?
  [[nodiscard]] bool moves(int block) const { return block >= 0 && !frozen_[static_cast<std::size_t>(block)]; }
  void give_bolts_to_islands();
  void find_incidences();
  void add_constraints(IslandSystem& island, const Interaction& action, bool support, int index) const;
  void settle_held_velocities(IslandSystem& island, double dt);
  [[nodiscard]] Eigen::Vector2d led_rate(const IslandSystem& island, std::size_t action, double dt) const;
  [[nodiscard]] double opening_slope(const IslandSystem& island, std::size_t action) const;
  void project_held_velocities(IslandSystem& island, const std::vector<Eigen::Vector2d>& missing);
  void balance_energy(IslandSystem& island, double dt);
  void take_back_energy(IslandSystem& island, const StepMode& mode);
  [[nodiscard]] double taken_by_water(const IslandSystem& island) const;
  [[nodiscard]] Point push_of_base() const;
  [[nodiscard]] std::vector<int> groups_of(const IslandSystem& island) const;
  [[nodiscard]] bool touches(int contact) const;
  [[nodiscard]] Vector6 rate(std::size_t b, const Placement& placement, const Vector6& of_state) const;
  [[nodiscard]] Vector6 at_corners(std::size_t b, const Vector6& force) const;
  [[nodiscard]] Matrix6 inertia(std::size_t b) const;
  void predict_nodes(double dt);
  void set_corner_maps(IslandSystem& island);
  template <class System>
  void add_own(System& system, const IslandSystem& island) const;
  void balance_couplings(IslandSystem& island);
  void add_residual_at_corners(IslandSystem& island, int triangle);
  void guard_mesh(std::size_t block, double dt);
  [[nodiscard]] Eigen::MatrixXd mean_motions(const IslandSystem& island, Eigen::MatrixXd& inertia) const;
  void add_mean_inertia(IslandSystem& island);
  void add_mean_inertia_to_saddle(IslandSystem& island) const;
  bool solve(IslandSystem& island, bool symmetric) const;
  [[nodiscard]] Eigen::VectorXd solve_again(IslandSystem& island, const Eigen::VectorXd& force) const;
  void with_mean_inertia(const IslandSystem& island, Eigen::VectorXd& solution) const;
  [[nodiscard]] static double unbalanced_at_nodes(const IslandSystem& island);
  void follow_corners(std::size_t triangle);
  [[nodiscard]] Vector6 corner_increment(std::size_t triangle) const;
  void follow_triangles();
  void carry_fixed_blocks(double end_s);
  bool accept(const Stretch& stretch, const StepMode& mode);
  [[nodiscard]] bool may_sleep(const IslandSystem& island, const StepMode& mode) const;
  void put_to_sleep(const IslandSystem& island);
  [[nodiscard]] bool goes_too_far(double moved_m) const;
  [[nodiscard]] double largest_increment() const;
  [[nodiscard]] double largest_turn() const;
  [[nodiscard]] Trial at_start() const {
    return {blocks_, start_, still_, start_, past_velocity_, newmark_.velocity_factor(matrices_dt_)};
  }
  [[nodiscard]] Trial trial() const {
    return {blocks_, start_, increment_, placement_, past_velocity_, newmark_.velocity_factor(matrices_dt_)};
  }
  void require_finite(double time_s) const;
  [[nodiscard]] std::vector<bool> unanchored() const;
  [[nodiscard]] double pseudo_step_s() const;
  [[nodiscard]] double settling_time_s() const;
  void come_to_rest(const std::vector<Panel>& water, double at_s);
  [[nodiscard]] double unbalanced_ratio() const;
  void require_finite_loads(double time_s) const;
  void require_numbers(const IslandSystem& island) const;
  [[noreturn]] void refuse_step(double time_s, double dt, Outcome last) const;
  [[noreturn]] void refuse_start(int steps, Outcome last) const;
  [[nodiscard]] std::string start_advice(bool moves_on, double overlap_m) const;
  void require_small_strains() const;
  [[noreturn]] void refuse(std::size_t b, const char* what, double time_s) const;

  // Constant.
  const scene::Scene& scene_;
  Parts parts_;
  std::vector<Block>& blocks_;  ///< of parts_
  JointLaws laws_;
  Loads loads_;
  BaseMotion base_;
  double size_ = 0;
  double force_scale_ = 0;  ///< weight of all that can move [N per metre]
  Newmark scheme_;          ///< the scene's

  // What a step changes.
  std::vector<BlockState> states_;
  std::vector<Placement> start_;  ///< of states_
  std::vector<ContactPoint> contacts_;
  std::vector<Support> supports_;
  std::vector<Bolt> bolts_;
  bool contacts_stand_ = false;  ///< nothing has moved since they were searched
  double next_dt_ = 0;           ///< step that the last advance ended with
  bool started_ = false;
  double time_s_ = 0;  ///< of states_
  Rest rest_;
  std::function<void()> meanwhile_;
  Pause whole_law_;  ///< of Coulomb, by Newton's method: fails where friction has to lag or contacts to be swept
  Pause finish_;     ///< by Newton's method, of what sweeps have found
  Sleep sleep_;
  EnergyBalance energy_balance_;
  int smooth_steps_ = 0;  ///< since the last in which contacts changed, where the integrator is of second order

  // The step at hand.
  Newmark newmark_;  ///< of the step
  AddedMassGuard guard_;
  WaterWork water_work_;
  std::vector<MeanMotion> mean_motions_;  ///< of meshed blocks under the guard
  std::unique_ptr<Formulation> formulation_;
  std::unique_ptr<Formulation> substitute_;  ///< for steps that Lagrange multipliers cannot settle
  ContactSearch search_;
  std::vector<bool> frozen_;  ///< fixed, or waiting while others settle
  double end_s_ = 0;          ///< of the step
  bool starts_at_rest_ = true;
  bool made_by_shi_ = true;   ///< the last step, by Shi's scheme
  double matrices_dt_ = -1;   ///< step that matrix_ was made for
  std::vector<bool> slides_;  ///< has a contact that slips as the step begins
  /// Relative, of a sum of some tens of terms.
  static constexpr double sum_round_off = 1e-13;

  std::vector<Matrix6> matrix_;         ///< inertia and elasticity of each block
  std::vector<Vector6> external_;       ///< loads at the end of the step
  std::vector<Vector6> history_;        ///< what inertia remembers; of triangles, at their corners
  std::vector<Vector6> past_velocity_;  ///< what velocity would be at the end of the step without an increment
  std::vector<Vector6> began_with_;     ///< velocities, as states have them
  std::vector<double> for_motion_;  ///< what loads give each block less what strain and springs take up [J per metre]
  std::vector<Vector6> increment_;
  std::vector<Vector6> still_;  ///< no increment
  std::vector<Placement> placement_;
  std::vector<Point> node_increment_;  ///< of meshes [m]
  std::vector<Vector6> balance_;       ///< all forces but inertia
  std::vector<double> round_off_;      ///< what is uncertain of balance_ [N per metre]
  std::vector<int> local_;             ///< index of a block within its island
  std::vector<std::pair<int, int>> links_;
  std::vector<IslandSystem> islands_;
  std::vector<KeptFactors> kept_;  ///< from a checkpoint: of the islands that its contacts make
  Counts counts_;
  Profile profile_;
};

}  // namespace blockweir::solid
