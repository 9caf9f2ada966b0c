// SPDX-License-Identifier: GPL-3.0-or-later
// The DDA solid: blocks, contacts and the time step that moves them.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "bridge/scene/scene.hpp"
#include "solid/block/pressure_history.hpp"
#include "solid/step/impacts.hpp"
#include "solid/step/motion_from_rest.hpp"
#include "solid/step/static_analysis.hpp"
#include "solid/step/time_step.hpp"

namespace blockweir::solid {

class Solid {
 public:
  /// The scene must outlive the object.
  explicit Solid(const scene::Scene& scene)
      : model_(scene), state_(model_), step_(model_, state_), water_(step_), time_step_(step_, water_) {}

  /// Lets weight and first loads settle with all joints held, then releases the joints: the state at time 0. Throws
  /// SolveError if there is no equilibrium.
  void settle(const std::vector<Panel>& water);

  /// `meanwhile` is called at the start of each step, in its attempts, between sweeps and after each solution of a
  /// linear system, also while settling. If it throws, the run ends, and the object must not be used any more.
  void call_meanwhile(std::function<void()> meanwhile) { step_.meanwhile = std::move(meanwhile); }

  using Answered = solid::Answered;
  /// Moves the blocks from `from_s` to `to_s` under the given water, in as many steps as accuracy requires.
  void advance(double from_s, double to_s, PressureHistory& water, const Answered& answered);
  /// The same under constant water pressure; the velocities are the present ones of the blocks.
  void advance(double from_s, double to_s, const std::vector<Panel>& water, const AddedMasses& masses = {});

  /// Finds the contacts of the next step, which advance() would otherwise do. Nothing may move the blocks meanwhile.
  void prepare() {
    if (state_.started) time_step_.find_contacts_ahead();
  }

  /// Is it proved that the blocks cannot rest where they are, under this water and the loads of that time? Only of many
  /// rigid ones in static analyses.
  bool must_move(double at_s, const std::vector<Panel>& water) { return rest_.must_move(water, at_s); }

  /// Frequently used parts of the model and the state have functions of their own.
  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] const scene::Scene& scene() const { return model_.scene; }
  [[nodiscard]] const MovingParts& parts() const { return model_.parts; }
  /// The scene's blocks in its order, then the triangles of meshes; states and placements have the same order. A block
  /// with a mesh has the mean motion of its triangles.
  [[nodiscard]] const std::vector<Block>& blocks() const { return model_.blocks; }
  [[nodiscard]] std::size_t described() const { return model_.described(); }  ///< number of the scene's blocks
  [[nodiscard]] const JointLaws& laws() const { return model_.laws; }

  [[nodiscard]] const std::vector<BlockState>& states() const { return state_.blocks; }
  [[nodiscard]] const std::vector<Placement>& placements() const { return state_.placements; }
  [[nodiscard]] const std::vector<ContactPoint>& contacts() const { return state_.contacts; }
  [[nodiscard]] const std::vector<Bolt>& bolts() const { return state_.bolts; }
  [[nodiscard]] double time_s() const { return state_.time_s; }
  /// Largest displacement of a vertex from the scene as drawn, relative to the base [m].
  [[nodiscard]] double largest_displacement_m() const { return state_.largest_displacement_m(model_); }
  /// Rates of the six unknowns of a block or triangle.
  [[nodiscard]] Vector6 velocity(std::size_t b) const {
    return step_.trial.rate(b, state_.placements[b], state_.blocks[b].velocity);
  }
  /// Whether settling found equilibrium; known when the run starts.
  [[nodiscard]] bool starts_at_rest() const { return starts_at_rest_; }
  [[nodiscard]] Counts counts() const;
  [[nodiscard]] const Profile& profile() const { return step_.profile; }

  /// The part of the state that a step changes.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(state_, step_.counts, step_.profile, step_.formulation->progress());
    if (step_.substitute) archive(step_.substitute->progress());
    archive(time_step_.islands());
    if (!Archive::is_loading::value) return;
    state_.place_blocks(model_);
    step_.trial.dt = -1;
  }

 private:
  Model model_;
  State state_;
  StepWorkspace step_;
  WaterInertia water_;
  TimeStep time_step_;
  StepsWithImpacts steps_{step_, time_step_, water_};
  StaticAnalysis rest_{step_, time_step_};
  MotionFromRest from_rest_{step_, rest_};
  bool starts_at_rest_ = true;
};

}  // namespace blockweir::solid
