// SPDX-License-Identifier: GPL-3.0-or-later
// What a step reports, and why a run cannot go on.
#pragma once

#include <stdexcept>
#include <string>

namespace blockweir::solid {

/// The solid cannot go on: no step could be solved however small, a value is not a number, or the exchange with the
/// water is unstable. From a checkpoint the run would end here again.
struct SolveError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A load, a force or a displacement was not a finite number: no smaller step mends that.
struct NotFinite : SolveError {
  using SolveError::SolveError;
};

/// What a static analysis has found.
struct Rest {
  bool found = false;
  int steps = 0;
  double unbalanced = 0;  ///< largest unbalanced force over the weight of all that can move

  template <class Archive>
  void serialize(Archive& archive) {
    archive(found, steps, unbalanced);
  }
};

/// Work done so far.
struct Counts {
  long steps = 0;
  long undone_steps = 0;
  long substituted_steps = 0;  ///< by the augmented Lagrangian in place of Lagrange multipliers
  long softened_steps = 0;     ///< tries of a state of rest with a smaller penalty
  long lagged_steps = 0;       ///< tries with friction that lags
  long impact_steps = 0;       ///< made by Shi's scheme in place of a rule of second order, as contacts changed
  long pivoted_islands = 0;    ///< at rest, whose states were looked for by pivoting
  long swept_islands = 0;      ///< whose contacts were swept, summed over steps
  long iterations = 0;         ///< solved linear systems
  long factorizations = 0;     ///< of matrices; the other solutions reuse one
  long reused_factorizations = 0;
  long sweeps = 0;         ///< multiplier updates
  long state_changes = 0;  ///< open, stick, slip
  long broad_searches = 0;
  long searches = 0;          ///< of contacts
  long skipped_searches = 0;  ///< steps that found contacts as the step before had left them
  long settling_steps = 0;
  long solved_islands = 0;      ///< summed over steps, but for those that settle
  long most_islands = 0;        ///< at a time
  long slept_islands = 0;       ///< islands that a step left as they were, summed over steps
  double condition_number = 0;  ///< largest of all systems solved, where the scene asks for it
  double residual_m = 0;        ///< by which gaps and slips of a swept step were off their laws, the largest
  double overlap_m = 0;         ///< of blocks as a step ended, the largest

  template <class Archive>
  void serialize(Archive& archive) {
    archive(steps, undone_steps, substituted_steps, softened_steps, lagged_steps, impact_steps, pivoted_islands,
            swept_islands, iterations, factorizations, reused_factorizations, sweeps, state_changes, broad_searches,
            searches, skipped_searches, settling_steps, solved_islands, most_islands, slept_islands, condition_number,
            residual_m, overlap_m);
  }
};

/// Seconds spent so far.
struct Profile {
  double search = 0;         ///< of contacts
  double islands = 0;        ///< groups of blocks, and the patterns of their matrices
  double assembly = 0;       ///< of residuals and matrices, contact being a part of it
  double contact = 0;        ///< forces and states of contacts, supports and bolts
  double solve = 0;          ///< factorization being a part of it
  double factorization = 0;  ///< of the matrices that are counted
  double refinement = 0;     ///< another part of it, see SolutionTimes
  double sweeps = 0;         ///< multipliers, bonds
  double accept = 0;         ///< states at the end of a step
  double equilibria = 0;     ///< of the islands that are counted as solved; parts of it are above

  template <class Archive>
  void serialize(Archive& archive) {
    archive(search, islands, assembly, contact, solve, factorization, refinement, sweeps, accept, equilibria);
  }
};

}  // namespace blockweir::solid
