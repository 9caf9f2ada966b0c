// SPDX-License-Identifier: GPL-3.0-or-later
// The shear strength of rough joints in rock (Barton and Choubey 1977, Rock Mechanics 10, eq. 7):
//   tau = sigma tan(phi + JRC log10(JCS/sigma)),
// phi is the friction angle of the smooth joint. The curve is concave: friction falls as the compression grows.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bridge/scene/joint_law_key.hpp"
#include "bridge/scene/strength_line.hpp"

namespace blockweir::scene {

struct BartonBandis {
  double roughness = 0;         ///< JRC; 0: friction is phi at any stress
  double wall_strength_pa = 0;  ///< JCS, compressive strength of the joint's walls

  bool operator==(const BartonBandis&) const = default;

  [[nodiscard]] bool bends() const { return roughness > 0 && wall_strength_pa > 0; }
  /// The tangent at a compression [Pa]; `friction` is tan(phi). Where the total angle would exceed 70 degrees, and in
  /// tension, that angle is used. Beyond JCS the tangent at JCS is used.
  [[nodiscard]] StrengthLine tangent(double friction, double normal_pa) const {
    constexpr double degree = std::numbers::pi / 180;
    const double steepest = std::max(70 * degree, std::atan(friction));
    const double sigma = std::min(normal_pa, wall_strength_pa);
    const double angle =
        sigma > 0 ? std::atan(friction) + roughness * degree * std::log10(wall_strength_pa / sigma) : steepest;
    if (angle >= steepest) return {.cohesion_pa = 0, .friction = std::tan(steepest)};
    const double secant = std::tan(angle);
    const double bend = (1 + secant * secant) * roughness * degree / std::numbers::ln10;  // -sigma d secant/d sigma
    const double slope = std::max(0.0, secant - bend);
    return {.cohesion_pa = sigma * (secant - slope), .friction = slope};
  }

  static std::vector<LawKey<BartonBandis>> keys() {
    using Key = LawKey<BartonBandis>;
    return {{"roughness",
             &BartonBandis::roughness,
             Key::Range::not_negative,
             [](const BartonBandis& law) { return law.roughness > 0 && law.wall_strength_pa == 0; },
             "wall strength",
             {"wall_strength_pa"}},
            {"wall_strength_pa",
             &BartonBandis::wall_strength_pa,
             Key::Range::not_negative,
             [](const BartonBandis& law) { return law.roughness == 0 && law.wall_strength_pa > 0; },
             "roughness",
             {"roughness"}}};
  }
};

}  // namespace blockweir::scene
