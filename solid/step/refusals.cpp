// SPDX-License-Identifier: GPL-3.0-or-later
// Steps that cannot be made, and numbers that are none: what is said of them.
#include <fmt/format.h>

#include <cmath>

#include "solid/block/parallel.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

void Solid::refuse_step(double time_s, double dt) const {
  if (goes_too_far_) {
    throw SolveError(
        fmt::format("at {:.6g} s blocks move by more than [analysis] max_displacement_ratio, or turn by more than a "
                    "search of contacts follows, even in a step of {:.3g} s; are velocities and loads in their units?",
                    time_s, dt));
  }
  throw SolveError(
      fmt::format("the contact states did not settle at {:.6g} s, even with a step of {:.3g} s; a smaller [analysis] "
                  "step_s or a larger [contact] max_iterations may help",
                  time_s, dt));
}

void Solid::refuse(std::size_t b, const char* what, double time_s) const {
  throw NotFinite(fmt::format("{} of block \"{}\" is not a finite number at {:.6g} s (step {})", what, blocks_[b].name,
                              time_s, counts_.steps + 1));
}

void Solid::require_finite(double time_s) const {
  const auto finite = [this](std::size_t b) {
    return states_[b].displacement.allFinite() && states_[b].velocity.allFinite();
  };
  if (all_of(blocks_.size(), finite)) return;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (!finite(b)) refuse(b, "the displacement", time_s);
  }
}

void Solid::require_finite_loads(double time_s) const {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (!external_[b].allFinite()) refuse(b, "the load", time_s);
  }
}

/// Forces that overflow may do so for too long a step; those that are no numbers end the run.
void Solid::require_numbers(const IslandSystem& s) const {
  for (const int b : s.island.blocks) {
    if (balance_[static_cast<std::size_t>(b)].hasNaN()) refuse(static_cast<std::size_t>(b), "the force", end_s_);
  }
}

}  // namespace blockweir::solid
