// SPDX-License-Identifier: GPL-3.0-or-later
// The equations of one island at the trial positions (5)-(6): residual, matrix, and the linear solution.
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

constexpr int few_unknowns = 60;         ///< islands up to this size: no limit on Newton's method
constexpr int large_island = 200;        ///< unknowns above which cycling contact states are given up
constexpr double sum_round_off = 1e-13;  ///< relative, of a sum of some tens of terms

class IslandEquations : StepPart {
 public:
  /// `numbers`: for each of the model's blocks, its index within its island.
  IslandEquations(StepWorkspace& step, const WaterInertia& water, const std::vector<int>& numbers, Island given_island,
                  std::unique_ptr<Unknowns> given_unknowns);

  Island island;
  std::vector<int> bolts;
  std::vector<int> couplings;  ///< indices into MovingParts::couplings
  std::unique_ptr<Unknowns> unknowns;
  Incidence incidence;           ///< of the actions
  Found found = Found::nothing;  ///< in this step
  double left_m = 0;             ///< error of gaps and slips left by sweeps

  std::vector<Interaction> actions;  ///< of contacts, supports and bolts, in this order, at the trial positions
  Eigen::VectorXd residual;
  Eigen::VectorXd uncertain;  ///< round-off of the residual at mesh nodes
  Eigen::VectorXd correction;
  ForceSweeps sweeps;               ///< used if Newton's method does not find the contact states
  std::vector<Matrix6> compliance;  ///< of each block alone, for sweeps
  /// Force on each block by water that other blocks displace; empty if they displace separate water.
  std::vector<Vector6> pulls;

  /// Created on first use: sweeps need none.
  [[nodiscard]] LinearSystem& system() const;

  /// Residual at the trial positions; returns the largest unbalanced force, less its round-off. Contact, support and
  /// bolt forces are kept for the matrix, which is needed only if the residual is too large.
  double unbalanced();
  /// Forces on the blocks except those of contacts, supports and bolts.
  void balance_alone();
  /// Residual of the balance; `also_acts` adds further forces to each block, by index in the island.
  double find_residual(const std::function<void(std::size_t)>& also_acts);
  /// Adds the interaction forces on the island's block k to its balance.
  void add_forces(std::size_t k);

  /// Solves the linearized equations once for the correction; false if there is no solution.
  bool solve_linearized();
  /// With the stiffnesses that the actions have been given, which are symmetric.
  bool solve_symmetric();
  /// Adds this fraction of the correction to the trial positions.
  void move(double fraction);
  /// Sets the matrix of the blocks alone, to which others add.
  void set_block_matrices();
  void add_stiffness(const Interaction& action);
  bool solve(bool symmetric);

  /// Whether a force on one block moves others at once, through shared unknowns or water.
  [[nodiscard]] bool moves_as_one() const { return unknowns->shared() || !pulls.empty(); }
  /// Does nothing touch or hold its blocks?
  [[nodiscard]] bool is_free() const { return island.is_free() && bolts.empty(); }
  [[nodiscard]] IslandContacts island_contacts() {
    return {island.contacts, state_.contacts, island.supports, state_.supports};
  }
  [[nodiscard]] int local(int block) const { return numbers_[static_cast<std::size_t>(block)]; }
  /// Whether the island contains the block.
  [[nodiscard]] bool has(int block) const {
    const auto k = static_cast<std::size_t>(local(block));
    return k < island.blocks.size() && island.blocks[k] == block;
  }

 private:
  void balance_own(std::size_t b);
  void balance_couplings();
  void evaluate_interactions();
  double add_residual(std::size_t k);
  void add_residual_at_corners(int k);
  void set_corner_maps();
  void assemble();

  const WaterInertia& water_;
  const std::vector<int>& numbers_;
  mutable std::unique_ptr<LinearSystem> system_;
  bool symmetric_ = true;  ///< whether the actions' stiffnesses are symmetric
  UnknownForces forces_;   ///< replaces the system if forces are unknowns
};

}  // namespace blockweir::solid
