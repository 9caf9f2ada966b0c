// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of shear forces that lag behind the normal forces. A growing shear changes the pressure of its contact or of a
// neighbour, and so the bounds: with full updates, bounds and forces may oscillate with growing amplitude. The updates
// are therefore relaxed by their last changes (Aitken's delta-squared for vectors: Irons and Tuck 1969, Int. J. Numer.
// Methods Eng. 1; Kuettler and Wall 2008, Comput. Mech. 43).
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {

class LaggedBounds {
 public:
  /// Of contact `index` [N per metre].
  double operator[](int index) const { return bounds_[at(index)].value; }

  /// Begins anew, with room for that many contacts.
  void begin(std::size_t contacts) {
    share_ = 1;
    bounds_.resize(contacts);
  }
  void set(int index, double bound_n) { bounds_[at(index)] = {.value = bound_n}; }

  /// Moves those of `contacts` towards what `allowed(index)` says now: true when each was within `tolerance_n(index)`
  /// of it.
  template <class Allowed, class Tolerance>
  bool follow(std::span<const int> contacts, const Allowed& allowed, const Tolerance& tolerance_n) {
    bool stand = true;
    double before = 0;
    double across = 0;
    double difference = 0;
    for (const int k : contacts) {
      Bound& bound = bounds_[at(k)];
      const double change = allowed(k) - bound.value;
      const double changes_by = change - bound.change;
      before += bound.change * bound.change;
      across += bound.change * changes_by;
      difference += changes_by * changes_by;
      bound.change = change;
      stand = stand && std::abs(change) <= tolerance_n(k);
    }
    // If updates keep their direction, the forces are still changing: no relaxation.
    if (before > 0 && difference > 0) {
      share_ = across < 0 ? std::clamp(-share_ * across / difference, least_share, 1.0) : 1;
    }
    if (stand) share_ = 1;
    for (const int k : contacts) bounds_[at(k)].value += share_ * bounds_[at(k)].change;
    return stand;
  }

 private:
  static constexpr double least_share = 0.2;

  struct Bound {
    double value = 0;
    double change = 0;  ///< that normal forces asked for last
  };
  std::vector<Bound> bounds_;
  double share_ = 1;  ///< of the changes asked for that bounds take
};

}  // namespace blockweir::solid
