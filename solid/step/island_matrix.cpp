// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/island_matrix.hpp"

#include <array>

#include "bridge/scene/at.hpp"
#include "solid/step/island_equations.hpp"

namespace blockweir::solid {

template <class System>
void IslandMatrix::add_own(System& to) const {
  for (const int b : s_.island.blocks) to.add(s_.local(b), s_.local(b), trial_.matrix[at(b)]);
  for (const int k : s_.couplings) {
    const StrainCoupling& c = model_.parts.couplings[at(k)];
    Matrix6 shared = Matrix6::Zero();
    shared.bottomRightCorner<3, 3>() =
        (1 + trial_.scheme.velocity_factor(trial_.dt) * trial_.retardation_s(at(c.i))) * c.stiffness;
    to.add(s_.local(c.i), s_.local(c.j), shared);
    to.add(s_.local(c.j), s_.local(c.i), shared);
  }
}

template <class System>
void IslandMatrix::add_columns(System& to, const Interaction& action, bool of_second) const {
  const int column = action.block(of_second);
  if (!trial_.moves(column) || action.stiffness.isZero(0)) return;
  const Matrix26 shape = action.shape(trial_.placement[at(column)], of_second);
  const Matrix26 force = action.stiffness * shape;
  to.add(s_.local(column), s_.local(column), shape.transpose() * force);
  const int row = action.block(!of_second);
  if (!trial_.moves(row)) return;
  to.add(s_.local(row), s_.local(column), -action.shape(trial_.placement[at(row)], !of_second).transpose() * force);
}

bool IslandMatrix::is_between_rigid(const Interaction& action) const {
  const auto is_rigid = [this](int b) { return !trial_.moves(b) || model_.blocks[at(b)].rigid; };
  return !s_.unknowns->shared() && is_rigid(action.block_i) && is_rigid(action.block_j);
}

/// The same with three unknowns a block: to the same bits, in less than half of the time.
template <class System>
void IslandMatrix::add_rigid_stiffness(System& to, const Interaction& action) const {
  if (action.stiffness.isZero(0)) return;
  std::array<Eigen::Matrix<double, 2, 3>, 2> shape;
  for (const bool second : {false, true}) {
    const int b = action.block(second);
    if (trial_.moves(b)) shape[second ? 1 : 0] = action.rigid_shape(trial_.placement[at(b)], second);
  }
  Matrix6 k;  // its first three rows and columns are added
  for (const bool of_second : {false, true}) {
    const int column = action.block(of_second);
    if (!trial_.moves(column)) continue;
    const Eigen::Matrix<double, 2, 3>& own = shape[of_second ? 1 : 0];
    const Eigen::Matrix<double, 2, 3> force = action.stiffness * own;
    k.topLeftCorner<3, 3>().noalias() = own.transpose() * force;
    to.add(s_.local(column), s_.local(column), k);
    const int row = action.block(!of_second);
    if (!trial_.moves(row)) continue;
    k.topLeftCorner<3, 3>().noalias() = -shape[of_second ? 0 : 1].transpose() * force;
    to.add(s_.local(row), s_.local(column), k);
  }
}

template void IslandMatrix::add_own(LinearSystem&) const;
template void IslandMatrix::add_own(SaddlePoint&) const;
template void IslandMatrix::add_columns(LinearSystem&, const Interaction&, bool) const;
template void IslandMatrix::add_columns(SaddlePoint&, const Interaction&, bool) const;
template void IslandMatrix::add_rigid_stiffness(LinearSystem&, const Interaction&) const;
template void IslandMatrix::add_rigid_stiffness(SaddlePoint&, const Interaction&) const;

}  // namespace blockweir::solid
