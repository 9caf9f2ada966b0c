// SPDX-License-Identifier: GPL-3.0-or-later
// The equations of one island at the trial (5)-(6): residual, matrix, and what solves them linearized.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "solid/contact/interaction.hpp"
#include "solid/solve/force_sweeps.hpp"
#include "solid/solve/incidence.hpp"
#include "solid/solve/islands.hpp"
#include "solid/step/step_mode.hpp"
#include "solid/step/step_workspace.hpp"
#include "solid/step/unknown_forces.hpp"
#include "solid/step/water_inertia.hpp"

namespace blockweir::solid {

constexpr int few_unknowns = 60;         ///< of an island in which Newton's method may go on as long as it likes
constexpr int large_island = 200;        ///< unknowns above which states that run in circles are not waited for
constexpr double sum_round_off = 1e-13;  ///< relative, of a sum of some tens of terms

class IslandEquations : StepPart {
 public:
  /// `numbers`: of each of the model's blocks, its index within its island.
  IslandEquations(StepWorkspace& step, const WaterInertia& water, const std::vector<int>& numbers, Island of,
                  std::unique_ptr<Unknowns> its);

  Island island;
  std::vector<int> bolts;
  std::vector<int> couplings;  ///< indices into Parts::couplings
  std::unique_ptr<Unknowns> unknowns;
  Incidence incidence;           ///< of the actions
  Found found = Found::nothing;  ///< in the step at hand
  double left_m = 0;             ///< by which sweeps have left gaps and slips off their laws

  std::vector<Interaction> actions;  ///< of contacts, supports and bolts, in this order, at the trial
  Eigen::VectorXd residual;
  Eigen::VectorXd uncertain;  ///< round-off of the residual at nodes
  Eigen::VectorXd correction;
  ForceSweeps sweeps;               ///< where Newton's method does not find the states
  std::vector<Matrix6> compliance;  ///< of each block alone, for sweeps
  /// On each block by the water that others push; none where all push their own.
  std::vector<Vector6> pulls;

  /// Made when it is first asked for: what is swept needs none.
  [[nodiscard]] LinearSystem& system() const;

  /// Residual at the trial; returns the largest unbalanced force, less what round-off explains. What contacts, supports
  /// and bolts do is kept for the matrix, which only a residual that is too large asks for.
  double unbalanced();
  /// What acts on an island's blocks without contacts, supports and bolts.
  void balance_alone();
  /// Residual of the balance, with what `also_acts` adds to that of each block, by its place in the island.
  double find_residual(const std::function<void(std::size_t)>& also_acts);
  /// Adds to the balance of an island's block k what acts on it.
  void take_up(std::size_t k);

  /// The correction by one solution of the linearized equations; false where there is none.
  bool solve_linearized();
  /// Adds so much of the correction to the trial.
  void move(double fraction);
  /// The matrix of blocks alone, to which others add.
  void set_block_matrices();
  void add_stiffness(const Interaction& action);
  bool solve(bool symmetric);

  /// Do blocks share unknowns, or water that they push? Then a force on one moves others at once.
  [[nodiscard]] bool moves_as_one() const { return unknowns->shared() || !pulls.empty(); }
  /// Does nothing touch or hold its blocks?
  [[nodiscard]] bool is_free() const { return island.is_free() && bolts.empty(); }
  [[nodiscard]] Held held() { return {island.contacts, state_.contacts, island.supports, state_.supports}; }
  [[nodiscard]] int local(int block) const { return numbers_[static_cast<std::size_t>(block)]; }
  /// Is a block one of the island's?
  [[nodiscard]] bool has(int block) const {
    const auto k = static_cast<std::size_t>(local(block));
    return k < island.blocks.size() && island.blocks[k] == block;
  }

 private:
  void balance_own(std::size_t b);
  void balance_couplings();
  void let_act();
  double add_residual(std::size_t k);
  void add_residual_at_corners(int k);
  void set_corner_maps();
  void assemble();

  const WaterInertia& water_;
  const std::vector<int>& numbers_;
  mutable std::unique_ptr<LinearSystem> system_;
  bool symmetric_ = true;  ///< are the actions' stiffnesses?
  UnknownForces forces_;   ///< instead of the system while there are any
};

}  // namespace blockweir::solid
