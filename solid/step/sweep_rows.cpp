// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/sweep_rows.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "bridge/scene/at.hpp"
#include "solid/block/parallel.hpp"

namespace blockweir::solid {

bool SweepRows::begin(IslandEquations& s) {
  const bool as_one = s.moves_as_one();
  const bool stands = !by_unit_force_.empty() && !s.unknowns->shared();  // what turns in a step is the matrix of a mesh
  if (as_one && stands) {
    s.correction = s.system().solve_again(s.residual);
  } else if (as_one) {
    s.set_block_matrices();
    if (!s.solve(/*symmetric=*/true)) return false;
    by_unit_force_.assign(at(s.unknowns->total), {});
  } else {
    s.compliance.resize(s.island.blocks.size());
    for_each(s.island.blocks.size(), [&](std::size_t k) {
      const Matrix6& matrix = trial_.matrix[at(s.island.blocks[k])];
      const auto first = s.unknowns->first[k];
      if (s.unknowns->count[k] == 3) {
        auto inverse = s.compliance[k].topLeftCorner<3, 3>();
        inverse = matrix.topLeftCorner<3, 3>().inverse();
        s.correction.segment<3>(first) = inverse * s.residual.segment<3>(first);
      } else {
        s.compliance[k] = matrix.llt().solve(Matrix6::Identity());
        s.correction.segment<6>(first) = s.compliance[k] * s.residual.segment<6>(first);
      }
    });
  }
  s.sweeps.begin(s.correction, s.island.contacts.size() + s.island.supports.size() + s.bolts.size(),
                 !s.unknowns->shared());
  return true;
}

void SweepRows::add(IslandEquations& s, const Ruled& ruled, const Interaction& action, const Eigen::Vector2d& force) {
  add(s, action.block_i, action.block_j);
  set(s, s.sweeps.rows().back(), ruled, action, force);
}

void SweepRows::add(IslandEquations& s, int block_i, int block_j) {
  s.sweeps.add_row();
  if (s.moves_as_one()) return;  // how much moves shows when it does
  for (const bool second : {false, true}) {
    const int block = second ? block_j : block_i;
    if (!trial_.moves(block)) continue;
    const auto k = at(s.local(block));
    s.sweeps.add_room(second, s.unknowns->first[k], s.unknowns->count[k]);
  }
}

void SweepRows::set(IslandEquations& s, ForceSweeps::Row& row, const Ruled& ruled, const Interaction& action,
                    const Eigen::Vector2d& force) {
  row.apart = ruled.apart;
  row.rule = ruled.rule;
  row.force = force;
  const bool as_one = s.moves_as_one();
  for (const bool second : {false, true}) {
    const int block = action.block(second);
    if (!trial_.moves(block)) continue;
    const Placement& placement = trial_.placement[at(block)];
    const double side = second ? -1 : 1;
    const auto k = at(s.local(block));
    if (as_one) {
      add_end_of_all(s, second, static_cast<int>(k), side * action.shape(placement, second));
    } else if (s.unknowns->count[k] == 3) {
      const Eigen::Matrix<double, 2, 3> motions = side * action.rigid_shape(placement, second);
      const Eigen::Matrix<double, 3, 2> responses = s.compliance[k].topLeftCorner<3, 3>() * motions.transpose();
      s.sweeps.set_end(row, second, motions, responses);
    } else {
      const Matrix26 motions = side * action.shape(placement, second);
      const Eigen::Matrix<double, 6, 2> responses = s.compliance[k] * motions.transpose();
      s.sweeps.set_end(row, second, motions, responses);
    }
  }
}

/// Unknowns of all the blocks that move with this one.
void SweepRows::add_end_of_all(IslandEquations& s, bool second, int k, const Matrix26& shape) {
  Eigen::Matrix2Xd motions = Eigen::Matrix2Xd::Zero(2, s.unknowns->total);
  Eigen::MatrixX2d responses = Eigen::MatrixX2d::Zero(s.unknowns->total, 2);
  Matrix26 own;  // by the block's own unknowns
  for (const Eigen::Index axis : {0, 1}) own.row(axis) = s.unknowns->mapped(k, shape.row(axis).transpose()).transpose();
  Eigen::Index i = 0;
  for (const int unknown : s.unknowns->of(k)) {
    const Eigen::Vector2d by_unknown = own.col(i++);
    if (by_unknown.isZero(0)) continue;
    motions.col(unknown) = by_unknown;
    responses.noalias() += by_unit_force(s, unknown) * by_unknown.transpose();
  }
  Eigen::Index first = 0;
  Eigen::Index last = s.unknowns->total - 1;
  while (first < last && responses.row(first).isZero(0)) ++first;
  while (last > first && responses.row(last).isZero(0)) --last;
  const Eigen::Index count = last - first + 1;
  s.sweeps.add_end(second, first, motions.middleCols(first, count), responses.middleRows(first, count));
}

/// Displacements of all that moves as one by a unit force on one unknown: many contacts pull at the same.
const Eigen::VectorXd& SweepRows::by_unit_force(IslandEquations& s, int unknown) {
  Eigen::VectorXd& moved = by_unit_force_[at(unknown)];
  if (moved.size() == 0) moved = s.system().solve_again(Eigen::VectorXd::Unit(s.unknowns->total, unknown));
  return moved;
}

}  // namespace blockweir::solid
