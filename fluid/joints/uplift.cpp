// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/uplift.hpp"

#include <algorithm>

#include "fluid/joints/drain.hpp"

namespace blockweir::joints {
namespace {

using scene::KnownHeads;
using scene::Uplift;

double height_at(const Joint& joint, double at_m) {
  const double line_m = joint.mouth.height_m + (joint.end.height_m - joint.mouth.height_m) * at_m / joint.length_m;
  scene::Bend from;
  for (const scene::Bend& to : joint.bends) {
    if (at_m <= to.station_m) {
      return line_m + from.above_m +
             (to.above_m - from.above_m) * (at_m - from.station_m) / (to.station_m - from.station_m);
    }
    from = to;
  }
  return line_m + from.above_m * (joint.length_m - at_m) / (joint.length_m - from.station_m);
}

double head(const Joint& joint, const End& end) {
  return end.height_m + end.pressure_pa / joint.water_n_per_m3;
}

double pressure_of(const Joint& joint, double at_m, double head_m) {
  return joint.water_n_per_m3 * std::max(0.0, head_m - height_at(joint, at_m));
}

/// In the open part of a joint: water at rest with the head of its end.
double open_pressure(const Joint& joint, const End& end, double at_m) {
  return end.pressure_pa > 0 ? pressure_of(joint, at_m, head(joint, end)) : 0;
}

/// Where the closed part of a joint begins or ends.
struct Tip {
  double at_m;
  double pressure_pa;
};

/// At the drain, in a joint whose pressure falls linearly between its open parts.
double drained_pressure(const scene::Drain& drain, const Joint& joint, const Tip& from, const Tip& to) {
  const double share = (drain.station_m - from.at_m) / (to.at_m - from.at_m);
  const double p = from.pressure_pa + share * (to.pressure_pa - from.pressure_pa);
  const double undrained = height_at(joint, drain.station_m) + p / joint.water_n_per_m3;
  const double lower = std::min(head(joint, joint.mouth), head(joint, joint.end));
  return pressure_of(joint, drain.station_m, head_at_drain(drain, undrained, lower));
}

void triangular(const KnownHeads& /*known*/, const Joint& joint, Profile& into) {
  into.add(0, joint.mouth.pressure_pa);
  into.add(joint.length_m, joint.end.pressure_pa);
}

void full(const KnownHeads& /*known*/, const Joint& joint, Profile& into) {
  const double higher = std::max(joint.mouth.pressure_pa, joint.end.pressure_pa);
  into.add(0, higher);
  into.add(joint.length_m, higher);
}

/// Without open parts this is the law of drains, without a drain that of cracks. A drain that a crack has reached has
/// no effect.
void drained_or_cracked(const KnownHeads& known, const Joint& joint, Profile& into) {
  const double to_m = joint.length_m - joint.open_at_end_m;
  const Tip from = {joint.open_at_mouth_m, open_pressure(joint, joint.mouth, joint.open_at_mouth_m)};
  const Tip to = {to_m, open_pressure(joint, joint.end, to_m)};
  into.add(0, joint.mouth.pressure_pa);
  for (const scene::Bend& bend : joint.bends) {
    if (bend.station_m < from.at_m) into.add(bend.station_m, open_pressure(joint, joint.mouth, bend.station_m));
  }
  if (from.at_m > 0) into.add(from.at_m, from.pressure_pa);
  if (known.drain && known.drain->station_m > from.at_m && known.drain->station_m < to.at_m) {
    into.add(known.drain->station_m, drained_pressure(*known.drain, joint, from, to));
  }
  if (joint.open_at_end_m > 0) into.add(to.at_m, to.pressure_pa);
  for (const scene::Bend& bend : joint.bends) {
    if (bend.station_m > to.at_m) into.add(bend.station_m, open_pressure(joint, joint.end, bend.station_m));
  }
  if (from.at_m < joint.length_m) into.add(joint.length_m, joint.end.pressure_pa);
}

void heads(const KnownHeads& known, const Joint& joint, Profile& into) {
  const double low = head(joint, joint.end);
  const double then = known.level_m - low;
  const double now = head(joint, joint.mouth) - low;
  const double ratio = then > 0 ? std::max(0.0, now / then) : 0;
  into.add(0, joint.mouth.pressure_pa);
  for (const scene::Piezometer& p : known.piezometers) {
    const double follows = p.head_m > low ? ratio : 1;
    into.add(p.station_m, pressure_of(joint, p.station_m, low + follows * (p.head_m - low)));
  }
  into.add(joint.length_m, joint.end.pressure_pa);
}

struct Law {
  Uplift law;
  void (*pressures)(const KnownHeads&, const Joint&, Profile&);
};
constexpr Law laws[] = {{Uplift::triangular, triangular},
                        {Uplift::full, full},
                        {Uplift::drained, drained_or_cracked},
                        {Uplift::cracked, drained_or_cracked},
                        {Uplift::heads, heads}};

}  // namespace

double Profile::pressure(double at_m) const {
  std::size_t to = 1;
  while (to + 1 < knots_.size() && knots_[to].at_m <= at_m) ++to;
  const Knot& a = knots_[to - 1];
  const Knot& b = knots_[to];
  return a.pressure_pa - (a.pressure_pa - b.pressure_pa) * (at_m - a.at_m) / (b.at_m - a.at_m);
}

double Profile::force() const {
  double sum = 0;
  for (std::size_t i = 1; i < knots_.size(); ++i) {
    sum += (knots_[i].at_m - knots_[i - 1].at_m) * (knots_[i].pressure_pa + knots_[i - 1].pressure_pa) / 2;
  }
  return sum;
}

double Profile::moment_about_mouth() const {
  double sum = 0;
  for (std::size_t i = 1; i < knots_.size(); ++i) {
    const Knot& a = knots_[i - 1];
    const Knot& b = knots_[i];
    const double length = b.at_m - a.at_m;
    sum += length / 6 * (a.pressure_pa * (2 * a.at_m + b.at_m) + b.pressure_pa * (a.at_m + 2 * b.at_m));
  }
  return sum;
}

Profile uplift(Uplift law, const KnownHeads& known, const Joint& joint) {
  Profile profile;
  for (const Law& one : laws) {
    if (one.law == law) one.pressures(known, joint, profile);
  }
  return profile;
}

}  // namespace blockweir::joints
