// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/expect/outcome_labels.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "bridge/geometry/polygon.hpp"
#include "solid/expect/formula_tables.hpp"
#include "solid/expect/quantity_tables.hpp"
#include "solid/watch/schedule_stability.hpp"

namespace blockweir::solid::expect {
namespace {

std::string mode(const Outcome& o, const std::string& subject) {
  if (const Failure* failure = failure_of(o, subject)) return failure->mode;
  return o.failure.moving() ? "moving" : "stands";
}

/// A rectangular block with breadth over height r on a plane of dip a, starting at rest. A bond in shear alone holds it
/// if W sin a <= W cos a tan(phi) + c L and it does not rotate. Otherwise it slides if friction is below both tan(a)
/// and r: T = N tan(phi) then has its resultant within the base. Otherwise it topples if r < tan(a), with q = 0.75 (sin
/// a - r cos a)/(1 + r^2) its angular acceleration times h/2g, and T/N = (sin a - q)/(cos a + r q) at its toe: beyond
/// tan(phi) the toe slips, too.
std::string slide_or_topple(const scene::Scene& scene, const std::string& subject) {
  const PlaneJoint p = plane_joint(scene, subject);
  const double r = p.length * p.length / geometry::signed_area(p.upper->vertices);
  const double held = p.friction + p.cohesion / (p.weight * std::cos(p.dip));
  if (std::tan(p.dip) <= held && r >= std::tan(p.dip)) return "stands";
  if (std::tan(p.dip) > p.friction && r >= p.friction) return "sliding";
  if (r >= std::tan(p.dip)) return "stands";
  const double q = 0.75 * (std::sin(p.dip) - r * std::cos(p.dip)) / (1 + r * r);
  const double shear_per_normal = (std::sin(p.dip) - q) / (std::cos(p.dip) + r * q);
  return shear_per_normal <= p.friction ? "overturning" : "sliding and overturning";
}

std::string stability(const Outcome& o, const std::string& /*subject*/) {
  return o.interface_energy.growth() ? "grows" : "stable";
}

std::string schedule_stability(const scene::Scene& scene, const std::string& subject) {
  return schedule_growth(oscillator_of(scene, subject)) > least_growth ? "grows" : "stable";
}

/// What holds of every fall, whatever its path.
std::string invariants(const Outcome& o, const std::string& /*subject*/) {
  constexpr double most_energy = 1e-5;  // made, of what the run had, or a fall by the model's size has
  const double fall_j = o.solid.model().weight_n_per_m * o.solid.model().size_m;
  if (!(o.energy.gain() <= most_energy || o.energy.made_j_per_m() <= most_energy * fall_j)) return "energy made";
  const double corners_pass_m = o.solid.model().give_under_weight_m;
  if (!(o.deepest_m() <= o.most_penetration_m() + corners_pass_m)) return "in each other";
  return "hold";
}

using Words = std::map<std::string, std::string (*)(const Outcome&, const std::string&)>;
const Words& words() {
  static const Words all = {{"invariants", invariants}, {"mode", mode}, {"stability", stability}};
  return all;
}

using WordFormulas = std::map<std::string, std::string (*)(const scene::Scene&, const std::string&)>;
const WordFormulas& word_formulas() {
  static const WordFormulas all = {{"slide-or-topple", slide_or_topple}, {"schedule-stability", schedule_stability}};
  return all;
}

}  // namespace

std::vector<std::string> label_quantity_names() {
  std::vector<std::string> names;
  for (const auto& [name, function] : words()) names.push_back(name);
  return names;
}

std::vector<std::string> label_formula_names() {
  std::vector<std::string> names;
  for (const auto& [name, function] : word_formulas()) names.push_back(name);
  return names;
}

bool is_label(const std::string& quantity) {
  return words().contains(quantity);
}

std::string label(const Outcome& outcome, const scene::Expectation& expectation) {
  return words().at(expectation.quantity)(outcome, expectation.of);
}

std::string word_formula(const scene::Scene& scene, const scene::Expectation& expectation) {
  const auto found = word_formulas().find(expectation.formula);
  if (found == word_formulas().end()) {
    throw std::runtime_error(fmt::format("no formula for a word is called \"{}\"", expectation.formula));
  }
  return found->second(scene, expectation.of);
}

}  // namespace blockweir::solid::expect
