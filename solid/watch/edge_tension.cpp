// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/edge_tension.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <vector>

#include "bridge/scene/at.hpp"
#include "solid/watch/joint_name.hpp"

namespace blockweir::solid {
namespace {

/// Whether a crack at its edge would reduce its strength. A softening joint has no edge stress of its own.
bool cracks(const JointProperties& law) {
  const bool bonded = law.tension_pa > 0 ? !law.softens() : law.cohesion_pa > 0;
  return bonded && !law.keeps_cohesion && law.bonded_length_m < 0;
}

/// Sum of the contact forces of a straight joint, per metre of thickness.
struct Resultant {
  double length_m = 0;
  double normal = 0;  ///< N/m, compression positive
  double moment = 0;  ///< N, its size about the joint's middle
  double shear = 0;   ///< N/m, its size
  double cohesion = 0;
  double friction = 0;  ///< N/m that it gives

  /// Largest tension at an end under a stress that is linear along the joint [Pa].
  [[nodiscard]] double edge_stress_pa() const { return (6 * moment / length_m - normal) / length_m; }
  /// Share of the joint that bears when a crack has run from its tense end to where the stress is `strength_pa`:
  /// strength l^2 - 2 N l + 6 N d = 0, d the way of the resultant from the other end.
  [[nodiscard]] double held_share(double strength_pa) const {
    if (edge_stress_pa() <= strength_pa) return 1;
    if (normal <= 0) return 0;
    const double d = length_m / 2 - moment / normal;
    const double root = std::sqrt(std::max(0.0, 1 - 6 * d * strength_pa / normal));
    return std::clamp(6 * d / (1 + root) / length_m, 0.0, 1.0);
  }
};

Resultant resultant(const Solid& solid, const std::vector<const ContactPoint*>& joint) {
  const Point about = solid.state().place(*joint.front());
  Point along = Point::Zero();
  for (const ContactPoint* c : joint) {
    const Point to = solid.state().place(*c) - about;
    if (to.norm() > along.norm()) along = to;
  }
  if (along.norm() <= 1e-6 * solid.model().size_m) return {};
  along.normalize();
  double low = 0;
  double high = 0;
  Resultant r;
  for (const ContactPoint* c : joint) {
    const double s = along.dot(solid.state().place(*c) - about);
    low = std::min(low, s);
    high = std::max(high, s);
    const Strength strength = solid.laws().strength(*c, c->force.x());
    r.normal += c->force.x();
    r.moment += c->force.x() * s;
    r.shear += c->force.y();
    r.cohesion += strength.cohesion;
    r.friction += strength.shear_of_friction(c->force.x());
  }
  r.length_m = high - low;
  r.moment = std::abs(r.moment - r.normal * (low + high) / 2);
  r.shear = std::abs(r.shear);
  return r;
}

}  // namespace

EdgeTension::Bond EdgeTension::judged(const Solid& solid, const std::vector<const ContactPoint*>& joint) {
  const JointProperties& law = solid.laws()[joint.front()->law];
  const Resultant r = resultant(solid, joint);
  Bond bond;
  if (r.length_m == 0) return bond;
  bond.stress_pa = r.edge_stress_pa();
  bond.strength_pa = law.tension_pa;
  bond.excess = (bond.stress_pa - law.tension_pa) / (law.tension_pa + law.cohesion_pa);
  bond.cracked = 1 - r.held_share(law.tension_pa);
  constexpr double negligible = 1e-6;
  if (r.shear > negligible * (r.cohesion + std::abs(r.normal))) {
    bond.factor = std::max(0.0, r.cohesion + r.friction) / r.shear;
    bond.cracked_factor = std::max(0.0, r.cohesion * (1 - bond.cracked) + r.friction) / r.shear;
  }
  return bond;
}

std::vector<EdgeTension::Bond> EdgeTension::bonds_of(const Solid& solid) {
  std::map<std::pair<int, int>, std::vector<const ContactPoint*>> bonded;
  for (const ContactPoint& c : solid.contacts()) {
    if (!c.bonded() || !cracks(solid.laws()[c.law])) continue;
    const auto [a, b] = c.pair();
    if (!solid.blocks()[at(a)].meshed && !solid.blocks()[at(b)].meshed) bonded[c.pair()].push_back(&c);
  }
  std::vector<Bond> bonds;
  for (const auto& [pair, joint] : bonded) {
    Bond bond = judged(solid, joint);
    if (bond.stress_pa <= 0) continue;
    bond.blocks = pair;
    bond.joint = joint_name(solid, pair.first, pair.second);
    const bool first_fixed = solid.blocks()[at(pair.first)].fixed;
    bond.block = solid.blocks()[at(first_fixed ? pair.second : pair.first)].name;
    bonds.push_back(std::move(bond));
  }
  return bonds;
}

void EdgeTension::look(const Solid& solid, double time_s, double level_m) {
  for (Bond& bond : bonds_of(solid)) {
    if (bond.excess <= worst_.excess) continue;
    worst_ = std::move(bond);
    time_s_ = time_s;
    level_m_ = level_m;
  }
}

std::vector<CrackedJoint> EdgeTension::cracked_joints(const Solid& solid) {
  std::vector<CrackedJoint> found;
  for (const Bond& bond : bonds_of(solid)) {
    if (bond.excess > 0 && loses_cohesion(bond)) found.push_back({bond.blocks, bond.joint, bond.cracked});
  }
  return found;
}

bool EdgeTension::loses_cohesion(const Bond& bond) {
  constexpr double seen = 1e-2;
  return bond.cracked_factor < (1 - seen) * bond.factor;
}

std::string EdgeTension::warning() const {
  constexpr double round_off = 1e-6;
  const bool beyond_tension = worst_.stress_pa > (1 + round_off) * worst_.strength_pa && worst_.strength_pa > 0;
  const bool beyond_cohesion = worst_.excess > 0 && loses_cohesion(worst_);
  if (!beyond_tension && !beyond_cohesion) return {};
  const std::string level = std::isnan(level_m_) ? "" : fmt::format("level {:.5g} m", level_m_);
  const std::string when = std::isnan(time_s_)
                               ? (level.empty() ? "under its loads" : "at a " + level)
                               : fmt::format("after {:.4g} s{}", time_s_, level.empty() ? "" : ", " + level);
  std::string text;
  if (worst_.strength_pa > 0) {
    text = fmt::format(
        "the bond of joint \"{}\" holds by its tension: with a stress that is linear along the joint {:.4g} Pa at its "
        "edge {}; expected at most its tension_strength_pa, {:.4g}; blocks without a mesh bear up to three times as "
        "much, so the structure may fail sooner",
        worst_.joint, worst_.stress_pa, when, worst_.strength_pa);
  } else {
    text = fmt::format(
        "joint \"{}\" has no tension_strength_pa, and its cohesion acts over the whole length; but {:.3g} % of the "
        "joint is in tension {}, if stress is linear along it",
        worst_.joint, 100 * worst_.cracked, when);
  }
  if (beyond_cohesion) {
    text += fmt::format("; with cohesion on the compressed part alone its sliding factor is {:.4g}, not {:.4g}",
                        worst_.cracked_factor, worst_.factor);
    if (worst_.cracked_factor < 1) text += ": the structure fails sooner than this run says";
  }
  return text +
         fmt::format("; give block \"{}\" a mesh_size_m, or say with bonded_length_m how much of the joint is bonded",
                     worst_.block);
}

}  // namespace blockweir::solid
