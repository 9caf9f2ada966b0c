// SPDX-License-Identifier: GPL-3.0-or-later
// links: blockweir_independent solid_process fluid_hydrostatic nlohmann_json::nlohmann_json
// Structures drawn at random and told in another way: another order, a mirror image, another origin, another size.
#include "tests/verification/random_trials.hpp"

namespace blockweir::test::random_invariance_test {
namespace {

class RandomInvariance : public RandomTrials {};

/// By Shi's scheme: what rings is on the move now and then, and two runs of it part.
Trial damped(const RandomStructure& one) {
  Trial trial = slowly(one, 500);
  trial.filling.integrator = "shi";
  return trial;
}

/// Of the same trial, told in two ways; `factor` is that of lengths. Times within a window, and what both state.
std::string differ(const Trial& trial, const Verdict& one, const Verdict& other, double factor = 1) {
  const double rise_m_per_s = trial.rise_m / trial.filling.step_s;
  const auto stated_m = [](const Verdict& v) { return std::isfinite(v.uncertainty_m) ? v.uncertainty_m : 0; };
  const double apart_s = 1.01 * trial.filling.step_s + (stated_m(one) + stated_m(other) / factor) / rise_m_per_s;
  const double other_s = other.time_s / std::sqrt(factor);
  const bool same = one.outcome == "fails" && other.outcome == "fails" && one.mode == other.mode &&
                    one.joint == other.joint && std::abs(one.time_s - other_s) <= apart_s;
  return same ? ""
              : fmt::format("{}{} after {:.6g} s; then {} after {:.6g} s", text(trial.filling), text(one), one.time_s,
                            text(other), other_s);
}

TEST_F(RandomInvariance, TheOrderOfBlocksAndJointsDoesNotMatter) {
  each({lifts, bricks}, 2, [&](const RandomStructure& one) {
    const Trial trial = damped(one);
    return differ(trial, run(trial), run(reordered(one.structure, one.seed), trial.filling));
  });
}

TEST_F(RandomInvariance, TheMirrorImageFailsAlike) {
  each({monolith, lifts}, 2, [&](const RandomStructure& one) {
    const Trial trial = damped(one);
    return differ(trial, run(trial), run(mirrored(one.structure), trial.filling));
  });
}

TEST_F(RandomInvariance, TheOriginDoesNotMatter) {
  each({monolith, lifts}, 2, [&](const RandomStructure& one) {
    const Trial trial = damped(one);
    const Vec by(30 * one.height_m, -20 * one.height_m);
    Filling filling = trial.filling;
    for (auto& [time, level] : filling.levels) level += by.y();
    return differ(trial, run(trial), run(shifted(one.structure, by), filling));
  });
}

TEST_F(RandomInvariance, ALaboratorysModelAndAMountainFailAlike) {
  each({monolith, lifts, bricks}, 1, [&](const RandomStructure& one) {
    const Trial trial = damped(one);
    const Verdict as_drawn = run(trial);
    for (const double height : {3e-3, 3e3}) {
      const double factor = height / one.height_m;
      Filling filling = trial.filling;
      filling.step_s *= std::sqrt(factor);
      filling.duration_s *= std::sqrt(factor);
      filling.youngs_modulus_pa *= factor;
      for (auto& [time, level] : filling.levels) time *= std::sqrt(factor), level *= factor;
      const std::string trouble = differ(trial, as_drawn, run(scaled(one.structure, factor), filling), factor);
      if (!trouble.empty()) return fmt::format("{} m high instead: {}", height, trouble);
    }
    return std::string();
  });
}

}  // namespace
}  // namespace blockweir::test::random_invariance_test
