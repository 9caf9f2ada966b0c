// SPDX-License-Identifier: GPL-3.0-or-later
// The times of exchange between solid and fluid.
#pragma once

#include <cstdint>
#include <vector>

#include "bridge/scene/scene.hpp"
#include "bridge/schedule/sides.hpp"

namespace blockweir::schedule {

/// Coupling windows. Each ends at a multiple of [coupling] window_s, the last one at the end of the run. A window has
/// length window_s; while nothing moves it doubles up to longest_window_s. A window of still water whose level peaks in
/// between is divided at the rows of the level table, so that the peak is exchanged. A static analysis has no time: all
/// its windows use the loads and levels of the run's end.
class Windows {
 public:
  explicit Windows(const scene::Scene& scene);

  [[nodiscard]] double from_s() const { return is_static_ ? duration_s_ : part_ > 0 ? cuts_[part_ - 1] : at(tick_); }
  [[nodiscard]] double to_s() const { return is_static_ ? duration_s_ : cut() ? cuts_[part_] : at(tick_ + length_); }
  /// Whether the run ends with this window.
  [[nodiscard]] bool last() const {
    return is_static_ ? tick_ + 1 >= most_static_windows : !cut() && tick_ + length_ >= ticks_;
  }
  /// Moves on to the next window.
  void next(const SolidSide& solid);

  template <class Archive>
  void serialize(Archive& archive) {
    archive(tick_, length_, cuts_, part_);
  }

 private:
  static constexpr std::uint64_t most_static_windows = 1000;
  [[nodiscard]] double at(std::uint64_t tick) const {
    return tick >= ticks_ ? duration_s_ : static_cast<double>(tick) * window_s_;
  }
  /// Whether this window ends at a division.
  [[nodiscard]] bool cut() const { return part_ < cuts_.size(); }
  [[nodiscard]] std::vector<double> cuts_within(double from_s, double to_s) const;

  std::vector<scene::TimeTable> levels_;  ///< of still water
  double window_s_;
  double duration_s_;
  bool is_static_;
  std::uint64_t ticks_;    ///< windows of length window_s in the run
  std::uint64_t longest_;  ///< longest window, in the same unit
  std::uint64_t tick_ = 0;
  std::uint64_t length_ = 1;
  std::vector<double> cuts_;  ///< further window ends between tick_ and tick_ + length_
  std::size_t part_ = 0;      ///< index of the present part of a divided window
};

}  // namespace blockweir::schedule
