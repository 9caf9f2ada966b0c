// SPDX-License-Identifier: GPL-3.0-or-later
// The data that all parts of a step share.
#pragma once

#include <functional>
#include <memory>

#include "solid/contact/formulation.hpp"
#include "solid/step/counts.hpp"
#include "solid/step/model.hpp"
#include "solid/step/state.hpp"
#include "solid/step/step_trial.hpp"

namespace blockweir::solid {

/// Model and state must outlive the object.
struct StepWorkspace {
  StepWorkspace(const Model& of_model, State& of_state);
  StepWorkspace(const StepWorkspace&) = delete;
  StepWorkspace& operator=(const StepWorkspace&) = delete;

  const Model& model;
  State& state;
  StepTrial trial;
  std::unique_ptr<Formulation> formulation;  ///< of contact
  std::unique_ptr<Formulation> substitute;   ///< for steps that fail with Lagrange multipliers
  Counts counts;
  Profile profile;
  bool must_move = false;           ///< proved of an island: no admissible forces hold it where the step began
  bool held = false;                ///< of an island: forces by which nothing moves were found
  std::function<void()> meanwhile;  ///< where somebody waits

  /// At the start of each attempt at a step, after each solution of a linear system, and between sweeps and pushes: a
  /// large island may take long.
  void go_on() const {
    if (meanwhile) meanwhile();
  }
};

/// Base of all parts of a step; the workspace must outlive it.
class StepPart {
 protected:
  explicit StepPart(StepWorkspace& step)
      : step_(step),
        model_(step.model),
        state_(step.state),
        trial_(step.trial),
        formulation_(step.formulation),
        counts_(step.counts),
        profile_(step.profile) {}

  StepWorkspace& step_;
  const Model& model_;
  State& state_;
  StepTrial& trial_;
  std::unique_ptr<Formulation>& formulation_;  ///< the one in use
  Counts& counts_;
  Profile& profile_;
};

}  // namespace blockweir::solid
