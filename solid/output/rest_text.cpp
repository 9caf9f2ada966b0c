// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/rest_text.hpp"

#include <fmt/format.h>

#include "bridge/results/counted.hpp"

namespace blockweir::solid::output {

std::string rest_text(const Rest& rest, long steps, const scene::Analysis& analysis, double farthest_m) {
  const std::string taken = results::counted(static_cast<std::size_t>(steps), "step");
  if (rest.found) return fmt::format("at rest after {}, {:.3g} of the weight unbalanced", taken, rest.unbalanced);
  const std::string moved = fmt::format("largest displacement {:.4g} m", farthest_m);
  if (rest.steps == 0) return "no equilibrium: no step towards it could be solved; " + moved;
  if (rest.unbalanced <= analysis.residual_tolerance) {
    return fmt::format(
        "no equilibrium: after {} forces balance, but only where joints have slipped by more than "
        "failure_displacement_m = {:.3g} m; {}",
        taken, analysis.failure_displacement_m, moved);
  }
  return fmt::format("no equilibrium: {:.3g} of the weight unbalanced after {}, {}", rest.unbalanced, taken, moved);
}

}  // namespace blockweir::solid::output
