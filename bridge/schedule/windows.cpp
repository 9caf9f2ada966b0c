// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/schedule/windows.hpp"

#include <algorithm>
#include <cmath>

namespace blockweir::schedule {
namespace {

/// Round-off in the quotient makes no window more, nor less.
constexpr double round_off = 1e-12;

}  // namespace

Windows::Windows(const scene::Scene& scene)
    : window_s_(scene.coupling.window_s),
      duration_s_(scene.analysis.duration_s),
      at_rest_(scene.analysis.kind == scene::AnalysisKind::at_rest),
      ticks_(static_cast<std::uint64_t>(std::max(1.0, std::ceil(duration_s_ / window_s_ * (1 - round_off))))),
      longest_(static_cast<std::uint64_t>(
          std::max(1.0, std::floor(scene.coupling.longest_window_s / window_s_ * (1 + round_off))))) {}

void Windows::next(const SolidSide& solid) {
  tick_ += at_rest_ ? 1 : length_;
  length_ = longest_ > 1 && solid.calm() ? std::min(2 * length_, longest_) : 1;
}

}  // namespace blockweir::schedule
