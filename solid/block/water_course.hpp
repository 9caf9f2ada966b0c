// SPDX-License-Identifier: GPL-3.0-or-later
// Pressures between exchanges: held, or on the line or parabola through what came last.
#pragma once

#include <array>
#include <vector>

#include "solid/block/panel.hpp"

namespace blockweir::solid {

class WaterCourse {
 public:
  /// Factors of the last exchange, of the one before it, and of the one before that.
  using Weights = std::array<double, 3>;

  /// `degree` 0 holds, 1 goes on linearly, 2 quadratically, as far as there have been exchanges with the same edges:
  /// those that fall dry or are wetted anew have no past. A fluid may divide its edges anew in every exchange.
  explicit WaterCourse(int degree) : degree_(degree) {}

  void add(double time_s, std::vector<Panel> panels);
  [[nodiscard]] Weights weights(double time_s) const;
  /// As they came last.
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
  std::array<std::vector<Panel>, 3> panels_;  ///< the last first
  int known_ = 0;                             ///< that have the same edges
  std::vector<Panel> blend_;
};

}  // namespace blockweir::solid
