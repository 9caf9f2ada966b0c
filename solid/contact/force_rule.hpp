// SPDX-License-Identifier: GPL-3.0-or-later
// What bounds the two forces of a contact, a support or a bolt, and the forces that fulfil it while all others stand.
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>

namespace blockweir::solid {

/// Normal force within its bounds, shear within cohesion + normal * friction. A force inside its bounds closes its gap
/// or slip, but for what its compliance gives way: apart + compliance * force = 0.
struct ForceRule {
  static constexpr double unbounded = std::numeric_limits<double>::infinity();

  double friction = 0;                                   ///< tangent
  double cohesion = 0;                                   ///< N per metre
  double least_normal = 0;                               ///< N per metre
  double most_normal = unbounded;                        ///< N per metre
  bool opens = true;                                     ///< at its least normal force it has no shear either
  Eigen::Vector2d compliance = Eigen::Vector2d::Zero();  ///< m per N per metre; 0: what closes is hard
  std::array<double, 2> opening = {0, 0};                ///< d gap / d slip under shear of negative, positive sign
};

/// A force that is to be found: gap and slip that it resists, less what the trial moves beyond it [m].
struct Ruled {
  Eigen::Vector2d apart = Eigen::Vector2d::Zero();
  ForceRule rule{};
};

/// Forces (normal, shear) and whether the shear is at its bound.
struct RuledForce {
  Eigen::Vector2d force = Eigen::Vector2d::Zero();
  bool slips = false;
};

/// `flexibility`: d (gap, slip) / d (normal, shear), symmetric and positive, compliance not among it; `apart`: what gap
/// and slip would be without the forces [m]. Of Coulomb's law one point has at least one solution, for friction that
/// does not jam; where it jams the shear is left out.
RuledForce forces_of(const ForceRule& rule, const Eigen::Matrix2d& flexibility, const Eigen::Vector2d& apart);

}  // namespace blockweir::solid
