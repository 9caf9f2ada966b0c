// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic nlohmann_json::nlohmann_json bridge_scene_read
// What a factor on strength does not see: a structure that is about to turn over, a crack that the uplift does not
// follow, anchors that take up their force as blocks move.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::test::safety_warnings_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

/// A wall of this outline on rock, before water of this depth.
json safety_of(const std::string& outline, const std::string& joint, double level_m, const std::string& more = "") {
  const std::string text = fmt::format(R"(analysis = {{ kind = "quasi-static", duration_s = 1, rigid = "all" }}
water = {{ upstream_level_m = {:.17g}, may_overtop = true }}
joint = {{ {} }}
material.m = {{ youngs_modulus_pa = 50e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-20, -8], [30, -8], [30, 0], [-20, 0]]
[[block]]
name = "wall"
material = "m"
vertices_m = [{}]
{})",
                                       level_m, joint, outline, more);
  const scene::Scene scene = scene::read_text(text, "wall.toml").scene;
  return process::safety_answer(scene, hydrostatic::make);
}

std::string warnings(const json& answer) {
  return answer["warnings"].dump();
}

/// W b/2 = f (rho g h^3/6 + rho g h b^2/2) with full uplift, f the factor on what the water presses.
double turns_over_at(double b, double height, double h) {
  const double water = 1000 * 9.81 * h;
  return 2400 * 9.81 * b * height * b / 2 / (water * h * h / 6 + water * b * b / 2);
}

TEST(SafetyWarnings, WhatIsAboutToTurnOverIsSaidToBe) {
  const std::string joint = "friction_angle_deg = 60, uplift = \"full\"";
  for (const double scale : {0.1, 1.0, 7.0}) {
    const std::string outline = fmt::format("[0, 0], [{0}, 0], [{0}, {1}], [0, {1}]", 2 * scale, 8 * scale);
    const json near = safety_of(outline, joint, 5.47 * scale);
    EXPECT_NEAR(near["water_factor"]["factor"].get<double>(), turns_over_at(2, 8, 5.47), 1e-7);
    EXPECT_THAT(warnings(near), HasSubstr("near its end: 1.00"));
    const json far = safety_of(outline, joint, 4 * scale);
    EXPECT_NEAR(far["water_factor"]["factor"].get<double>(), turns_over_at(2, 8, 4), 1e-7);
    EXPECT_THAT(warnings(far), Not(HasSubstr("near its end")));
  }
}

/// The added water of the earthquake is held, its inertia grows.
TEST(SafetyWarnings, AnEarthquakeWhoseWaterIsTooMuchIsNotPassedOver) {
  const std::string outline = "[0, 0], [2, 0], [2, 8], [0, 8]";
  const auto load_factor = [&](double level_m, double coefficient) {
    return safety_of(outline, "friction_angle_deg = 60", level_m,
                     fmt::format("[earthquake]\nhorizontal_coefficient = {}\n", coefficient))["load_factor"];
  };
  EXPECT_GT(load_factor(2, 0.05)["factor"].get<double>(), 1);
  EXPECT_TRUE(load_factor(7, 0.3)["factor"].is_null());
  EXPECT_TRUE(safety_of(outline, "friction_angle_deg = 60", 7)["load_factor"].is_null());  // nothing is stated
}

/// Also where friction is as scarce.
TEST(SafetyWarnings, AFactorOnTheWaterBelowOnePointOneIsWarnedOfWhateverTheStrength) {
  int near = 0;
  for (int step = 0; step <= 40; ++step) {
    const json answer = safety_of("[0, 0], [3, 0], [3, 8], [0, 8]", "friction_angle_deg = 45", 6 + 0.05 * step);
    const double factor = answer["water_factor"]["factor"];
    const bool scarce = factor >= 1 && factor < 1.1;
    near += scarce ? 1 : 0;
    EXPECT_EQ(warnings(answer).find("near its end") != std::string::npos, scarce) << factor;
  }
  EXPECT_GT(near, 1);
}

/// From the crest down, however the scene lists its blocks; and by the name that a run gives.
TEST(SafetyWarnings, JointsAreListedFromTheCrestDown) {
  std::vector<int> courses{1, 2, 3, 4, 5};
  for (int order = 0; order < 12; ++order, std::next_permutation(courses.begin() + 1, courses.end())) {
    std::string more;
    for (const int c : courses) {
      more += fmt::format(
          "[[block]]\nname = \"c{0}\"\nmaterial = \"m\"\nvertices_m = [[0, {0}], [3, {0}], [3, {1}], "
          "[0, {1}]]\n",
          c, c + 1);
    }
    const json answer = safety_of("[0, 0], [3, 0], [3, 1], [0, 1]", "friction_angle_deg = 45", 1, more);
    std::vector<std::string> names;
    for (const json& joint : answer["joints"]) names.push_back(joint["name"]);
    EXPECT_EQ(names,
              (std::vector<std::string>{"c5 on c4", "c4 on c3", "c3 on c2", "c2 on c1", "c1 on wall", "wall on rock"}));
  }
}

TEST(SafetyWarnings, ACrackThatTheUpliftDoesNotFollowIsTold) {
  const std::string outline = "[0, 0], [4.2, 0], [2.5, 9], [0, 9]";
  for (const char* law : {"none", "triangular", "flow"}) {
    const std::string aperture = std::string(law) == "flow" ? ", hydraulic_aperture_m = 3e-4" : "";
    const auto joint = fmt::format("friction_angle_deg = 60, uplift = \"{}\"{}", law, aperture);
    EXPECT_THAT(warnings(safety_of(outline, joint, 8.5)), HasSubstr("state uplift = \\\"cracked\\\"")) << law;
    EXPECT_THAT(warnings(safety_of(outline, joint, 5)), Not(HasSubstr("in tension"))) << law;
  }
  EXPECT_THAT(warnings(safety_of(outline, "friction_angle_deg = 60, uplift = \"cracked\"", 8)),
              Not(HasSubstr("in tension")));
}

/// An anchor at the heel turns the wall upstream: its toe opens, and there is air.
TEST(SafetyWarnings, ACrackWhoseMouthIsDryIsNotTold) {
  const std::string outline = "[0, 0], [7, 0], [1.5, 10], [0, 10]";
  const std::string anchor =
      "[[bolt]]\nname = \"a\"\nfrom_block = \"wall\"\nfrom_m = [0.7, 10]\nto_m = [0.7, -12]\n"
      "youngs_modulus_pa = 2e11\narea_m2_per_m = 1e-3\nprestress_n_per_m = 8e5\n";
  for (const char* law : {"none", "triangular"}) {
    const auto joint = fmt::format("friction_angle_deg = 35, uplift = \"{}\"", law);
    const json dry = safety_of(outline, joint, 0.5, anchor);
    EXPECT_GT(dry["joints"][0]["cracked_length_m"].get<double>(), 1);
    EXPECT_THAT(warnings(dry), Not(HasSubstr("in tension"))) << law;
  }
}

TEST(SafetyWarnings, AnchorsThatStretchAsBlocksMoveAreTold) {
  const std::string outline = "[0, 0], [7, 0], [2, 9], [0, 9]";
  const std::string anchor = R"([[bolt]]
name = "b"
from_block = "wall"
to_block = "rock"
from_m = [1, 0.5]
to_m = [-6, -6]
stiffness_n_per_m2 = 2e7
)";
  const std::string joint = "friction_angle_deg = 45, uplift = \"triangular\"";
  const json stretched = safety_of(outline, joint, 8, anchor);
  ASSERT_TRUE(stretched.contains("with_less_stretch"));
  EXPECT_LT(stretched["with_less_stretch"]["factor"], 0.8 * stretched["factor"].get<double>());
  EXPECT_THAT(warnings(stretched), HasSubstr("anchors that stretch while blocks move"));
  const std::string weak = anchor + "prestress_n_per_m = 1e5\nyield_n_per_m = 1e5\n";
  EXPECT_THAT(warnings(safety_of(outline, joint, 8, weak)), Not(HasSubstr("stretch")));
}

/// The wall turns about its toe: W b/2 + F (b - x) = f rho g h^3/6, with the anchor's force F at x.
TEST(SafetyWarnings, TheFactorOnTheWaterIsToldWithAnchorsAtTheirPrestressToo) {
  const std::string outline = "[0, 0], [3.2, 0], [3.2, 10], [0, 10]";
  const double level_m = 9.05;
  const auto answer_with = [&](const std::string& force) {
    return safety_of(outline, "friction_angle_deg = 60", level_m,
                     "[[bolt]]\nname = \"a\"\nfrom_block = \"wall\"\nfrom_m = [1.6, 9.5]\nto_m = [1.6, -7.5]\n"
                     "youngs_modulus_pa = 195e9\narea_m2_per_m = 2e-4\n" +
                         force);
  };
  const auto turns_over = [&](double anchor_n_per_m) {
    return (2400 * 9.81 * 32 + anchor_n_per_m) * 1.6 / (1000 * 9.81 * std::pow(level_m, 3) / 6);
  };
  const json little = answer_with("prestress_n_per_m = 20e3\nyield_n_per_m = 300e3\n");
  EXPECT_NEAR(little["water_factor"]["factor"].get<double>(), turns_over(20e3), 1e-7);
  EXPECT_NEAR(little["water_factor"]["with_anchors_at_yield"].get<double>(), turns_over(300e3), 1e-7);
  EXPECT_THAT(warnings(little), HasSubstr("brings it down with anchors at their prestress"));
  const json any_force = answer_with("prestress_n_per_m = 20e3\n");
  EXPECT_NEAR(any_force["water_factor"]["factor"].get<double>(), turns_over(20e3), 1e-7);
  const json passive = answer_with("yield_n_per_m = 300e3\n");
  EXPECT_NEAR(passive["water_factor"]["factor"].get<double>(), turns_over(0), 1e-7);
  EXPECT_THAT(warnings(passive), HasSubstr("by what anchors take up as blocks move"));
  const json full = answer_with("prestress_n_per_m = 300e3\nyield_n_per_m = 300e3\n");
  EXPECT_NEAR(full["water_factor"]["factor"].get<double>(), turns_over(300e3), 1e-7);
  EXPECT_FALSE(full["water_factor"].contains("with_anchors_at_yield"));
  EXPECT_THAT(warnings(full), Not(HasSubstr("near its end")));
}

/// Does a crack in the base of such a dam end, upright upstream and narrowing to a tenth of its base, by the gravity
/// method? Full pressure in it, then down to nothing at the toe; the length that presses is three times the way from
/// the toe to the resultant.
bool crack_ends(double b, double height, double h, double times) {
  const double gamma = times * 1000 * 9.81;
  const double weight = 2400 * 9.81 * 0.55 * b * height;
  const double arm = b - b * 1.11 / 3.3;  // of the weight, about the toe
  double crack = 0;
  for (int n = 0; n < 2000; ++n) {
    const double closed = b - crack;
    const double uplift = gamma * h * (crack + closed / 2);
    const double moment = weight * arm - gamma * h * h * h / 6 - gamma * h * crack * (b - crack / 2) -
                          gamma * h * closed * closed / 3;  // about the toe
    if (moment <= 0 || uplift >= weight) return false;
    crack = std::max(crack, b - 3 * moment / (weight - uplift));
    if (crack >= b) return false;
  }
  return true;
}

/// A factor on the water that keeps cracks as long as they are does not see that they run away.
TEST(SafetyWarnings, CracksThatGrowWithTheWaterAreSaidToBringItDown) {
  int seen = 0;
  for (const double scale : {0.3, 1.0, 4.0}) {
    const double b = 5.5 * scale;
    const double height = 9 * scale;
    const std::string outline = fmt::format("[0, 0], [{0}, 0], [{1}, {2}], [0, {2}]", b, b / 10, height);
    for (double h = 8 * scale; h < height; h += 0.03 * scale) {
      if (!crack_ends(b, height, h, 1.01)) break;
      const bool falls = !crack_ends(b, height, h, 1.1);
      if (falls == crack_ends(b, height, h, falls ? 1.09 : 1.11)) continue;  // next to the bound
      const json answer = safety_of(outline, "friction_angle_deg = 75, uplift = \"cracked\"", h);
      ASSERT_EQ(answer["outcome"], "stands") << h;
      EXPECT_TRUE(answer["water_factor"]["keeps_cracks"].get<bool>());
      const bool by_limit = answer["water_factor"]["factor"].get<double>() < 1.1;
      EXPECT_EQ(warnings(answer).find("near its end") != std::string::npos, falls || by_limit) << scale << ": " << h;
      EXPECT_EQ(warnings(answer).find("cracks grow") != std::string::npos, falls && !by_limit) << scale << ": " << h;
      seen += falls && !by_limit ? 1 : 0;
    }
  }
  EXPECT_GE(seen, 3);
}

TEST(SafetyWarnings, WaterOnTheCrestIsSaidToBeLeftOut) {
  const std::string joint = "friction_angle_deg = 60";
  EXPECT_THAT(warnings(safety_of("[0, 0], [6, 0], [6, 4], [0, 4]", joint, 4.5)),
              HasSubstr("the water on it is left out"));
  EXPECT_THAT(warnings(safety_of("[0, 0], [6, 0], [6, 4.1], [0, 4]", joint, 4.5)), HasSubstr("on no level crest"));
  EXPECT_THAT(warnings(safety_of("[0, 0], [6, 0], [6, 4], [0, 4]", joint, 3.9)), Not(HasSubstr("crest")));
}

}  // namespace
}  // namespace blockweir::test::safety_warnings_test
