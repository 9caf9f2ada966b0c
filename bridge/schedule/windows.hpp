// SPDX-License-Identifier: GPL-3.0-or-later
// When solid and fluid exchange.
#pragma once

#include <cstdint>
#include <vector>

#include "bridge/scene/scene.hpp"
#include "bridge/schedule/sides.hpp"

namespace blockweir::schedule {

/// Coupling windows: each ends at a whole multiple of [coupling] window_s, the last one at the run's duration. They are
/// one multiple long, or grow, doubling while nothing moves, up to longest_window_s. Still water whose level peaks
/// within a window cuts it at the rows of the level, so that the peak is exchanged. In a static analysis, which has no
/// time, all windows are at the run's end, whose loads and levels it has.
class Windows {
 public:
  explicit Windows(const scene::Scene& scene);

  [[nodiscard]] double from_s() const { return at_rest_ ? duration_s_ : part_ > 0 ? cuts_[part_ - 1] : at(tick_); }
  [[nodiscard]] double to_s() const { return at_rest_ ? duration_s_ : cut() ? cuts_[part_] : at(tick_ + length_); }
  /// The run ends with this window.
  [[nodiscard]] bool last() const { return at_rest_ ? tick_ + 1 >= most_sweeps : !cut() && tick_ + length_ >= ticks_; }
  /// Goes on to the next one.
  void next(const SolidSide& solid);

  template <class Archive>
  void serialize(Archive& archive) {
    archive(tick_, length_, cuts_, part_);
  }

 private:
  static constexpr std::uint64_t most_sweeps = 1000;
  [[nodiscard]] double at(std::uint64_t tick) const {
    return tick >= ticks_ ? duration_s_ : static_cast<double>(tick) * window_s_;
  }
  /// A cut ends this window.
  [[nodiscard]] bool cut() const { return part_ < cuts_.size(); }
  [[nodiscard]] std::vector<double> cuts_within(double from_s, double to_s) const;

  std::vector<scene::TimeTable> levels_;  ///< of still water
  double window_s_;
  double duration_s_;
  bool at_rest_;
  std::uint64_t ticks_;    ///< in the run
  std::uint64_t longest_;  ///< in a window
  std::uint64_t tick_ = 0;
  std::uint64_t length_ = 1;
  std::vector<double> cuts_;  ///< times between tick_ and tick_ + length_ at which windows end, too
  std::size_t part_ = 0;      ///< of those that the cuts make
};

}  // namespace blockweir::schedule
