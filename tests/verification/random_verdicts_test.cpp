// SPDX-License-Identifier: GPL-3.0-or-later
// links: blockweir_independent solid_process fluid_hydrostatic nlohmann_json::nlohmann_json
// Structures drawn at random: level, head, mode and joint of their failure against limit equilibrium and limit analysis
// that share no code with the program (tests/independent). CI takes a few of each; BLOCKWEIR_CAMPAIGN=N takes N,
// BLOCKWEIR_SEED=S takes the one whose seed a failure has named, and BLOCKWEIR_KEEP=FOLDER keeps the scenes that
// failed.
#include <fmt/format.h>

#include <iostream>

#include "tests/independent/limit_analysis.hpp"
#include "tests/independent/random_structures.hpp"
#include "tests/independent/scene_text.hpp"
#include "tests/own_folder.hpp"
#include "tests/run_scene.hpp"

namespace blockweir::test {
namespace {

using namespace blockweir::independent;
namespace fs = std::filesystem;
using Draw = RandomStructure (*)(std::uint64_t);

std::string from_environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::vector<std::uint64_t> seeds(std::size_t count) {
  if (const std::string one = from_environment("BLOCKWEIR_SEED"); !one.empty()) return {std::stoull(one)};
  if (const std::string many = from_environment("BLOCKWEIR_CAMPAIGN"); !many.empty()) count = std::stoul(many);
  std::vector<std::uint64_t> all;
  for (std::uint64_t seed = 1; seed <= count; ++seed) all.push_back(seed);
  return all;
}

/// What the draw of a structure does not decide. Times go with the root of the height, as falling does.
struct Trial {
  RandomStructure one;
  Filling filling;
  double rise_m = 0;  ///< of the reservoir in a window
};

/// From 100 to 2e5 of the stress under the structure, where that is a modulus of concrete or rock.
double random_modulus(Random& random, const RandomStructure& one) {
  const double stress = one.structure.density_kg_per_m3 * gravity * one.height_m;
  return std::clamp(stress * random.between_orders(100, 2e5), 30e6, std::max(50e9, 100 * stress));
}

void choose_method(Random& random, const RandomStructure& one, Filling& filling) {
  filling.youngs_modulus_pa = random_modulus(random, one);
  filling.integrator = random.of(std::vector<std::string>{"shi", "trapezoidal", "generalized-alpha"});
  filling.formulation = random.of(std::vector<std::string>{"augmented-lagrangian", "lagrange-multiplier", "penalty"});
  // A dam that strains under its weight lets its anchor go slack.
  filling.rigid = random.chance(0.5) || !one.structure.bolts.empty() ? "all" : "named";
}

/// Levels from `from` to `to` times that of failure, in so many windows, then held for half as many.
Trial filled(RandomStructure one, double from, double to, double windows) {
  Trial trial{.one = std::move(one)};
  const double at = trial.one.level_m;
  Filling& f = trial.filling;
  f.step_s = 0.01 * std::sqrt(trial.one.height_m / 10);
  f.duration_s = 1.5 * windows * f.step_s;
  f.levels = {{0, from * at}, {windows * f.step_s, to * at}};
  trial.rise_m = (to - from) * at / windows;
  return trial;
}

Trial slowly(RandomStructure one) {
  Random random(one.seed + 1000003);
  Trial trial = filled(std::move(one), 0.94, 1.05, 1500);
  choose_method(random, trial.one, trial.filling);
  return trial;
}

/// 0.01 to 10 m/s for a height of 10 m; windows in which the level rises by a thousandth at most.
Trial fast(RandomStructure one) {
  Random random(one.seed + 2000003);
  Trial trial{.one = std::move(one)};
  const double at = trial.one.level_m;
  const double time = std::sqrt(trial.one.height_m / 10);
  const double rate = random.between_orders(0.01, 10) * trial.one.height_m / 10 / time;
  Filling& f = trial.filling;
  f.step_s = std::min(0.01 * time, 1e-3 * at / rate);
  trial.rise_m = rate * f.step_s;
  const double from = at - std::min(0.4 * at, 1500 * trial.rise_m);
  const double to = at + std::min(0.2 * at, 500 * trial.rise_m);
  f.levels = {{0, from}, {(to - from) / rate, to}};
  f.duration_s = (to - from) / rate + 5 * time;
  choose_method(random, trial.one, trial.filling);
  return trial;
}

Trial held(RandomStructure one, const std::string& kind, double share) {
  Random random(one.seed + 3000003);
  Trial trial = filled(std::move(one), share, share, 200);
  choose_method(random, trial.one, trial.filling);
  trial.filling.kind = kind;
  trial.filling.levels.resize(1);
  return trial;
}

/// A structure that strains is not the one that was drawn: by about weight over stiffness.
double strain(const Trial& trial) {
  const double stress = trial.one.structure.density_kg_per_m3 * gravity * trial.one.height_m;
  return trial.filling.rigid == "all" ? 0 : stress / trial.filling.youngs_modulus_pa;
}

std::string text(const Filling& f) {
  return fmt::format("{}, {}, rigid {}, E {:.3g} Pa: ", f.integrator, f.formulation, f.rigid, f.youngs_modulus_pa);
}

std::string text(const Verdict& v) {
  return fmt::format("{} at {:.6g} m (off by {:.3g} at most), head {:.6g} m, {} on \"{}\" {}", v.outcome, v.level_m,
                     v.uncertainty_m, v.head_m, v.mode, v.joint, v.trouble);
}

/// What is wrong with a failure; empty where nothing is. `off` is what the level may be off, of itself.
std::string wrong(const Trial& trial, const Verdict& v, double off) {
  const RandomStructure& one = trial.one;
  if (v.outcome != "fails") return text(trial.filling) + text(v) + fmt::format(", fails at {:.6g} m", one.level_m);
  const double off_m = off * one.level_m + trial.rise_m;
  std::string all;
  if (!(std::abs(v.level_m - one.level_m) <= off_m)) all += fmt::format("level, {:.6g} m is right; ", one.level_m);
  if (one.by_hand && one.by_hand->next_level_m > 1.02 * one.level_m) {
    if (!(std::abs(v.head_m - one.by_hand->head_m) <= off_m))
      all += fmt::format("head, {:.6g} m; ", one.by_hand->head_m);
    if (v.mode != one.by_hand->mode) all += "mode, " + one.by_hand->mode + "; ";
    if (v.joint != one.by_hand->joint) all += "joint, " + one.by_hand->joint + "; ";
  }
  return all.empty() ? "" : text(trial.filling) + text(v) + ": wrong " + all;
}

class RandomVerdicts : public OwnFolder {
 protected:
  [[nodiscard]] Verdict run(const Structure& structure, const Filling& filling) const {
    return run_scene(scene_text(structure, filling), folder, 120);
  }
  [[nodiscard]] Verdict run(const Trial& trial) const { return run(trial.one.structure, trial.filling); }

  /// `look` says what is wrong with a structure.
  template <class Look>
  void each(const std::vector<Draw>& draws, std::size_t count, Look look) {
    std::size_t wrong_ones = 0;
    std::size_t all = 0;
    for (const Draw draw : draws) {
      for (const std::uint64_t seed : seeds(count)) {
        ++all;
        const RandomStructure one = draw(seed);
        const std::string trouble = look(one);
        if (trouble.empty()) continue;
        ++wrong_ones;
        ADD_FAILURE() << "BLOCKWEIR_SEED=" << seed << " " << one.kind << ", " << fmt::format("{:.3g}", one.height_m)
                      << " m high: " << trouble;
        if (const std::string kept = from_environment("BLOCKWEIR_KEEP"); !kept.empty()) {
          fs::create_directories(kept);
          const char* test = testing::UnitTest::GetInstance()->current_test_info()->name();
          fs::copy_file(folder / "scene.toml", fs::path(kept) / fmt::format("{}-{}-{}.toml", test, one.kind, seed),
                        fs::copy_options::overwrite_existing);
        }
      }
    }
    if (all > count * draws.size()) std::cout << all << " structures, " << wrong_ones << " wrong\n";
  }
};

const std::vector<Draw> that_move_as_one = {monolith, lifts, anchored};
const std::vector<Draw> jointed = {bricks, voronoi};

TEST_F(RandomVerdicts, BothIndependentAnswersAgree) {
  each(that_move_as_one, 100, [](const RandomStructure& one) -> std::string {
    const auto limit = limit_level(one.structure, 0.2 * one.height_m, 1.5 * one.height_m);
    if (!limit) return "no limit analysis";
    const double error = std::abs(limit->level_m / one.level_m - 1);
    return error < 1e-6 ? "" : fmt::format("{} by limit analysis, {} by hand", limit->level_m, one.level_m);
  });
}

TEST_F(RandomVerdicts, WhatMovesAsOneFailsAtTheLevelOfLimitEquilibrium) {
  each(that_move_as_one, 4, [&](const RandomStructure& one) {
    const Trial trial = slowly(one);
    return wrong(trial, run(trial), 1e-3 + strain(trial));
  });
}

TEST_F(RandomVerdicts, JointedDamsFailNearAndNeverAboveTheLevelOfLimitAnalysis) {
  each(jointed, 2, [&](const RandomStructure& one) {
    const Trial trial = slowly(one);
    return wrong(trial, run(trial), 1e-3 + strain(trial));
  });
}

TEST_F(RandomVerdicts, RockSlidesWithItsDamAtTheLevelOfLimitAnalysis) {
  each({on_rock}, 3, [&](const RandomStructure& one) {
    const Trial trial = slowly(one);
    return wrong(trial, run(trial), 1e-3 + strain(trial));
  });
}

TEST_F(RandomVerdicts, FastFillingsSayHowFarTheirLevelMayBeOff) {
  each(that_move_as_one, 3, [&](const RandomStructure& one) {
    const Trial trial = fast(one);
    const Verdict verdict = run(trial);
    const double stated = std::isfinite(verdict.uncertainty_m) ? verdict.uncertainty_m / one.level_m : 0;
    return wrong(trial, verdict, 1e-3 + strain(trial) + stated);
  });
}

TEST_F(RandomVerdicts, JointedDamsThatAreFilledFastSayHowFarTheirLevelMayBeOff) {
  each(jointed, 1, [&](const RandomStructure& one) {
    const Trial trial = fast(one);
    const Verdict verdict = run(trial);
    const double stated = std::isfinite(verdict.uncertainty_m) ? verdict.uncertainty_m / one.level_m : 0;
    return wrong(trial, verdict, 1e-3 + strain(trial) + stated);
  });
}

/// Below and above the level of failure, by 1 % and by what a structure strains.
template <class Run>
std::string wrong_below_or_above(const RandomStructure& one, const std::string& kind, Run run) {
  for (const bool above : {false, true}) {
    Trial trial = held(one, kind, 1);
    const double share = above ? 1.01 + strain(trial) : 0.99 - strain(trial);
    trial = held(one, kind, share);
    const Verdict verdict = run(trial);
    const std::string right = above ? "fails" : "stands";
    if (verdict.outcome != right)
      return fmt::format("at {:.4g} of its level: {}; {} is right", share, text(verdict), right);
  }
  return "";
}

TEST_F(RandomVerdicts, StaticAnalysesStandBelowTheLevelAndFailAbove) {
  each(that_move_as_one, 4, [&](const RandomStructure& one) {
    return wrong_below_or_above(one, "static", [&](const Trial& trial) { return run(trial); });
  });
}

TEST_F(RandomVerdicts, QuasiStaticAnalysesStandBelowTheLevelAndFailAbove) {
  each(that_move_as_one, 2, [&](const RandomStructure& one) {
    return wrong_below_or_above(one, "quasi-static", [&](const Trial& trial) { return run(trial); });
  });
}

TEST_F(RandomVerdicts, DynamicAnalysesStandBelowTheLevelAndFailAbove) {
  each(that_move_as_one, 2, [&](const RandomStructure& one) {
    return wrong_below_or_above(one, "dynamic", [&](const Trial& trial) { return run(trial); });
  });
}

/// Of the same trial, told in two ways; `factor` is that of lengths.
std::string differ(const Trial& trial, const Verdict& one, const Verdict& other, double factor = 1) {
  const double window_s = trial.filling.step_s;
  const bool same = one.outcome == other.outcome && one.mode == other.mode && one.joint == other.joint &&
                    std::abs(one.time_s - other.time_s / std::sqrt(factor)) <= 1.01 * window_s;
  return same ? ""
              : fmt::format("{} after {:.6g} s; then {} after {:.6g} s", text(one), one.time_s, text(other),
                            other.time_s / std::sqrt(factor));
}

TEST_F(RandomVerdicts, TheOrderOfBlocksAndJointsDoesNotMatter) {
  each({lifts, bricks}, 2, [&](const RandomStructure& one) {
    const Trial trial = slowly(one);
    return differ(trial, run(trial), run(reordered(one.structure, one.seed), trial.filling));
  });
}

TEST_F(RandomVerdicts, TheMirrorImageFailsAlike) {
  each({monolith, lifts}, 2, [&](const RandomStructure& one) {
    const Trial trial = slowly(one);
    return differ(trial, run(trial), run(mirrored(one.structure), trial.filling));
  });
}

TEST_F(RandomVerdicts, TheOriginDoesNotMatter) {
  each({monolith, lifts}, 2, [&](const RandomStructure& one) {
    const Trial trial = slowly(one);
    const Vec by(30 * one.height_m, -20 * one.height_m);
    Filling filling = trial.filling;
    for (auto& [time, level] : filling.levels) level += by.y();
    return differ(trial, run(trial), run(shifted(one.structure, by), filling));
  });
}

TEST_F(RandomVerdicts, ALaboratorysModelAndAMountainFailAlike) {
  each({monolith, lifts, bricks}, 1, [&](const RandomStructure& one) {
    const Trial trial = slowly(one);
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
}  // namespace blockweir::test
