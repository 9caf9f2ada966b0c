// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_reservoir bridge_scene_read
// Water that answers accelerations, as the schedules see it.
#include "fluid/reservoir/reservoir_model.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <stdexcept>

#include "tests/unit/reservoir_dam.hpp"

namespace blockweir::reservoir::reservoir_model_test {
namespace {

TEST(ReservoirModel, AnAccelerationAddsItsPressureToStillWater) {
  const scene::Scene scene = dam_of_two();
  ReservoirModel water(scene);
  wire::Load load;
  water.advance(moved(0, 0), 0, load);
  EXPECT_NEAR(thrust(load), still, 1e-9 * still);
  water.advance(moved(1e-5, 2e-3), 0.01, load);  // 0.2 m/s2, away from the water
  EXPECT_NEAR(thrust(load), still - 0.2 * added, 1e-4 * added);
  water.advance(moved(3e-5, 2e-3), 0.02, load);
  EXPECT_NEAR(thrust(load), still, 1e-9 * still);
  EXPECT_LT(load.cracks_from, load.block.size());  // uplift is there as it was
}

TEST(ReservoirModel, RefusesAPoolThatLosesItsSurface) {
  scene::Scene scene = dam_of_two("[fluid]\nmodel = \"reservoir\"\nreservoir = { upstream_wall_m = -50 }\n");
  scene::Block roof = scene.blocks[0];
  roof.name = "roof";
  roof.vertices = {{-50, 18}, {0, 18}, {0, 22}, {-50, 22}};
  scene.blocks.push_back(roof);  // a scene that draws it so is refused as it is read
  ReservoirModel water(scene);
  wire::Motion motion = moved(0, 0);
  motion.displacement.own().resize(4);
  motion.velocity.own().resize(4);
  wire::Load load;
  try {
    water.advance(motion, 0, load);
    ADD_FAILURE() << "it has an answer";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(),
                testing::AllOf(testing::HasSubstr("dam: [fluid.reservoir] has a pool without a surface"),
                               testing::HasSubstr("block \"roof\""), testing::HasSubstr("lower its level")));
  }
}

/// The dam is 22 m high: by its depth a film would be meshed for ever.
TEST(ReservoirModel, AFilmOfWaterIsNotMeshed) {
  for (const auto& [level_m, meshed] : {std::pair{1e-3, false}, {0.1, false}, {0.5, true}}) {
    scene::Scene scene = dam_of_two();
    scene.water.upstream_level_m = scene::TimeTable::constant(level_m);
    ReservoirModel water(scene);
    wire::Load load;
    water.advance(moved(0, 0), 0, load);
    EXPECT_EQ(load.added_mass[1][0] > 0, meshed) << level_m;
  }
}

/// The bed rises to a wall on the model's own end, or just beyond it.
TEST(ReservoirModel, AWallMayStandOnTheModelsEnd) {
  for (const double wall_m : {-50.0, -50.0000001, -50.00001, -50.0001, -50.001}) {
    scene::Scene scene = dam_of_two();
    scene.reservoir.upstream_wall_m = wall_m;
    scene.blocks[0].vertices = {{-50, -10}, {80, -10}, {80, 0}, {0, 0}, {-50, 3.1}};
    ReservoirModel water(scene);
    wire::Load load;
    EXPECT_NO_THROW(water.advance(moved(0, 0), 0, load)) << wall_m;
    EXPECT_GT(thrust(load), 0.9 * still) << wall_m;
  }
}

/// By one solution where the water is met first, by those of all modes where it was kept.
TEST(ReservoirModel, WaterThatIsKeptHasThePressuresOfWaterThatIsMetFirst) {
  for (const std::string compressible : {"false", "true"}) {
    const scene::Scene kept =
        dam_of_two("[fluid]\nmodel = \"reservoir\"\nreservoir = { compressible = " + compressible + " }\n");
    const scene::Scene anew = dam_of_two(
        "[fluid]\nmodel = \"reservoir\"\nreservoir = { move_tolerance = 1e-14, compressible = " + compressible +
        " }\n");
    ReservoirModel one(kept);
    ReservoirModel other(anew);
    wire::Load a;
    wire::Load b;
    for (int i = 0; i < 6; ++i) {
      const double slipped = 1e-12 * i;  // enough to be met first in each window
      one.advance(moved(0, 0.3 * std::sin(i)), 0.01 * i, a);
      other.advance(moved(slipped, 0.3 * std::sin(i)), 0.01 * i, b);
      ASSERT_EQ(a.pressure_from_pa.size(), b.pressure_from_pa.size());
      for (std::size_t k = 0; k < a.pressure_from_pa.size(); ++k) {
        EXPECT_NEAR(a.pressure_from_pa[k], b.pressure_from_pa[k], 1e-12 * still) << i;
      }
    }
    EXPECT_EQ(one.report().counts.at("reservoir solutions"), 1);
    EXPECT_EQ(other.report().counts.at("reservoir solutions"), 6);
  }
}

constexpr const char* with_waves =
    "[fluid]\nmodel = \"reservoir\"\nreservoir = { surface = \"waves\", compressible = true, bottom_reflection = 0.8, "
    "element_ratio = 0.5 }\n";

void goes_on_with_the_same_bits(const std::string& fluid) {
  const scene::Scene scene = dam_of_two(fluid);
  ReservoirModel water(scene);
  wire::Load load;
  double x = 0;
  for (int i = 0; i < 8; ++i) water.advance(moved(x += 0.009, 0.3 * std::sin(i)), 0.01 * i, load);
  ReservoirModel again(scene);
  again.restore(water.state());
  for (int i = 8; i < 16; ++i) {
    wire::Load other;
    x += 0.009;
    water.advance(moved(x, 0.3 * std::sin(i)), 0.01 * i, load);
    again.advance(moved(x, 0.3 * std::sin(i)), 0.01 * i, other);
    EXPECT_EQ(load.pressure_from_pa.values(), other.pressure_from_pa.values());
    EXPECT_EQ(load.added_mass.values(), other.added_mass.values());
    EXPECT_EQ(load.added_mass_between.values(), other.added_mass_between.values());
  }
  EXPECT_EQ(water.report().counts.at("reservoir solutions"), again.report().counts.at("reservoir solutions"));
}

TEST(ReservoirModel, WhatIsRestoredGoesOnWithTheSameBits) {
  goes_on_with_the_same_bits("[fluid]\nmodel = \"reservoir\"\nreservoir = { element_ratio = 0.5 }\n");
  goes_on_with_the_same_bits(with_waves);
}

TEST(ReservoirModel, WaterThatRemembersTellsTheGuardWhatAWindowFeels) {
  const scene::Scene level = dam_of_two();
  const scene::Scene sound = dam_of_two("[fluid]\nmodel = \"reservoir\"\nreservoir = { compressible = true }\n");
  wire::Load a;
  wire::Load b;
  ReservoirModel(level).advance(moved(0, 0), 0, a);
  ReservoirModel(sound).advance(moved(0, 0), 0, b);
  const auto of_both = [](const wire::Load& load) {
    return load.added_mass[1][0] + load.added_mass[2][0] + 2 * load.added_mass_between[0][0];
  };
  EXPECT_NEAR(of_both(a), added, 1e-4 * added);
  // In 0.01 s sound runs 14.4 of 20 m: sum over n of 8/((2n-1) pi)^2 int_0^0.72 J0((2n-1) pi s/2) ds, one step of time.
  EXPECT_NEAR(of_both(b) / (1000 * 20 * 20), 0.5547, 0.03);
}

TEST(ReservoirModel, TheGuardIsToldTheMassOfAllBlocksWithAllOthers) {
  const scene::Scene scene = dam_of_two();
  ReservoirModel water(scene);
  wire::Load load;
  water.advance(moved(0, 0), 0, load);
  ASSERT_EQ(load.added_mass.size(), 3U);
  EXPECT_EQ(load.added_mass[0], (std::array<double, 6>{}));  // the ground is held
  EXPECT_EQ(load.coupled.values(), (std::vector<std::array<std::uint32_t, 2>>{{1, 2}}));
  ASSERT_EQ(load.added_mass_between.size(), 1U);
  // Both blocks together are the wall.
  EXPECT_NEAR(load.added_mass[1][0] + load.added_mass[2][0] + 2 * load.added_mass_between[0][0], added, 1e-4 * added);
}

TEST(ReservoirModel, APseudoStaticEarthquakeTakesItsPressureInPlaceOfWestergaards) {
  const scene::Scene scene = dam_of_two("[fluid]\nmodel = \"reservoir\"\n[earthquake]\nhorizontal_coefficient = 0.1\n");
  ReservoirModel water(scene);
  wire::Load load;
  water.advance(moved(0, 0), 0, load);
  EXPECT_NEAR(thrust(load), still + 0.981 * added, 1e-4 * added);
  water.advance(moved(0, 0), 0.01, load);
  EXPECT_NEAR(thrust(load), still + 0.981 * added, 1e-4 * added);
}

std::string wall_before(const std::string& kind, const std::string& coupling, const std::string& analysis = "") {
  return R"(water = { upstream_level_m = 5 }
material.m = { youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }
analysis = { duration_s = 1)" +
         analysis + R"( }
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-9, -5], [20, -5], [20, 0], [-9, 0]]
[[block]]
name = "wall"
material = "m"
vertices_m = [[0, 0], [8, 0], [8, 10], [0, 10]]
[fluid]
model = "reservoir"
reservoir = { )" +
         kind + " }\n" + coupling;
}

TEST(ReservoirModel, WavesUnderHeldPressuresAreWarnedOf) {
  const auto warned = [](const std::string& coupling, const std::string& surface = "waves") {
    const auto read = scene::read_text(wall_before("surface = \"" + surface + "\"", coupling), "waves");
    return std::any_of(read.warnings.begin(), read.warnings.end(), [](const auto& warning) {
      return warning.text().find("its pressures are held in each window") != std::string::npos;
    });
  };
  EXPECT_TRUE(warned(""));
  EXPECT_FALSE(warned("", "level"));
  EXPECT_FALSE(warned("[coupling]\nschedule = \"improved\"\n"));
  EXPECT_FALSE(warned("[coupling]\nload_in_window = \"linear\"\n"));
}

/// Of 14 random walls on bolts 7 swung ever farther on the parallel schedule, and 7 of 11 with two steps a window.
TEST(ReservoirModel, SoundThatCannotLookAheadIsAnErrorBesideWhatMoves) {
  const auto error = [](const std::string& coupling, const std::string& analysis = "") -> std::string {
    try {
      scene::read_text(wall_before("compressible = true", "[coupling]\n" + coupling, analysis), "sound");
    } catch (const std::exception& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_THAT(error("schedule = \"parallel\"\n"), testing::HasSubstr("expected schedule = \"serial\" or \"improved\""));
  EXPECT_THAT(error("schedule = \"parallel\"\nload_in_window = \"linear\"\n"), testing::HasSubstr("a window late"));
  EXPECT_THAT(error("window_s = 0.002\n", ", step_s = 0.001"),
              testing::HasSubstr("with steps of 0.001 s in windows of 0.002 s"));
  EXPECT_THAT(error("added_mass_guard = false\nadded_mass_limit = 100\n"),
              testing::HasSubstr("expected added_mass_guard = true"));
  EXPECT_THAT(error("longest_window_s = 0.1\n"), testing::HasSubstr("sound runs in the water: while blocks rest"));
  for (const char* fine : {"", "schedule = \"improved\"\n"}) EXPECT_EQ(error(fine), "");
  EXPECT_EQ(error("", ", kind = \"static\""), "") << "nothing swings";
}

TEST(ReservoirModel, WindowsThatGrowBesideWaterThatMovesAreAnError) {
  const auto read = [](const std::string& kind, const std::string& more) {
    return scene::read_text(wall_before(kind, "[coupling]\nlongest_window_s = 0.1\n" + more), "grows");
  };
  const std::string shaken = "[base_motion]\nacceleration_x_m_per_s2 = { sine = 1, frequency_hz = 2 }\n";
  EXPECT_THROW(read("surface = \"waves\"", ""), std::exception);
  EXPECT_THROW(read("surface = \"level\"", shaken), std::exception);
  EXPECT_NO_THROW(read("surface = \"level\"", ""));
}

/// 5 m deep, longest elements of a quarter of that: sound takes 1440 m/s.
TEST(ReservoirModel, WindowsThatSoundCrossesTooFastAreWarnedOf) {
  const auto warned = [](const std::string& step_s) {
    const auto read = scene::read_text(R"(water = { upstream_level_m = 5 }
material.m = { youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }
fluid = { model = "reservoir", reservoir = { compressible = true } }
block = [
  { name = "rock", material = "m", fixed = true, vertices_m = [[-9, -5], [20, -5], [20, 0], [-9, 0]] },
  { name = "wall", material = "m", vertices_m = [[0, 0], [8, 0], [8, 10], [0, 10]] },
]
analysis = { duration_s = 1, step_s = )" + step_s +
                                           " }\n",
                                       "sound");
    std::string all;
    for (const auto& warning : read.warnings) all += warning.text();
    return all;
  };
  EXPECT_THAT(warned("0.01"), testing::AllOf(testing::HasSubstr("sound runs 14.4 m in a window, 11.5 of the longest"),
                                             testing::HasSubstr("shorten step_s in [analysis] to 0.00043 s")));
  EXPECT_THAT(warned("0.0004"), testing::Not(testing::HasSubstr("sound runs")));
}

TEST(ReservoirModel, AFarWallWithinTheModelAndKeysOfAnotherModelAreErrors) {
  const auto error = [](const std::string& more) -> std::string {
    try {
      dam_of_two(more);
    } catch (const std::exception& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_THAT(error("[fluid]\nmodel = \"reservoir\"\nreservoir = { upstream_wall_m = -20 }\n"),
              testing::HasSubstr("upstream_wall_m is -20 m, within the model, which ends at -50 m"));
  EXPECT_THAT(error("[fluid]\nmodel = \"reservoir\"\nreservoir = { upstream_wall_m = -1e6 }\n"),
              testing::AllOf(testing::HasSubstr("depths of the water beyond the model's end at -50 m"),
                             testing::HasSubstr("at most 1000 depths")));
  EXPECT_THAT(error("[fluid]\nreservoir = { element_ratio = 0.2 }\n"),
              testing::HasSubstr("[fluid.reservoir] beside another model"));
  EXPECT_THAT(error("[fluid]\nmodel = \"reservoir\"\nreservoir = { bottom_reflection = 0.5 }\n"),
              testing::HasSubstr("bottom_reflection of water that is not compressible"));
  EXPECT_THAT(error("[fluid]\nmodel = \"reservoir\"\nreservoir = { compressible = true, sound_speed_m_per_s = 10 }\n"),
              testing::HasSubstr("above 29.38 m/s, twice the speed of a fall by the structure's size"));
  EXPECT_THAT(
      error("[[block]]\nname = \"boat\"\nmaterial = \"m\"\ninitial_velocity_m_per_s = [800, 0]\n"
            "vertices_m = [[-30, 18], [-20, 18], [-20, 22], [-30, 22]]\n"
            "[fluid]\nmodel = \"reservoir\"\nreservoir = { compressible = true }\n"),
      testing::AllOf(testing::HasSubstr("sound takes 1440 m/s in the water, and block \"boat\" begins with 800"),
                     testing::HasSubstr("above 1600 m/s, twice the speed of the fastest block")));
  EXPECT_THAT(error("[fluid]\nmodel = \"reservoir\"\nreservoir = { surface = \"still\" }\n"),
              testing::HasSubstr("expected one of level, waves"));
  EXPECT_THAT(error("[fluid]\nmodel = \"reservoir\"\nreservoir = { element_ratio = 0 }\n"),
              testing::HasSubstr("a number from 0.005 to 1"));
}

}  // namespace
}  // namespace blockweir::reservoir::reservoir_model_test
