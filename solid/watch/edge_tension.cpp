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

bool is_brittle_in_tension(const JointProperties& law) {
  return law.tension_pa > 0 && law.softening_slip_m == 0 && !law.keeps_cohesion && law.bonded_length_m < 0;
}

/// Largest tension at an end of a straight joint under a stress that is linear along it [Pa].
double linear_stress(const Solid& solid, const std::vector<const ContactPoint*>& joint) {
  const Point about = solid.place(*joint.front());
  Point along = Point::Zero();
  for (const ContactPoint* c : joint) {
    const Point to = solid.place(*c) - about;
    if (to.norm() > along.norm()) along = to;
  }
  if (along.norm() <= 1e-6 * solid.size_m()) return 0;
  along.normalize();
  double low = 0;
  double high = 0;
  double pull = 0;
  double moment = 0;  // about the first contact
  for (const ContactPoint* c : joint) {
    const double s = along.dot(solid.place(*c) - about);
    low = std::min(low, s);
    high = std::max(high, s);
    pull -= c->force.x();
    moment -= c->force.x() * s;
  }
  const double length = high - low;
  const double about_middle = moment - pull * (low + high) / 2;
  return pull / length + 6 * std::abs(about_middle) / (length * length);
}

}  // namespace

void EdgeTension::look(const Solid& solid, double time_s, double level_m) {
  std::map<std::pair<int, int>, std::vector<const ContactPoint*>> bonded;
  for (const ContactPoint& c : solid.contacts()) {
    if (!c.bonded() || !is_brittle_in_tension(solid.laws()[c.law])) continue;
    const auto [a, b] = c.pair();
    if (!solid.blocks()[at(a)].meshed && !solid.blocks()[at(b)].meshed) bonded[c.pair()].push_back(&c);
  }
  for (const auto& [pair, joint] : bonded) {
    const double strength_pa = solid.laws()[joint.front()->law].tension_pa;
    const double stress_pa = linear_stress(solid, joint);
    if (stress_pa <= ratio_ * strength_pa) continue;
    ratio_ = stress_pa / strength_pa;
    stress_pa_ = stress_pa;
    time_s_ = time_s;
    level_m_ = level_m;
    joint_ = joint_name(solid, pair.first, pair.second);
  }
}

std::string EdgeTension::warning() const {
  constexpr double round_off = 1e-6;
  if (ratio_ <= 1 + round_off) return {};
  return fmt::format(
      "the bond of joint \"{}\" holds by its tension: with a stress that is linear along the joint {:.4g} Pa at its "
      "edge after {:.4g} s{}; expected at most its tension_strength_pa, {:.4g}; blocks without a mesh bear up to three "
      "times as much, so the structure may fail sooner; give both blocks a mesh_size_m",
      joint_, stress_pa_, time_s_, std::isnan(level_m_) ? "" : fmt::format(", level {:.5g} m", level_m_),
      stress_pa_ / ratio_);
}

}  // namespace blockweir::solid
