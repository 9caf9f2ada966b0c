// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers solid_watch fluid_hydrostatic nlohmann_json::nlohmann_json bridge_scene_read
// Supports that have moved: statics leads blocks to where they stand at the run's end, and what cannot follow is named.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"
#include "solid/step/solid.hpp"
#include "solid/watch/energy.hpp"
#include "solid/watch/largest_strain.hpp"

namespace blockweir::solid::moved_supports_test {
namespace {

using testing::HasSubstr;

constexpr double pi = 3.14159265358979323846;

std::string start(const std::string& analysis) {
  return fmt::format(R"([analysis]
duration_s = 1
{}
[material.m]
youngs_modulus_pa = 1e10
poissons_ratio = 0.2
density_kg_per_m3 = 2300
[joint]
friction_angle_deg = 35
)",
                     analysis);
}

std::string block(const std::string& name, const std::string& vertices, const std::string& more = "") {
  return fmt::format("[[block]]\nname = \"{}\"\nmaterial = \"m\"\nvertices_m = [{}]\n{}", name, vertices, more);
}

std::string support(const std::string& name, const std::string& point, const std::string& x, bool held_in_y = false) {
  return fmt::format("[[support]]\nblock = \"{}\"\npoint_m = [{}]\ndisplacement_x_m = {}\n{}", name, point, x,
                     held_in_y ? "displacement_y_m = 0\n" : "");
}

/// A wall on a bed that two supports have moved by so much, under a cap.
std::string wall(const std::string& analysis, const std::string& way) {
  return start(analysis) + block("bed", "[-20, -4], [20, -4], [20, 0], [-20, 0]", "fixed = true\n") +
         block("wall", "[0, 0], [4, 0], [4, 8], [0, 8]") + block("cap", "[0, 8], [4, 8], [4, 9], [0, 9]") +
         support("wall", "4, 2", way) + support("wall", "4, 6", way);
}

std::string moved_to(double way_m) {
  return fmt::format("{{ from = 0, rate_per_s = {0}, to = {0} }}", way_m);
}

/// An arch of 11 voussoirs over 150 degrees whose right springing is drawn away.
std::string arch(const std::string& analysis, double way_m) {
  const double inner = 4.5, outer = 5.5, foot = 15 * pi / 180;
  const auto springing = [&](double side) {
    const auto at = [&](double r) { return fmt::format("[{}, {}]", side * r * std::cos(foot), r * std::sin(foot)); };
    const double low = side * inner * std::cos(foot), out = side * outer * std::cos(foot);
    const std::string below = fmt::format("[{}, -1], [{}, -1]", low, out + side * 0.5);
    return fmt::format("{}, {}, [{}, {}], {}", at(inner), below, out + side * 0.5, outer * std::sin(foot), at(outer));
  };
  const std::string path = moved_to(way_m);
  return start(analysis) +
         "[[arch]]\nname = \"v\"\nmaterial = \"m\"\nmean_radius_m = 5\nthickness_m = 1\nvoussoirs = 11\n"
         "embrace_deg = 150\nspringings = false\n" +
         block("left", springing(-1), "fixed = true\n") + block("right", springing(1)) +
         support("right", "4.6, -0.8", path, true) + support("right", "5.6, -0.8", path, true);
}

struct Led {
  scene::Scene scene;
  std::unique_ptr<Solid> solid;
  double energy_gain = 0;
};

Led run(const std::string& text) {
  Led led{.scene = scene::read_text(text, "moved").scene};
  led.solid = std::make_unique<Solid>(led.scene);
  led.solid->settle({});
  EnergyWatch energy;
  energy.look(*led.solid);
  const double dt = led.scene.analysis.kind == scene::AnalysisKind::at_rest ? 1 : led.scene.analysis.step_s;
  for (double t = 0; t < 1 - dt / 2; t += dt) {
    led.solid->advance(t, t + dt, {});
    energy.look(*led.solid);
  }
  led.energy_gain = energy.gain();
  return led;
}

double moved_x(const Led& led, const std::string& name) {
  for (std::size_t b = 0; b < led.solid->described(); ++b) {
    if (led.scene.blocks[b].name == name) return led.solid->states()[b].displacement[0];
  }
  return std::nan("");
}

TEST(MovedSupports, StaticsFindsTheBlocksWhereTheyAreLed) {
  for (const double way_m : {1e-6, 0.03, 0.4}) {
    for (const char* rigid : {"all", "none"}) {
      const Led led = run(wall(fmt::format("kind = \"static\"\nrigid = \"{}\"", rigid), moved_to(way_m)));
      EXPECT_TRUE(led.solid->state().rest.found) << way_m << " " << rigid;
      EXPECT_NEAR(moved_x(led, "wall"), way_m, 1e-4 * way_m + 2e-5) << rigid;
      EXPECT_NEAR(moved_x(led, "cap"), way_m, 1e-4 * way_m + 2e-5) << rigid;
      if (way_m < 1e-3) continue;  // elastic joints slip first where friction is spent
      double pull = 0;
      for (const Support& s : led.solid->state().supports) pull += s.force.x();
      EXPECT_NEAR(pull / (36 * 2300 * 9.81 * std::tan(35 * pi / 180)), 1, 2e-2) << "what friction resists " << rigid;
    }
  }
}

constexpr const char* slow = "kind = \"quasi-static\"\nstep_s = 0.1";

TEST(MovedSupports, AnArchOnASpringingThatSpreadsIsThatOfAQuasiStaticRun) {
  const Led at_rest = run(arch("kind = \"static\"", 0.1));
  const Led slowly = run(arch(slow, 0.1));
  EXPECT_TRUE(at_rest.solid->state().rest.found);
  const auto crown_y = [](const Led& led) { return led.solid->states()[5].displacement[1]; };
  EXPECT_NEAR(crown_y(at_rest), -0.0508, 1e-3);
  EXPECT_NEAR(crown_y(slowly), crown_y(at_rest), 5e-4);
}

/// The arch comes to rest where it has fallen to, which is no rest to be called standing.
TEST(MovedSupports, AnArchThatFallsOnTheWayHasNoRest) {
  EXPECT_FALSE(run(arch("kind = \"static\"", 3)).solid->state().rest.found);
}

/// Above a foundation block that is lifted its wall turns farther than a failure, and stands.
TEST(MovedSupports, WhatLagsBehindItsSupportHasNotFailed) {
  const auto lifted = [](const std::string& analysis) {
    const auto held = [](const char* x, const char* more) {
      return fmt::format("[[support]]\nblock = \"right\"\npoint_m = [{}, -2]\ndisplacement_y_m = {}\n{}", x,
                         moved_to(0.02), more);
    };
    return start(analysis) + block("ground", "[-20, -6], [20, -6], [20, -3], [-20, -3]", "fixed = true\n") +
           block("left", "[-1, -3], [3, -3], [3, 0], [-1, 0]") + block("right", "[3, -3], [7, -3], [7, 0], [3, 0]") +
           block("wall", "[0, 0], [5, 0], [2, 9], [0, 9]") + held("3.5", "displacement_x_m = 0\n") + held("6.5", "");
  };
  const Led at_rest = run(lifted("kind = \"static\""));
  const Led slowly = run(lifted(slow));
  EXPECT_TRUE(at_rest.solid->state().rest.found);
  const auto turned = [](const Led& led) { return led.solid->states().back().displacement[2]; };
  EXPECT_GT(turned(slowly), 5e-3);
  EXPECT_NEAR(turned(at_rest), turned(slowly), 2e-4);
}

/// Their steps have lengths of their own, in which a support has gone no farther than since the last step.
TEST(MovedSupports, TheirWorkIsInTheEnergyOfQuasiStaticSteps) {
  EXPECT_LE(run(arch(slow, 0.1)).energy_gain, 1e-4);
  EXPECT_LE(run(arch("kind = \"static\"", 0.1)).energy_gain, 1e-4);
  EXPECT_LE(run(wall("kind = \"quasi-static\"", "{ sine = 0.02, frequency_hz = 2 }")).energy_gain, 1e-4);
}

TEST(MovedSupports, LevelAndSafetyHaveThemWhereTheyStandAndSaySo) {
  const std::string text =
      wall("rigid = \"all\"", moved_to(0.03)) + "[water]\nupstream_level_m = 6\nmay_overtop = true\n";
  const scene::Scene scene = scene::read_text(text, "moved").scene;
  const nlohmann::json safety = process::safety_answer(scene, hydrostatic::make);
  EXPECT_EQ(safety["outcome"], "stands") << safety.dump();
  const nlohmann::json level = process::level_answer(scene, hydrostatic::make);
  scene::Scene unstressed = scene;
  unstressed.analysis.start = scene::Start::unstressed;
  EXPECT_NEAR(process::level_answer(unstressed, hydrostatic::make)["level_m"].get<double>(),
              level["level_m"].get<double>(), 1e-4);
  EXPECT_EQ(level["outcome"], "fails") << level.dump();
  for (const nlohmann::json& answer : {safety, level}) {
    EXPECT_THAT(answer["warnings"].dump(),
                HasSubstr("has each [[support]] where it stands at the run's end, 1 s, led there slowly: that of block "
                          "\\\"wall\\\" at (4, 2) by 0.03 m; limit analysis has the structure as drawn"));
  }
  const scene::Scene held =
      scene::read_text(wall("rigid = \"all\"", "0") + "[water]\nupstream_level_m = 6\n", "held").scene;
  EXPECT_THAT(process::safety_answer(held, hydrostatic::make)["warnings"].dump(), Not(HasSubstr("[[support]]")));
}

TEST(MovedSupports, TwoThatTearARigidBlockApartAreNamed) {
  const std::string text = start("kind = \"static\"\nrigid = \"all\"") +
                           block("bed", "[-20, -4], [20, -4], [20, 0], [-20, 0]", "fixed = true\n") +
                           block("wall", "[0, 0], [4, 0], [4, 8], [0, 8]") + support("wall", "1, 1", "0") +
                           support("wall", "3, 1", moved_to(0.5));
  try {
    run(text);
    FAIL() << "a rigid block was torn";
  } catch (const SolveError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("no equilibrium was found with the supports beyond 0 % of their way to where they stand at 1 "
                          "s; the [[support]] of block \"wall\" at (3, 1) goes farthest, by 0.5 m"));
  }
}

TEST(MovedSupports, TwoThatStrainABlockBeyondAllBearingAreWarnedOf) {
  for (const double way_m : {0.01, 0.5}) {
    const Led led =
        run(start("kind = \"static\"") + block("bed", "[-20, -4], [20, -4], [20, 0], [-20, 0]", "fixed = true\n") +
            block("wall", "[0, 0], [4, 0], [4, 8], [0, 8]") + support("wall", "1, 1", "0") +
            support("wall", "3, 1", moved_to(way_m)));
    LargestStrain strain;
    strain.look(*led.solid, 1);
    if (way_m < 0.1) {
      EXPECT_EQ(strain.warning(*led.solid), "");
    } else {
      EXPECT_THAT(strain.warning(*led.solid), HasSubstr("block \"wall\" is strained by 0.25 at 1 s"));
      EXPECT_THAT(strain.warning(*led.solid), HasSubstr("its 2 supports pull it apart or together"));
    }
  }
}

TEST(MovedSupports, OneThatLeapsIsNamedWhereTheRunStops) {
  try {
    run(wall("rigid = \"all\"", "{ steps = [[0, 0], [0.5, 0.05]] }"));
    FAIL() << "a block has followed a leap";
  } catch (const SolveError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the [[support]] of block \"wall\" at (4, 2) goes farthest in it, by 0.05 m"));
    EXPECT_THAT(error.what(), HasSubstr("are its displacements and times in the right units?"));
  }
}

}  // namespace
}  // namespace blockweir::solid::moved_supports_test
