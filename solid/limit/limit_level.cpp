// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/limit/limit_level.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace blockweir::solid::limit {
namespace {

constexpr double level_width = 1e-12;  // over the rise from the empty reservoir

/// The highest level without power, where there is none at the lower one: nothing resists the mechanism.
double end_of_none(const std::function<double(double)>& power, double low_m, double high_m, double none) {
  constexpr int halvings = 100;
  for (int i = 0; i < halvings; ++i) {
    const double middle_m = (low_m + high_m) / 2;
    (power(middle_m) > none ? high_m : low_m) = middle_m;
  }
  return low_m;
}

/// Where `power` changes its sign between a level that it is not positive at and one that it is positive at.
double root(const std::function<double(double)>& power, double low_m, double high_m, double at_low, double at_high) {
  constexpr double round_off = 1e-12;
  if (at_low >= -round_off * at_high) return end_of_none(power, low_m, high_m, round_off * at_high);
  std::uintmax_t most = 200;
  const boost::math::tools::eps_tolerance<double> to_round_off(50);
  const auto [below, above] =
      boost::math::tools::toms748_solve(power, low_m, high_m, at_low, at_high, to_round_off, most);
  return (below + above) / 2;
}

/// From a level on downwards, by mechanisms.
LimitLevel search_from(double level_m, const LimitAnalysis& structure, const Wrenches& empty,
                       const WaterAtLevel& reservoir_at, double empty_m) {
  constexpr int most_programs = 100;
  LimitLevel found{.level_m = level_m};
  while (++found.programs < most_programs) {
    const LargestFactor at_level = structure.largest_factor(empty, reservoir_at(found.level_m));
    if (at_level.bearing == Bearing::bears_any && found.programs > 1) break;  // what nothing resists ends here
    found.at_it = at_level;
    if (found.at_it.bearing == Bearing::bears_none) {
      throw std::runtime_error(
          "limit analysis: the structure bears the empty reservoir, and yet no part of the full one; expected "
          "a level between them; look for loads or strengths in wrong units");
    }
    const bool bears = found.at_it.bearing == Bearing::bears_any || found.at_it.factor >= 1 - level_width;
    if (bears) break;
    const Twists& mechanism = found.at_it.mechanism;
    const double needed = structure.resistance(mechanism) - power(empty, mechanism);
    const auto excess = [&](double other_m) { return power(reservoir_at(other_m), mechanism) - needed; };
    const double at_high = excess(found.level_m);
    if (at_high <= 0) break;  // but for round-off it is the level
    const double next = root(excess, empty_m, found.level_m, -needed, at_high);
    const bool settled = found.level_m - next <= level_width * (found.level_m - empty_m);
    found.level_m = next;
    if (settled) break;
  }
  const bool failed = found.programs > 1 || found.at_it.factor < 1;
  found.outcome = failed && found.at_it.bearing == Bearing::fails_at_a_factor ? Filled::fails : Filled::stands_full;
  return found;
}

}  // namespace

LimitLevel limit_level(const LimitAnalysis& structure, const Wrenches& dead, const WaterAtLevel& water,
                       const LevelRange& range) {
  const Wrenches tailwater = water(range.empty_m);
  const Wrenches empty = combined(dead, 1, tailwater);
  if (!structure.bears(empty)) {
    LimitLevel found{.level_m = range.full_m};
    found.at_it.mechanism = structure.collapse(empty, /*however_strong=*/false);
    return found;
  }
  const auto reservoir_at = [&](double level_m) { return combined(water(level_m), -1, tailwater); };
  // A structure below the level has water on both sides, which may hold it up.
  std::vector<double> levels_m = range.lower_tops_m;
  levels_m.push_back(range.full_m);
  LimitLevel found;
  int programs = 0;
  for (const double level_m : levels_m) {
    found = search_from(level_m, structure, empty, reservoir_at, range.empty_m);
    found.programs = programs += found.programs;
    if (found.outcome == Filled::fails) break;
  }
  return found;
}

}  // namespace blockweir::solid::limit
