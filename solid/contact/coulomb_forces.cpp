// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/coulomb_forces.hpp"

#include <algorithm>
#include <limits>

#include "bridge/scene/at.hpp"
#include "solid/contact/complementarity.hpp"

namespace blockweir::solid {

std::optional<Eigen::VectorXd> coulomb_forces(const CoulombContacts& contacts) {
  const auto n = static_cast<Eigen::Index>(contacts.friction.size());
  if (n == 0) return Eigen::VectorXd();
  const double per_n = contacts.flexibility.diagonal().mean();  // forces are counted by what they move
  const double size = std::max(contacts.apart.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
  // Of each contact: its pressure, its shear in both directions, and how far it slips.
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(4 * n, 4 * n);
  Eigen::VectorXd q = Eigen::VectorXd::Zero(4 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      const Eigen::Matrix2d f = contacts.flexibility.block<2, 2>(2 * i, 2 * j) / per_n;
      M.block<3, 3>(4 * i, 4 * j) << f(0, 0), f(0, 1), -f(0, 1),  //
          f(1, 0), f(1, 1), -f(1, 1),                             //
          -f(1, 0), -f(1, 1), f(1, 1);
    }
    M.block<2, 1>(4 * i + 1, 4 * i + 3).setOnes();
    M.block<1, 3>(4 * i + 3, 4 * i) << contacts.friction[at(i)], -1, -1;
    q.segment<3>(4 * i) << contacts.apart[2 * i], contacts.apart[2 * i + 1], -contacts.apart[2 * i + 1];
  }
  const auto z = solve_complementarity(M, q / size);
  if (!z) return std::nullopt;
  Eigen::VectorXd forces(2 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    forces.segment<2>(2 * i) << (*z)[4 * i], (*z)[4 * i + 1] - (*z)[4 * i + 2];
  }
  return forces * (size / per_n);
}

}  // namespace blockweir::solid
