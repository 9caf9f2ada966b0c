// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/limit/limit_strength.hpp"

#include <cmath>

namespace blockweir::solid::limit {
namespace {

constexpr double largest_reduction = 1e6;  // a factor beyond is none, and so is one below its inverse
constexpr double reduction_width = 1e-12;

bool suffices(const Shortage& shortage) {
  return shortage.ratio <= 1e-14;
}

/// Reductions that can and that cannot be borne, a factor of 2 apart.
struct Bracket {
  double borne = 0;
  double short_of = 0;
  Shortage shortage;
};

/// From the reduction that cannot be borne, by Newton's method on the shortage, bisection where that leaves the
/// bracket, until what is short is within the programs' tolerances.
double narrowed(const LimitAnalysis& structure, const Wrenches& loads, Bracket& bracket) {
  constexpr double negligible = 1e-12;
  const auto newton = [&] { return bracket.short_of - bracket.shortage.ratio / bracket.shortage.per_reduction; };
  for (int i = 0; i < 200 && bracket.short_of - bracket.borne > reduction_width * bracket.borne; ++i) {
    double next = newton();
    const bool within = next > bracket.borne && next < bracket.short_of;
    if (within && bracket.shortage.ratio <= negligible) return next;
    if (!within) next = (bracket.borne + bracket.short_of) / 2;
    if (next <= bracket.borne || next >= bracket.short_of) break;
    const auto shortage = structure.shortage(loads, next);
    if (shortage && suffices(*shortage)) {
      bracket.borne = next;
    } else {
      bracket.short_of = next;
      if (shortage) bracket.shortage = *shortage;
    }
  }
  return bracket.borne;
}

/// Of what has no shear strength that could be reduced.
LimitStrength without_strength(const LimitAnalysis& structure, const Wrenches& loads) {
  const auto shortage = structure.shortage(loads, 1);
  if (shortage && suffices(*shortage)) return {.bearing = Bearing::bears_any};
  return {.bearing = Bearing::bears_none,
          .mechanism = shortage ? shortage->mechanism : structure.collapse(loads, true)};
}

}  // namespace

LimitStrength limit_strength(const LimitAnalysis& structure, const Wrenches& loads) {
  if (!structure.has_shear_strength()) return without_strength(structure, loads);
  Bracket bracket;
  double reduction = 1;
  while (bracket.borne == 0 || bracket.short_of == 0) {
    if (reduction > largest_reduction) return {.bearing = Bearing::bears_any};
    if (reduction < 1 / largest_reduction)
      return {.bearing = Bearing::bears_none, .mechanism = bracket.shortage.mechanism};
    const auto shortage = structure.shortage(loads, reduction);
    if (!shortage) return {.bearing = Bearing::bears_none, .mechanism = structure.collapse(loads, true)};
    if (suffices(*shortage)) {
      bracket.borne = reduction;
      reduction *= 2;
    } else {
      bracket.short_of = reduction;
      bracket.shortage = *shortage;
      reduction /= 2;
    }
  }
  LimitStrength found{.bearing = Bearing::fails_at_a_factor, .factor = narrowed(structure, loads, bracket)};
  found.mechanism = bracket.shortage.mechanism;
  double powers = 0;
  for (std::size_t b = 0; b < loads.size(); ++b) {
    powers += loads[b].head<2>().norm() * found.mechanism[b].head<2>().norm();
    powers += std::abs(loads[b][2] * found.mechanism[b][2]);
  }
  const double jam_power = bracket.shortage.jam_power;
  found.jams = jam_power > 0;
  found.gap =
      std::abs(power(loads, found.mechanism) - structure.resistance(found.mechanism, bracket.short_of) - jam_power) /
      powers;
  return found;
}

}  // namespace blockweir::solid::limit
