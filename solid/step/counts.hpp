// SPDX-License-Identifier: GPL-3.0-or-later
// Counts and times of the steps, and the errors that end a run.
#pragma once

#include <stdexcept>
#include <string>

namespace blockweir::solid {

/// The solid cannot continue: no step could be solved however small, a value is not a number, or the exchange with the
/// water is unstable. Resuming from a checkpoint would end here again.
struct SolveError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A load, a force or a displacement is not a finite number; a smaller step does not help.
struct NotFinite : SolveError {
  using SolveError::SolveError;
};

/// Result of a static analysis.
struct Rest {
  bool found = false;
  int steps = 0;
  double unbalanced = 0;  ///< largest unbalanced force over the weight of all moving blocks

  template <class Archive>
  void serialize(Archive& archive) {
    archive(found, steps, unbalanced);
  }
};

/// Work done so far.
struct Counts {
  long steps = 0;
  long undone_steps = 0;
  long substituted_steps = 0;  ///< by the augmented Lagrangian instead of Lagrange multipliers
  long softened_steps = 0;     ///< attempts to find equilibrium with a smaller penalty
  long lagged_steps = 0;       ///< attempts with lagged friction bounds
  long impact_steps = 0;       ///< by Shi's scheme instead of a second-order one, since contacts changed
  long pivoted_islands = 0;    ///< at rest, with contact states found by pivoting
  long swept_islands = 0;      ///< with contacts solved by sweeps, summed over steps
  long iterations = 0;         ///< solved linear systems
  long factorizations = 0;     ///< of matrices; other solutions reuse one
  long reused_factorizations = 0;
  long sweeps = 0;         ///< multiplier updates
  long state_changes = 0;  ///< open, stick, slip
  long broad_searches = 0;
  long searches = 0;          ///< of contacts
  long skipped_searches = 0;  ///< steps that kept the contacts of the step before
  long settling_steps = 0;
  long solved_islands = 0;      ///< summed over steps, without settling
  long most_islands = 0;        ///< at one time
  long slept_islands = 0;       ///< islands skipped in a step, summed over steps
  double condition_number = 0;  ///< largest of all systems solved, if requested by the scene
  double residual_m = 0;        ///< largest error of a gap or slip in a swept step
  double overlap_m = 0;         ///< largest overlap of blocks at the end of a step
  long unheld_steps = 0;        ///< since something stood: blocks were next to rest, and no admissible forces held them

  template <class Archive>
  void serialize(Archive& archive) {
    archive(steps, undone_steps, substituted_steps, softened_steps, lagged_steps, impact_steps, pivoted_islands,
            swept_islands, iterations, factorizations, reused_factorizations, sweeps, state_changes, broad_searches,
            searches, skipped_searches, settling_steps, solved_islands, most_islands, slept_islands, condition_number,
            residual_m, overlap_m, unheld_steps);
  }
};

/// Seconds spent so far.
struct Profile {
  double search = 0;         ///< for contacts
  double islands = 0;        ///< finding groups of blocks, and the patterns of their matrices
  double assembly = 0;       ///< of residuals and matrices, includes contact
  double contact = 0;        ///< forces and states of contacts, supports and bolts
  double solve = 0;          ///< includes factorization
  double factorization = 0;  ///< of the matrices that are counted
  double refinement = 0;     ///< also part of solve, see SolutionTimes
  double sweeps = 0;         ///< multipliers, bonds
  double accept = 0;         ///< states at the end of a step
  double equilibria = 0;     ///< of the islands counted as solved; includes parts above

  template <class Archive>
  void serialize(Archive& archive) {
    archive(search, islands, assembly, contact, solve, factorization, refinement, sweeps, accept, equilibria);
  }
};

}  // namespace blockweir::solid
