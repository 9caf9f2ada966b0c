// SPDX-License-Identifier: GPL-3.0-or-later
// A fall as judged after each step, by measures that are the tests' own: energy made, and blocks in each other.
#pragma once

#include <algorithm>
#include <vector>

#include "solid/step/solid.hpp"
#include "solid/watch/energy.hpp"
#include "tests/overlap.hpp"

namespace blockweir::test {

struct Fall {
  double made_over_dissipated = 0;  ///< of a wall that stands: over what a drop of all by a tenth of a metre would give
  double overlap_m = 0;             ///< the largest at any step's end
  double told_m = 0;                ///< largest overlap as the run tells it
  double give_m = 0;                ///< that blocks which strain may be in each other
};

inline Fall watched(const scene::Scene& scene) {
  solid::Solid solid(scene);
  Fall fall;
  fall.give_m = solid.model().give_under_weight_m;
  const double first = solid::energy_of(solid).total();
  double last = first;
  double made = 0;
  const double dt = scene.analysis.step_s;
  for (long n = 0; static_cast<double>(n) * dt < scene.analysis.duration_s; ++n) {
    solid.advance(static_cast<double>(n) * dt, static_cast<double>(n + 1) * dt, {});
    const double now = solid::energy_of(solid).total();
    made += std::max(0.0, now - last);
    last = now;
    std::vector<Outline> outlines;
    for (std::size_t b = 0; b < solid.blocks().size(); ++b) {
      Outline& outline = outlines.emplace_back();
      for (const scene::Point& X : solid.blocks()[b].vertices) outline.push_back(solid.placements()[b].position(X));
    }
    fall.overlap_m = std::max(fall.overlap_m, largest_overlap_m(outlines));
  }
  fall.told_m = solid.counts().overlap_m;
  double weight = 0;
  for (const solid::Block& block : solid.blocks()) weight += block.fixed ? 0 : block.mass_per_m() * 9.81;
  fall.made_over_dissipated = made / std::max(first - last + made, 0.1 * weight);
  return fall;
}

}  // namespace blockweir::test
