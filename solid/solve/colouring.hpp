// SPDX-License-Identifier: GPL-3.0-or-later
// Rows by colour: those of one colour share no unknown, and can be found at once.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {

class Colouring {
 public:
  /// Unknowns that follow each other, of one end of a row.
  struct End {
    int first = 0;
    int count = 0;
  };

  explicit Colouring(std::size_t unknowns) : used_(unknowns) {}

  /// The row gets the first colour that no row with its unknowns has. False where all are taken.
  bool add(int row, const std::array<End, 2>& ends) {
    std::uint64_t taken = 0;
    for (const End& end : ends) {
      for (int i = 0; i < end.count; ++i) taken |= used_[at(end.first + i)];
    }
    const int colour = std::countr_one(taken);
    if (colour == colours) return false;
    if (at(colour) == rows_.size()) rows_.emplace_back();
    rows_[at(colour)].push_back(row);
    for (const End& end : ends) {
      for (int i = 0; i < end.count; ++i) used_[at(end.first + i)] |= std::uint64_t{1} << colour;
    }
    return true;
  }

  /// Rows of each colour, in the order in which they were added.
  [[nodiscard]] std::vector<std::vector<int>>& rows() { return rows_; }

 private:
  static constexpr int colours = 64;
  std::vector<std::uint64_t> used_;  ///< colours of the rows at each unknown
  std::vector<std::vector<int>> rows_;
};

}  // namespace blockweir::solid
