// SPDX-License-Identifier: GPL-3.0-or-later
// The unknowns of a block in an island's equations: six of its own; three if it is rigid; for a triangle of a mesh, the
// displacements of its three corners, which neighbouring triangles share.
#pragma once

#include <array>
#include <span>
#include <unordered_map>
#include <vector>

#include "bridge/scene/at.hpp"
#include "solid/block/block.hpp"

namespace blockweir::solid {

class Unknowns {
 public:
  /// 6 or 3 for each block. `nodes`: of triangles, numbered at will; -1 for other blocks; empty without triangles.
  explicit Unknowns(const std::vector<int>& count_of, const std::vector<std::array<int, 3>>& nodes_of = {})
      : count(count_of) {
    std::unordered_map<int, int> first_of;  // node: its x displacement
    first.reserve(count.size());
    begin_.reserve(count.size() + 1);
    number_.reserve(6 * count.size());
    for (std::size_t b = 0; b < count.size(); ++b) {
      const bool triangle = !nodes_of.empty() && nodes_of[b][0] >= 0;
      first.push_back(total);
      begin_.push_back(number_.size());
      for (int i = 0; !triangle && i < count[b]; ++i) number_.push_back(total++);
      for (std::size_t i = 0; triangle && i < 3; ++i) {
        const auto [found, is_new] = first_of.emplace(nodes_of[b][i], total);
        if (is_new) {
          nodes.emplace_back(nodes_of[b][i], total);
          total += 2;
        }
        number_.insert(number_.end(), {found->second, found->second + 1});
      }
    }
    begin_.push_back(number_.size());
    if (shared()) map_.assign(count.size(), Matrix6::Identity());
  }

  std::vector<int> count;
  std::vector<int> first;                  ///< first of a block's own unknowns, which are consecutive
  std::vector<std::pair<int, int>> nodes;  ///< with their first unknown, the x displacement; y follows
  int total = 0;

  [[nodiscard]] int blocks() const { return static_cast<int>(count.size()); }
  [[nodiscard]] bool shared() const { return !nodes.empty(); }
  [[nodiscard]] std::span<const int> of(int block) const {
    return {number_.data() + begin_[at(block)], begin_[at(block + 1)] - begin_[at(block)]};
  }

  /// Sets d = map * (displacements of the corners) of a triangle.
  void set_map(int block, const Matrix6& map) { map_[at(block)] = map; }
  /// Converts a matrix between two blocks into one between their unknowns; of rigid ones the first rows or columns.
  [[nodiscard]] Matrix6 mapped(int row, int column, const Matrix6& k) const {
    return shared() ? Matrix6(map_[at(row)].transpose() * k * map_[at(column)]) : k;
  }
  /// Converts the generalized force of a block into forces on its unknowns.
  [[nodiscard]] Vector6 mapped(int block, const Vector6& force) const {
    return shared() ? Vector6(map_[at(block)].transpose() * force) : force;
  }
  /// Adds a block's generalized force to the vector of all unknowns.
  void add(int block, const Vector6& force, Eigen::VectorXd& all) const {
    const Vector6 own = mapped(block, force);
    Eigen::Index i = 0;
    for (const int number : of(block)) all[number] += own[i++];
  }
  /// A block's displacement from the vector of all unknowns; for a rigid block without strains.
  [[nodiscard]] Vector6 take(int block, const Eigen::VectorXd& all) const {
    Vector6 d = take_own(block, all);
    return shared() ? Vector6(map_[at(block)] * d) : d;
  }
  /// A block's own unknowns: for a triangle, the displacements of its corners.
  [[nodiscard]] Vector6 take_own(int block, const Eigen::VectorXd& all) const {
    Vector6 d = Vector6::Zero();
    Eigen::Index i = 0;
    for (const int number : of(block)) d[i++] = all[number];
    return d;
  }

 private:
  std::vector<int> number_;         ///< of all blocks, one after the other
  std::vector<std::size_t> begin_;  ///< of each block's
  std::vector<Matrix6> map_;        ///< for triangles
};

}  // namespace blockweir::solid
