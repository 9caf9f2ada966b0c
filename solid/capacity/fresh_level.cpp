// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/capacity/fresh_level.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solid/capacity/static_blocks.hpp"

namespace blockweir::solid {
namespace {

class FreshSearch {
 public:
  FreshSearch(const scene::Scene& scene, StillWater& water, SearchBudget& effort, double empty_m)
      : scene_(scene), water_(water), effort_(effort), empty_m_(empty_m) {}

  std::optional<FreshLevel> found(std::vector<double> levels_m) {
    std::sort(levels_m.begin(), levels_m.end());
    const auto fails = std::find_if(levels_m.begin(), levels_m.end(),
                                    [this](double level_m) { return level_m > empty_m_ && !stands(level_m); });
    if (fails == levels_m.end()) return std::nullopt;
    constexpr double step = 2.5e-3;
    constexpr double width = 1e-6;
    const double rise_m = found_.fails_m - empty_m_;
    step_m_ = step * rise_m;
    found_.stands_m = empty_m_;
    try {
      descend();
      narrow(step_m_);
      look_below();
      narrow(width * rise_m);
      warn();
    } catch (const TookTooLong& stopped) {
      found_.stopped = stopped.what();
    }
    return found_;
  }

 private:
  /// Blocks without rest that stay in place have not failed.
  bool stands(double level_m) {
    StaticBlocks blocks(scene_, &water_, effort_);
    FailureWatch watch(blocks.solid());
    watch.look(0, blocks.levels(level_m));
    std::optional<Failure> failure;
    try {
      if (blocks.begin(level_m) || !blocks.went_far()) return true;
      watch.look(1, blocks.levels(level_m));
      if (!watch.failures().empty()) failure = watch.failures().front();
    } catch (const SolveError&) {
      // it has no equilibrium under its first loads
    }
    found_.fails_m = level_m;
    found_.failure = failure;
    return false;
  }

  /// Down in steps that double, to a level that stands.
  void descend() {
    for (double down_m = step_m_; found_.stands_m == empty_m_ && found_.fails_m - down_m > empty_m_; down_m *= 2) {
      const double next_m = found_.fails_m - down_m;
      if (stands(next_m)) found_.stands_m = next_m;
    }
  }

  /// Some levels fail between others that are stable: continues until a sufficient range below is stable.
  void look_below() {
    constexpr double way = 0.06;  // of the rise from the empty reservoir
    const double way_m = way * (found_.fails_m - empty_m_);
    for (double next_m = found_.fails_m - step_m_; next_m > std::max(empty_m_, found_.fails_m - way_m);
         next_m -= step_m_) {
      if (!stands(next_m)) {
        found_.stands_m = empty_m_;
      } else if (found_.stands_m == empty_m_) {
        found_.stands_m = next_m;
      }
    }
  }

  void narrow(double width_m) {
    while (found_.fails_m - found_.stands_m > width_m) {
      effort_.knows(
          fmt::format("with all loads at once rests at {:.9g} m, fails at {:.9g} m", found_.stands_m, found_.fails_m));
      const double middle_m = (found_.stands_m + found_.fails_m) / 2;
      if (stands(middle_m)) found_.stands_m = middle_m;
    }
  }

  void warn() {
    StaticBlocks blocks(scene_, &water_, effort_);
    if (blocks.begin(found_.stands_m)) found_.warnings = blocks.warnings(found_.stands_m);
  }

  const scene::Scene& scene_;
  StillWater& water_;
  SearchBudget& effort_;
  double empty_m_;
  double step_m_ = 0;
  FreshLevel found_;
};

}  // namespace

std::optional<FreshLevel> fresh_level(const scene::Scene& scene, StillWater& water, SearchBudget& effort,
                                      double empty_m, std::vector<double> levels_m) {
  return FreshSearch(scene, water, effort, empty_m).found(std::move(levels_m));
}

}  // namespace blockweir::solid
