// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_openfoam bridge_scene_read
// Stokes's wave against its own relations; inflow and waves that OpenFOAM's mesh cannot do.
#include "fluid/openfoam/inflow_limits.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::openfoam_inflow_test {
namespace {

using openfoam::StokesWave;
using scene::sample::expect_error;
using scene::sample::with;
using testing::HasSubstr;

TEST(StokesWave, MeetsTheDispersionRelationInAllDepths) {
  for (const double depth : {0.01, 0.5, 5.0, 80.0, 4000.0}) {
    const StokesWave wave{1e-3, 4, depth};
    const double k = wave.wave_number();
    EXPECT_NEAR(9.81 * k * std::tanh(k * depth) / std::pow(2 * M_PI / 4, 2), 1, 1e-12) << depth;
  }
}

TEST(StokesWave, IsALongOneInShallowWaterAndADeepOneInDeepWater) {
  EXPECT_NEAR((StokesWave{1e-3, 100, 1}.length_m() / (100 * std::sqrt(9.81))), 1, 1e-3);
  EXPECT_NEAR((StokesWave{1e-3, 2, 50}.length_m() / (9.81 * 4 / (2 * M_PI))), 1, 1e-9);
}

TEST(StokesWave, CarriesTheWaterThatItsSurfaceNeeds) {
  // What flows through a place less what flows through another is what the surface rises by in between: over the depth,
  // c times the elevation, to first order.
  const StokesWave wave{0.02, 4, 5};
  double flow = 0;
  constexpr int layers = 1000;
  for (int i = 0; i < layers; ++i) flow += wave.velocity(0, (i + 0.5) * 5 / layers) * 5 / layers;
  EXPECT_NEAR(flow / (wave.length_m() / wave.period_s * wave.elevation(0)), 1, 2e-3);
  EXPECT_NEAR(wave.elevation(0) - wave.elevation(M_PI), wave.height_m, 1e-12);
}

/// The sample with inflow, whose ground is 10 m wide and whose block is 4 m high.
std::string inflow(const std::string& water, const std::string& fluid) {
  return with("model = \"hydrostatic\"", "model = \"openfoam\"\n" + fluid,
              with("upstream_level_m = { table = [[0, 1], [2, 3]] }", water));
}

std::string refusal(const std::string& water, const std::string& fluid) {
  const auto scene = scene::read_text(inflow(water, fluid), "s.toml").scene;
  try {
    openfoam::check_inflow(scene, openfoam::make_grid(scene));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

constexpr const char* level = "upstream_level_m = 3";

TEST(OpenFoamInflow, PoolsThatHaveWaterAndWavesOfSmallHeightAreTaken) {
  EXPECT_EQ(refusal(level, "level_control = \"inflow\""), "");
  EXPECT_EQ(refusal(level, "wave = { kind = \"regular\", height_m = 0.2, period_s = 3 }"), "");
}

TEST(OpenFoamInflow, APoolWithoutWaterIsRefused) {
  EXPECT_THAT(refusal("upstream_level_m = { table = [[0, 0.01], [2, 3]] }", "level_control = \"inflow\""),
              HasSubstr("raises water that is there, and upstream_level_m is 0.01 m at time 0, over ground at 0 m"));
  EXPECT_THAT(refusal("upstream_level_m = 3\ndownstream_level_m = { table = [[0, 0.1], [2, 3]] }",
                      "level_control = \"inflow\""),
              HasSubstr("and downstream_level_m is 0.1 m at time 0"));
}

TEST(OpenFoamInflow, WavesBeyondStokesSecondOrderAreRefused) {
  EXPECT_THAT(refusal(level, "wave = { kind = \"regular\", height_m = 2.6, period_s = 6 }"),
              HasSubstr("a regular wave of 2.6 m breaks: in 3 m of water, 6 s and"));
  EXPECT_THAT(refusal(level, "wave = { kind = \"regular\", height_m = 0.5, period_s = 12 }"),
              HasSubstr("has an Ursell number of 76.3; Stokes's second order holds up to 26"));
}

TEST(OpenFoamInflow, ALevelControlThatDoesNotSuitTheWaterIsRefused) {
  const std::string regular = "wave = { kind = \"regular\", height_m = 0.2, period_s = 3 }\n";
  expect_error(inflow(level, regular + "level_control = \"free\""), 49, {"regular waves with a closed end"});
  expect_error(inflow(level, regular + "level_control = \"table\""), 49,
               {"a wave in water whose level is set in every window"});
  expect_error(inflow("", "initial_water_m = [[[-2, 0], [-1, 0], [-1, 1]]]\nlevel_control = \"inflow\""), 49,
               {"inflow without a level to follow"});
  expect_error(inflow("", regular + "initial_water_m = [[[-2, 0], [-1, 0], [-1, 1]]]"), 47,
               {"a wave, but no upstream level"});
}

}  // namespace
}  // namespace blockweir::openfoam_inflow_test
