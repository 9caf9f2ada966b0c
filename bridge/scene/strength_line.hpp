// SPDX-License-Identifier: GPL-3.0-or-later
// A linear bound of shear stress, and friction laws whose tangent is such a line at each normal stress.
#pragma once

#include <type_traits>
#include <vector>

namespace blockweir::scene {

/// |tau| <= cohesion + sigma * friction, sigma positive in compression.
struct StrengthLine {
  double cohesion_pa = 0;
  double friction = 0;  ///< tangent
};

/// The first of these laws that a joint states. Each law has its own file with its members and three functions:
/// `keys()`, the keys that state them; `bends()`, whether they are stated; `tangent(friction, normal_pa)`, the tangent
/// of its concave bound of shear at a compression, where `friction` is tan(friction angle).
template <class... Laws>
struct FirstOf : Laws... {
  double curve_over = 1;  ///< strength reduction factor of the curve

  bool operator==(const FirstOf&) const = default;

  /// Whether friction depends on the normal stress.
  [[nodiscard]] bool bends() const { return (Laws::bends() || ...); }
  /// Tangent of the curve; without a curve, the straight line of that friction.
  [[nodiscard]] StrengthLine tangent(double friction, double normal_pa) const {
    StrengthLine line{.friction = friction};
    static_cast<void>(((Laws::bends() && (line = Laws::tangent(friction, normal_pa), true)) || ...));
    if (bends()) line = {.cohesion_pa = line.cohesion_pa / curve_over, .friction = line.friction / curve_over};
    return line;
  }
  /// Appended to the keys of the whole law, which has this one as a base class.
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
