// SPDX-License-Identifier: GPL-3.0-or-later
// A straight bound of shear stress, and laws whose bound is another line at each normal stress.
#pragma once

#include <type_traits>
#include <vector>

namespace blockweir::scene {

/// |tau| <= cohesion + sigma * friction, sigma compression.
struct StrengthLine {
  double cohesion_pa = 0;
  double friction = 0;  ///< tangent
};

/// The first of some laws that a joint states. Each has a file of its own: its members; `keys()` that state them;
/// `bends()`, are they stated?; and `tangent(friction, normal_pa)`, the line that touches its bound of shear, concave,
/// at a compression, `friction` being tan(friction angle).
template <class... Laws>
struct FirstOf : Laws... {
  double curve_over = 1;  ///< strength reduction of the curve

  bool operator==(const FirstOf&) const = default;

  /// Does friction change with the normal stress?
  [[nodiscard]] bool bends() const { return (Laws::bends() || ...); }
  /// Of the curve, or where there is none the straight line of that friction.
  [[nodiscard]] StrengthLine tangent(double friction, double normal_pa) const {
    StrengthLine line{.friction = friction};
    static_cast<void>(((Laws::bends() && (line = Laws::tangent(friction, normal_pa), true)) || ...));
    if (bends()) line = {.cohesion_pa = line.cohesion_pa / curve_over, .friction = line.friction / curve_over};
    return line;
  }
  /// Appended to the keys of the whole law, which has this as a base.
  template <class Key>
  static void append_keys(std::vector<Key>& keys) {
    (append<Laws>(keys), ...);
  }

 private:
  template <class Law, class Key>
  static void append(std::vector<Key>& keys) {
    for (const auto& key : Law::keys()) keys.push_back(key.template of<typename Key::Of>());
  }
};

}  // namespace blockweir::scene
