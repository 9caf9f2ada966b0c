// SPDX-License-Identifier: GPL-3.0-or-later
// The section of a dam, its ground and the law of its base, drawn at random.
#pragma once

#include <cmath>
#include <vector>

#include "tests/independent/limit_equilibrium.hpp"
#include "tests/independent/random.hpp"

namespace blockweir::independent {

/// A dam's section: heel at the origin, toe on the base, level crest.
struct Section {
  double height;
  double base;
  double face_lean;  ///< m of the upstream face towards the dam, a metre of height
  double crest;
  double dip;  ///< of the base, radians, down towards the toe

  [[nodiscard]] Vec toe() const { return {base, -base * std::tan(dip)}; }
  [[nodiscard]] Vec face_top() const { return {face_lean * height, height}; }
  [[nodiscard]] Vec back_top() const { return {face_lean * height + crest, height}; }
  [[nodiscard]] Vec on_face(double share) const { return share * face_top(); }
  [[nodiscard]] Vec on_back(double share) const { return toe() + share * (back_top() - toe()); }
  [[nodiscard]] std::vector<Vec> outline() const { return {Vec(0, 0), toe(), back_top(), face_top()}; }
};

Section random_section(Random& random, double height);

/// Level before the heel; beyond the toe it does not rise into the dam's way.
Body ground_under(const Section& section);

/// Strengths are a share of the weight's mean stress on the base.
Law random_law(Random& random, double weight_stress_pa);

}  // namespace blockweir::independent
