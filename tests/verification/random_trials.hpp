// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of structures drawn at random (tests/independent), and what is wrong with what they say. CI takes a few;
// BLOCKWEIR_CAMPAIGN=N takes N of each kind, BLOCKWEIR_SEED=S the one whose seed a failure has named, and
// BLOCKWEIR_KEEP=FOLDER keeps the scenes that failed.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "tests/independent/random_structures.hpp"
#include "tests/independent/scene_text.hpp"
#include "tests/own_folder.hpp"
#include "tests/run_scene.hpp"

namespace blockweir::test {

using namespace blockweir::independent;
using Draw = RandomStructure (*)(std::uint64_t);

inline std::string from_environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

inline std::vector<std::uint64_t> seeds(std::size_t count) {
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

/// Of the weight [Pa].
inline double stress_under(const RandomStructure& one) {
  return one.structure.density_kg_per_m3 * gravity * one.height_m;
}

/// From 100 to 2e5 of the stress under the structure, where that is a modulus of concrete or rock.
inline double random_modulus(independent::Random& random, const RandomStructure& one) {
  const double stress = stress_under(one);
  return std::clamp(stress * random.between_orders(100, 2e5), 30e6, std::max(50e9, 100 * stress));
}

inline void choose_method(independent::Random& random, const RandomStructure& one, Filling& filling) {
  filling.youngs_modulus_pa = random_modulus(random, one);
  filling.integrator = random.of(std::vector<std::string>{"shi", "trapezoidal", "generalized-alpha"});
  filling.formulation = random.of(std::vector<std::string>{"augmented-lagrangian", "lagrange-multiplier", "penalty"});
  // A dam that strains under its weight, or sinks into soft springs, lets its anchor go slack.
  const bool anchored = !one.structure.bolts.empty();
  filling.rigid = random.chance(0.5) || anchored ? "all" : "named";
  if (anchored && filling.formulation == "penalty") {
    filling.youngs_modulus_pa = std::max(filling.youngs_modulus_pa, 2e4 * stress_under(one));
  }
}

/// Levels from `from` to `to` times that of failure, in so many windows, then held for half as many.
inline Trial filled(RandomStructure one, double from, double to, double windows) {
  Trial trial{.one = std::move(one)};
  const double at = trial.one.level_m;
  Filling& f = trial.filling;
  f.step_s = 0.01 * std::sqrt(trial.one.height_m / 10);
  f.duration_s = 1.5 * windows * f.step_s;
  f.levels = {{0, from * at}, {windows * f.step_s, to * at}};
  trial.rise_m = (to - from) * at / windows;
  return trial;
}

/// From below the level to above it, by 8e-5 of it in a window.
inline Trial slowly(RandomStructure one, double windows = 1500) {
  independent::Random random(one.seed, one.kind + "slow");
  Trial trial = filled(std::move(one), 1 - 4e-5 * windows, 1 + 4e-5 * windows, windows);
  choose_method(random, trial.one, trial.filling);
  return trial;
}

/// 0.01 to 10 m/s for a height of 10 m; windows in which the level rises by a thousandth at most.
inline Trial fast(RandomStructure one) {
  independent::Random random(one.seed, one.kind + "fast");
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

inline Trial held(RandomStructure one, const std::string& kind, double share) {
  independent::Random random(one.seed, one.kind + "held");
  Trial trial = filled(std::move(one), share, share, 200);
  choose_method(random, trial.one, trial.filling);
  trial.filling.kind = kind;
  trial.filling.levels.resize(1);
  return trial;
}

/// A structure that strains is not the one that was drawn: by about weight over stiffness.
inline double strain(const Trial& trial) {
  return trial.filling.rigid == "all" ? 0 : stress_under(trial.one) / trial.filling.youngs_modulus_pa;
}

inline std::string text(const Filling& f) {
  return fmt::format("{}, {}, rigid {}, E {:.3g} Pa: ", f.integrator, f.formulation, f.rigid, f.youngs_modulus_pa);
}

inline std::string text(const Verdict& v) {
  return fmt::format("{} at {:.6g} m (off by {:.3g} at most), head {:.6g} m, {} on \"{}\" {}", v.outcome, v.level_m,
                     v.uncertainty_m, v.head_m, v.mode, v.joint, v.trouble);
}

/// How far a failure may be off.
struct Allowed {
  double level =
      1e-3;          ///< of the level, beside the rise in a window, what the structure strains, and what the run states
  double early = 0;  ///< more than that where it fails before its time
  double stated = 0.05;      ///< of the level, the most that a run may state
  double modes_apart = 1.1;  ///< next level over the first from which there is no doubt about mode and joint
};

/// Of a structure that fails on one joint, no other way being near.
inline std::string wrong_mode(const RandomStructure& one, const Verdict& v, double modes_apart) {
  if (!one.by_hand || one.by_hand->next_level_m <= modes_apart * one.level_m) return "";
  // What a broken bond held back as well may begin at once.
  const bool both = one.by_hand->broken_level_m <= modes_apart * one.level_m;
  const bool either = v.mode == "sliding" || v.mode == "overturning" || v.mode == "sliding and overturning";
  return v.mode == one.by_hand->mode || (both && either) ? "" : "mode, " + one.by_hand->mode + "; ";
}

/// What is wrong with a failure; empty where nothing is.
inline std::string wrong(const Trial& trial, const Verdict& v, const Allowed& allowed = {}) {
  const RandomStructure& one = trial.one;
  if (v.outcome != "fails") return text(trial.filling) + text(v) + fmt::format(", fails at {:.6g} m", one.level_m);
  const double stated_m = std::isfinite(v.uncertainty_m) ? v.uncertainty_m : 0;
  const double off_m = (allowed.level + strain(trial)) * one.level_m + trial.rise_m + stated_m;
  std::string all;
  if (stated_m > allowed.stated * one.level_m) all += "uncertainty, so large that it says nothing; ";
  const double late_m = v.level_m - one.level_m;
  if (!(late_m <= off_m && -late_m <= off_m + allowed.early * one.level_m)) {
    all += fmt::format("level, {:.6g} m is right; ", one.level_m);
  }
  if (one.by_hand && one.by_hand->next_level_m > allowed.modes_apart * one.level_m) {
    const double level_over_joint_m = one.by_hand->level_m - one.by_hand->head_m;
    if (!(std::abs(v.level_m - v.head_m - level_over_joint_m) <= (1e-6 + strain(trial)) * one.height_m)) {
      all += fmt::format("head, {:.6g} m; ", one.by_hand->head_m);
    }
    all += wrong_mode(one, v, allowed.modes_apart);
    if (v.joint != one.by_hand->joint) all += "joint, " + one.by_hand->joint + "; ";
  }
  return all.empty() ? "" : text(trial.filling) + text(v) + ": wrong " + all;
}

class RandomTrials : public OwnFolder {
 protected:
  [[nodiscard]] Verdict run(const Structure& structure, const Filling& filling) const {
    return run_scene(scene_text(structure, filling), folder, 40);
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
          std::filesystem::create_directories(kept);
          const char* test = testing::UnitTest::GetInstance()->current_test_info()->name();
          std::filesystem::copy_file(folder / "scene.toml",
                                     std::filesystem::path(kept) / fmt::format("{}-{}-{}.toml", test, one.kind, seed),
                                     std::filesystem::copy_options::overwrite_existing);
        }
      }
    }
    if (all > count * draws.size()) std::cout << all << " structures, " << wrong_ones << " wrong\n";
  }
};

}  // namespace blockweir::test
