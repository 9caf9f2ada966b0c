// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/rest_text.hpp"

#include <fmt/format.h>

namespace blockweir::solid::output {

std::string rest_text(const Rest& rest, long steps, const scene::Analysis& analysis, double farthest_m) {
  if (rest.found) return fmt::format("at rest after {} steps, {:.3g} of the weight unbalanced", steps, rest.unbalanced);
  const std::string moved = fmt::format("largest displacement {:.4g} m", farthest_m);
  if (rest.steps == 0) return "no equilibrium: no step towards it could be solved; " + moved;
  if (rest.unbalanced <= analysis.residual_tolerance) {
    return fmt::format(
        "no equilibrium: after {} steps forces balance, but only where joints have slipped by more than "
        "failure_displacement_m = {:.3g} m; {}",
        steps, analysis.failure_displacement_m, moved);
  }
  return fmt::format("no equilibrium: {:.3g} of the weight unbalanced after {} steps, {}", rest.unbalanced, steps,
                     moved);
}

}  // namespace blockweir::solid::output
