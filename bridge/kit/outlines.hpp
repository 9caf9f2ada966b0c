// SPDX-License-Identifier: GPL-3.0-or-later
// The outlines of the blocks that the handshake delivers. C++17.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "bridge/wire/message.hpp"

namespace blockweir::kit {

class Outlines {
 public:
  Outlines() = default;
  /// Throws std::invalid_argument if the outlines do not match the number of blocks.
  explicit Outlines(const wire::Hello& hello);

  [[nodiscard]] std::size_t size() const { return first_.size(); }
  [[nodiscard]] std::size_t vertices(std::size_t block) const { return count_[block]; }
  /// x0, y0, x1, y1, ... [m]
  [[nodiscard]] const double* outline(std::size_t block) const { return numbers_.data() + first_[block]; }

  /// Writes the outline displaced by `displacement` into `xy` [m].
  void place(std::size_t block, const std::array<double, 6>& displacement, double* xy) const;

 private:
  std::vector<double> numbers_;
  std::vector<std::size_t> first_;
  std::vector<std::size_t> count_;
  std::vector<std::array<double, 2>> centroid_;
};

}  // namespace blockweir::kit
