// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/static_level.hpp"

#include <algorithm>

#include "bridge/checkpoint/archive.hpp"
#include "solid/watch/capture.hpp"

namespace blockweir::solid {
namespace {

/// What the static analysis calls balanced, over the weight: the level is as exact as that.
constexpr double balanced = 1e-11;

scene::Scene at_rest(scene::Scene scene) {
  scene.analysis.kind = scene::AnalysisKind::at_rest;
  scene.analysis.residual_tolerance = std::min(scene.analysis.residual_tolerance, balanced);
  return scene;
}

/// Blocks under a reservoir that is filled level by level.
class Filling {
 public:
  Filling(const scene::Scene& scene, StillWater& water)
      : scene_(at_rest(scene)),
        far_m_(scene_.analysis.failure_displacement_m),
        range_m_(water.range().full_m - water.range().empty_m),
        solid_(scene_),
        water_(water) {}

  bool begin(double level_m) {
    const wire::Load& load = pressures(level_m);
    if (scene_.analysis.start == scene::Start::equilibrium) solid_.settle(panels_of(load, solid_));
    return rests_at(level_m, range_m_);
  }
  /// Goes on from where the blocks are; pressures follow them until they move no more. What only strains under a small
  /// rise moves by as much less, and what slips need not be followed as far.
  bool rests_at(double level_m, double rise_m) {
    constexpr int most_rounds = 20;
    scene_.analysis.failure_displacement_m = far_m_ * std::clamp(10 * rise_m / range_m_, 1e-5, 1.0);
    for (int round = 0; round < most_rounds; ++round) {
      const double end_s = scene_.analysis.duration_s;
      solid_.advance(end_s, end_s, panels_of(pressures(level_m), solid_));
      if (!solid_.rest().found) return false;
      if (solid_.rest().steps == 1) break;
    }
    return true;
  }
  [[nodiscard]] std::string state() const { return checkpoint::pack(solid_); }
  void restore(const std::string& state) { checkpoint::unpack(state, solid_); }

  /// How the blocks leave a level at which they rest for one at which they do not.
  std::optional<Failure> failure(const std::string& resting, double level_m, double next_m) {
    restore(resting);
    FailureWatch watch(solid_);
    watch.look(0, levels(level_m));
    if (rests_at(next_m, next_m - level_m)) return std::nullopt;
    watch.look(1, levels(next_m));
    if (watch.failures().empty()) return std::nullopt;
    return watch.failures().front();
  }

 private:
  const wire::Load& pressures(double level_m) {
    motion_.displacement.own().resize(solid_.described());
    motion_.velocity.own().resize(solid_.described());
    for (std::size_t b = 0; b < solid_.described(); ++b) {
      Vector6::Map(motion_.displacement.own()[b].data()) = solid_.states()[b].displacement;
    }
    return water_.at(level_m, motion_);
  }
  Levels levels(double level_m) {
    const wire::Load& load = pressures(level_m);
    return {load.upstream_level_m, load.downstream_level_m};
  }

  scene::Scene scene_;  ///< as its analyses are made
  double far_m_;        ///< its own failure displacement
  double range_m_;
  Solid solid_;
  StillWater& water_;
  wire::Motion motion_;
};

}  // namespace

StaticLevel static_level(const scene::Scene& scene, StillWater& water, double width) {
  constexpr int rises = 20;
  const auto [empty_m, full_m] = water.range();
  Filling filling(scene, water);
  if (!filling.begin(empty_m)) return {.outcome = limit::Filled::does_not_stand_empty, .level_m = empty_m};
  double rests_m = empty_m;
  double rise_m = (full_m - empty_m) / rises;
  double fails_m = full_m + rise_m;  // no level yet
  std::string resting = filling.state();
  while (rests_m < full_m && fails_m - rests_m > width * (full_m - empty_m)) {
    const double next_m = fails_m > full_m ? std::min(full_m, rests_m + rise_m) : (rests_m + fails_m) / 2;
    if (next_m <= rests_m || next_m >= fails_m) break;
    if (filling.rests_at(next_m, next_m - rests_m)) {
      rests_m = next_m;
      resting = filling.state();
    } else {
      fails_m = next_m;
      filling.restore(resting);
    }
  }
  if (fails_m > full_m) return {.outcome = limit::Filled::stands_full, .level_m = full_m};
  return {.outcome = limit::Filled::fails,
          .level_m = (rests_m + fails_m) / 2,
          .width_m = fails_m - rests_m,
          .failure = filling.failure(resting, rests_m, fails_m + 1e-4 * (full_m - empty_m))};
}

}  // namespace blockweir::solid
