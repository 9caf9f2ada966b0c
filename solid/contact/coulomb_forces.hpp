// SPDX-License-Identifier: GPL-3.0-or-later
// Forces of Coulomb's law at several contacts at once, by pivoting.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace blockweir::solid {

/// n contacts that press and rub, one after the other, each with normal and shear.
struct CoulombContacts {
  Eigen::VectorXd apart;         ///< gap and slip at the end of the step if no force acted, 2 n [m]
  Eigen::MatrixXd flexibility;   ///< how forces change them, 2 n x 2 n [m per N per metre]
  std::vector<double> friction;  ///< tangents, n
};

/// Normal and shear forces, 2 n [N per metre]: gap >= 0, pressure >= 0, one of them zero; shear within friction times
/// pressure, and at that bound, against the slip, if there is slip: the complementarity problem of Stewart and Trinkle
/// (1996, Int. J. Numer. Meth. Engng 39). None if pivoting finds none.
std::optional<Eigen::VectorXd> coulomb_forces(const CoulombContacts& contacts);

}  // namespace blockweir::solid
