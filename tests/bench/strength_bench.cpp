// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic nlohmann_json::nlohmann_json bridge_scene_read
// Do the blocks stand with their strength divided by this, under that level? One row a level, "#" stands, "." fails:
//     strength_bench tests/bench/jointed_rock.toml 1.9 2.25 35 26 26.1
// Each answer is an analysis of its own. Beside the row is the bound of limit analysis: below it forces that hold
// exist.
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/statics/loads.hpp"
#include "solid/capacity/situation.hpp"
#include "solid/capacity/static_strength.hpp"
#include "solid/limit/limit_strength.hpp"

int main(int count, char** arguments) {
  using namespace blockweir;
  constexpr int first_level = 5;
  if (count <= first_level) {
    fmt::print(stderr, "strength_bench SCENE FROM TO STEPS LEVEL...\n");
    return 2;
  }
  const double from = std::atof(arguments[2]);
  const double to = std::atof(arguments[3]);
  const int steps = std::atoi(arguments[4]);
  for (int i = first_level; i < count; ++i) {
    const std::string level = arguments[i];
    const scene::Scene scene = scene::read(arguments[1], {"water.upstream_level_m=" + level}).scene;
    solid::Situation now(scene, hydrostatic::make);
    const auto stated = statics::stated_loads_of(scene, scene.analysis.duration_s);
    const double bound =
        solid::limit::limit_strength(solid::limit::LimitAnalysis(scene), solid::limit::combined(now.dead(), 1, stated))
            .factor;
    fmt::print("{} m, bound {:.4f}: ", level, bound);
    for (int k = 0; k <= steps; ++k) {
      const double reduction = from + (to - from) * k / steps;
      bool stands = false;
      try {
        stands = solid::stands(solid::with_reduced_strength(scene, reduction), now.water_if_any(), now.level_m);
      } catch (const std::runtime_error&) {
        // no equilibrium under its first loads
      }
      fmt::print("{}", stands ? '#' : '.');
      std::fflush(stdout);
    }
    fmt::print("\n");
  }
}
