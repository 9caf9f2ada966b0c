// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/force_rule.hpp"

namespace blockweir::solid {

PointForces::PointForces(const ForceRule& rule, const Eigen::Matrix2d& flexibility)
    : may_open_(rule.opens && rule.least_normal == 0),
      opening_(rule.opening),
      least_normal_(rule.least_normal),
      most_normal_(rule.most_normal),
      friction_(rule.friction),
      cohesion_(rule.cohesion),
      gap_by_normal_(flexibility(0, 0) + rule.compliance[0]),
      gap_by_shear_(flexibility(1, 0)),
      slip_by_shear_(flexibility(1, 1) + rule.compliance[1]) {
  const double per = 1 / (gap_by_normal_ * slip_by_shear_ - gap_by_shear_ * gap_by_shear_);
  stiffness_ = {slip_by_shear_ * per, -gap_by_shear_ * per, gap_by_normal_ * per};
  shear_per_slip_ = 1 / slip_by_shear_;
  for (const bool positive : {false, true}) {
    const double side = positive ? 1 : -1;
    Slipping& s = slipping_[positive ? 1 : 0];
    s.opening = opening_[positive ? 1 : 0];
    const double by_shear = gap_by_shear_ - s.opening * slip_by_shear_;
    const double by_normal = gap_by_normal_ - s.opening * gap_by_shear_ + side * friction_ * by_shear;
    s.gap_by_cohesion = cohesion_ > 0 ? by_shear * side * cohesion_ : 0;
    s.normal_per_gap = by_normal > 0 ? 1 / by_normal : 0;
  }
}

}  // namespace blockweir::solid
