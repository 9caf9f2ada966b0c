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
      is_static_(scene.analysis.kind == scene::AnalysisKind::at_rest),
      ticks_(static_cast<std::uint64_t>(std::max(1.0, std::ceil(duration_s_ / window_s_ * (1 - round_off))))),
      longest_(static_cast<std::uint64_t>(
          std::max(1.0, std::floor(scene.coupling.longest_window_s / window_s_ * (1 + round_off))))) {
  if (scene::still_pools(scene.fluid) && !is_static_) {
    for (const auto* level : {&scene.water.upstream_level_m, &scene.water.downstream_level_m}) {
      if (*level) levels_.push_back(**level);
    }
  }
  cuts_ = cuts_within(from_s(), to_s());
}

std::vector<double> Windows::cuts_within(double from_s, double to_s) const {
  constexpr double shortest = 1e-6;  // of window_s: rows of two levels at the same time are one cut
  std::vector<double> cuts;
  for (const scene::TimeTable& level : levels_) {
    const std::vector<double> rows = level.hidden_between(from_s, to_s);
    cuts.insert(cuts.end(), rows.begin(), rows.end());
  }
  std::sort(cuts.begin(), cuts.end());
  const auto near = [&](double a, double b) { return b - a <= shortest * window_s_; };
  cuts.erase(std::unique(cuts.begin(), cuts.end(), near), cuts.end());
  return cuts;
}

void Windows::next(const SolidSide& solid) {
  if (cut()) {
    ++part_;
    return;
  }
  tick_ += is_static_ ? 1 : length_;
  length_ = longest_ > 1 && solid.at_rest() ? std::min(2 * length_, longest_) : 1;
  cuts_.clear();
  part_ = 0;
  cuts_ = cuts_within(from_s(), to_s());
}

}  // namespace blockweir::schedule
