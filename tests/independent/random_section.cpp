// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/independent/random_section.hpp"

#include <algorithm>
#include <numbers>

namespace blockweir::independent {

Section random_section(Random& random, double height) {
  Section section{.height = height};
  section.base = height * random.between(0.45, 1.0);
  section.face_lean = random.chance(0.5) ? 0 : random.between(0, 0.12);
  section.crest = section.base * random.between(0.15, 0.6) * (1 - section.face_lean);
  section.dip = random.chance(0.5) ? 0 : random.between(-8, 12) * std::numbers::pi / 180;
  return section;
}

Body ground_under(const Section& s) {
  const double reach = 2 * s.height;
  const Vec end = s.toe() + Vec(reach, s.dip > 0 ? -reach * std::tan(s.dip) : 0);
  const double floor = std::min(0.0, end.y()) - s.height / 2;
  Body ground{"ground", {Vec(-reach, floor), Vec(end.x(), floor), end, s.toe(), Vec(0, 0), Vec(-reach, 0)}, true};
  if (s.dip >= 0) ground.outline_m.erase(ground.outline_m.begin() + 3);
  return ground;
}

Law random_law(Random& random, double weight_stress_pa) {
  Law law{.friction_deg = random.between(25, 60)};
  if (random.chance(0.3)) law.cohesion_pa = random.between(0, 0.4) * weight_stress_pa;
  // More than the cone bears in tension counts as what it bears.
  const double apex = law.cohesion_pa / std::tan(law.friction_deg * std::numbers::pi / 180);
  if (random.chance(0.5)) law.tension_pa = random.between(0, 1.3) * apex;
  law.uplift = random.of(std::vector{Uplift::none, Uplift::triangular, Uplift::full});
  return law;
}

}  // namespace blockweir::independent
