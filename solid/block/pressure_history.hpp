// SPDX-License-Identifier: GPL-3.0-or-later
// Pressures between exchanges: constant, or linearly or quadratically extrapolated from the last exchanges.
#pragma once

#include <array>
#include <vector>

#include "solid/block/panel.hpp"

namespace blockweir::solid {

class PressureHistory {
 public:
  /// Factors of the last exchange and of the two before it.
  using Weights = std::array<double, 3>;

  /// `degree` 0: constant, 1: linear, 2: quadratic, limited by the number of exchanges with the same edges; edges that
  /// become dry or wet start without a past. The fluid may divide its edges differently in every exchange.
  explicit PressureHistory(int degree) : degree_(degree) {}

  void add(double time_s, std::vector<Panel> panels);
  [[nodiscard]] Weights weights(double time_s) const;
  /// The panels of the last exchange.
  [[nodiscard]] const std::vector<Panel>& last() const { return panels_[0]; }
  /// Valid until the next call.
  const std::vector<Panel>& at(double time_s);

  template <class Archive>
  void serialize(Archive& archive) {
    archive(time_s_, panels_, known_);
  }

 private:
  int degree_;
  std::array<double, 3> time_s_{};
  std::array<std::vector<Panel>, 3> panels_;  ///< the last exchange first
  int known_ = 0;                             ///< number of exchanges with the same edges
  std::vector<Panel> blend_;
};

}  // namespace blockweir::solid
