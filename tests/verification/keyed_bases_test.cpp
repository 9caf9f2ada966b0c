// SPDX-License-Identifier: GPL-3.0-or-later
// links: blockweir_independent solid_answers fluid_hydrostatic bridge_scene_read nlohmann_json::nlohmann_json
// Dams with a key at the heel, drawn at random: friction at toe and key is not determined by equilibrium, so the level
// of failure depends on how the joints' forces came about. The level that is told is one that holds without history.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"
#include "fluid/hydrostatic/hydrostatic_model.hpp"
#include "solid/capacity/static_blocks.hpp"
#include "tests/independent/random_structures.hpp"
#include "tests/verification/campaign.hpp"

namespace blockweir::test::keyed_bases_test {
namespace {

using nlohmann::json;

struct KeyedBase {
  double base_m;
  double crest_m;
  double key_deep_m;
  double key_wide_m;
  double friction_deg;
};

std::string scene_text(const KeyedBase& k) {
  return fmt::format(R"(analysis = {{ kind = "static", duration_s = 1 }}
joint = {{ friction_angle_deg = {4} }}
water = {{ upstream_level_m = 5 }}
material.c = {{ youngs_modulus_pa = 30e9, poissons_ratio = 0.2, density_kg_per_m3 = 2100 }}
[[block]]
name = "rock"
material = "c"
fixed = true
vertices_m = [[-40, -40], [{0}, -40], [{0}, 0], [{3}, 0], [{3}, -{2}], [-40, -{2}]]
[[block]]
name = "dam"
material = "c"
vertices_m = [[0, -{2}], [{3}, -{2}], [{3}, 0], [{0}, 0], [{1}, 10], [0, 10]]
)",
                     k.base_m, k.crest_m, k.key_deep_m, k.key_wide_m, k.friction_deg);
}

KeyedBase random_base(std::uint64_t seed) {
  independent::Random random(seed, "keyed base");
  const double base_m = random.between(2.3, 3.5);
  return {.base_m = base_m,
          .crest_m = random.between(0.3, 0.9) * base_m,
          .key_deep_m = random.between(0.5, 1.5),
          .key_wide_m = random.between(0.15, 0.5) * base_m,
          .friction_deg = random.between(10, 35)};
}

double level_or_crest(const json& found) {
  return found["level_m"].is_number() ? found["level_m"].get<double>() : 10;
}

bool stands_without_history(const scene::Scene& scene, double level_m) {
  solid::StillWater water(scene, hydrostatic::make);
  solid::SearchBudget effort("keyed base");
  try {
    return solid::StaticBlocks(scene, &water, effort).begin(level_m);
  } catch (const solid::SolveError&) {
    return false;
  }
}

TEST(KeyedBases, NoStaticAnalysisFailsBelowTheLevel) {
  int told = 0;
  for (int seed = 1; seed <= campaign(12); ++seed) {
    const std::string text = scene_text(random_base(static_cast<std::uint64_t>(seed)));
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, text));
    const scene::Scene scene = scene::read_text(text, "keyed base").scene;
    const json found = process::level_answer(scene, hydrostatic::make);
    constexpr double below = 0.985;
    EXPECT_TRUE(stands_without_history(scene, below * level_or_crest(found))) << found.dump(1);
    if (found.contains("slow_rise")) {
      ++told;
      EXPECT_LT(found["level_m"].get<double>(), level_or_crest(found["slow_rise"]));
      EXPECT_NE(found["difference"]["reason"].get<std::string>().find("all loads at once fail at"), std::string::npos);
    }
  }
  EXPECT_GT(told, 0);
}

/// By a stranger's hand: 7.544 m with full slip at toe and key, and an island of failure at 8.15 m below others.
TEST(KeyedBases, TheReasonNamesTheLevelsThatDiffer) {
  const KeyedBase stranger = {.base_m = 2.32379495410855,
                              .crest_m = 1.4727336357996,
                              .key_deep_m = 1.18392723712176,
                              .key_wide_m = 0.57188249357763,
                              .friction_deg = 33.5468065092081};
  const scene::Scene scene = scene::read_text(scene_text(stranger), "keyed base").scene;
  const json found = process::level_answer(scene, hydrostatic::make);
  EXPECT_LT(found["level_m"].get<double>(), 8.65);
  EXPECT_NEAR(found["slow_rise"]["level_m"].get<double>(), 9.592, 1e-3);
  const auto reason = found["difference"]["reason"].get<std::string>();
  for (const std::string& level :
       {fmt::format("{:.6g} m", found["level_m"].get<double>()), std::string("9.59193 m"), std::string("7.78528 m")}) {
    EXPECT_NE(reason.find(level), std::string::npos) << level << " in: " << reason;
  }
}

}  // namespace
}  // namespace blockweir::test::keyed_bases_test
