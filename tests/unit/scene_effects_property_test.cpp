// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// In random sound scenes, from 3 mm to 3 km, every statement without effect that is put in is reported, and nothing
// else is. BLOCKWEIR_SCENES=10000 makes so many scenes; the seed of each is its number.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "tests/samples.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_effects_property_test {
using namespace blockweir::scene;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

class RandomDam {
 public:
  explicit RandomDam(unsigned seed) : random_(seed) {
    height_m = 0.003 * std::pow(10, between(0, 6));
    lifts = 2 + static_cast<int>(between(0, 5));
    std::vector<double> levels{0};
    std::vector<double> breadths{between(0.6, 0.9) * height_m};
    for (int i = 1; i <= lifts; ++i) {
      levels.push_back(height_m * i / lifts);
      breadths.push_back(breadths.back() * between(0.6, 0.95));
    }
    const double h = height_m;
    text = fmt::format(
        "[analysis]\nduration_s = 10\n[material.m]\nyoungs_modulus_pa = 30e9\npoissons_ratio = 0.2\n"
        "density_kg_per_m3 = {}\n[joint]\nfriction_angle_deg = {}\n{}"
        "[water]\nupstream_level_m = {}\n"
        "[[block]]\nname = \"ground\"\nmaterial = \"m\"\nfixed = true\n"
        "vertices_m = [[{}, {}], [{}, {}], [{}, 0], [{}, 0]]\n",
        between(1800, 2600), between(20, 50), between(0, 1) < 0.5 ? "uplift = \"triangular\"\n" : "",
        between(0.5, 0.95) * h, -3 * h, -h, 4 * h, -h, 4 * h, -3 * h);
    for (int i = 0; i < lifts; ++i) {
      const auto k = static_cast<std::size_t>(i);
      text += fmt::format(
          "[[block]]\nname = \"{}\"\nmaterial = \"m\"\nvertices_m = [[0, {}], [{}, {}], [{}, {}], [0, {}]]\n", name(i),
          levels[k], breadths[k], levels[k], breadths[k + 1], levels[k + 1], levels[k + 1]);
      shortest_joint_m = breadths[k];
    }
    text += fmt::format("[[joints]]\nname = \"base\"\nbetween = [\"ground\", \"{}\"]\n", name(0));
  }

  [[nodiscard]] static std::string name(int lift) { return fmt::format("lift {}", lift + 1); }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / static_cast<double>(std::mt19937::max());
  }

  std::string text;
  double height_m = 0;
  int lifts = 0;
  double shortest_joint_m = 0;

 private:
  std::mt19937 random_;
};

/// What to put in at the end, and a word of what must then be said.
struct Statement {
  std::string lines;
  const char* said;
};

std::vector<Statement> without_effect(const RandomDam& dam) {
  const double h = dam.height_m;
  const std::string top = RandomDam::name(dam.lifts - 1);
  const std::string below = RandomDam::name(dam.lifts - 2);
  const std::string apart = fmt::format("[[joints]]\nname = \"j\"\nbetween = [\"ground\", \"{}\"]\n", top);
  const std::string lift = fmt::format("[[joints]]\nname = \"j\"\nbetween = [\"{}\", \"{}\"]\n", below, top);
  const std::string on_ground = "block = \"ground\"\n";
  const std::string face = fmt::format("from_m = [{}, {}]\nto_m = [{}, 0]\n", 4 * h, -h, 4 * h);
  return {
      {apart, "do not touch"},
      {apart + "uplift = \"full\"\n", "do not touch"},
      {apart + "cohesion_pa = 1e5\n", "do not touch"},
      {lift + "bonded_length_m = 1e-3\n", "the joint has no bond"},
      {lift + "keeps_cohesion = true\n", "the joint has no bond"},
      {lift + "softening_slip_m = 0.01\n", "the joint has no bond"},
      {lift + "dilation_limit_m = 0.01\n", "the joint has no dilation_angle_deg"},
      {lift + "cohesion_pa = 1e5\nbonded_length_m = 0\n", "have no effect"},
      {lift + fmt::format("cohesion_pa = 1e5\nbonded_length_m = {}\n", 1.01 * dam.shortest_joint_m),
       "longer than the joint"},
      {lift + "cohesion_pa = 1e5\nkeeps_cohesion = true\nresidual_friction_angle_deg = 5\n", "never fails"},
      {"[[support]]\n" + on_ground + "point_m = [0, 0]\ndisplacement_x_m = 0\n", "is fixed"},
      {"[[point_load]]\n" + on_ground + "point_m = [0, 0]\nforce_n_per_m = [1, 0]\n", "is fixed"},
      {"[[face_pressure]]\n" + on_ground + face + "pressure_pa = 1\n", "is fixed"},
      {"[[line_load]]\n" + on_ground + face + "force_x_n_per_m2 = 1\n", "is fixed"},
      {"[[body_load]]\nblocks = [\"ground\"]\nacceleration_x_m_per_s2 = 1\n", "is fixed"},
      {fmt::format("[[bolt]]\nname = \"b\"\nfrom_block = \"ground\"\nfrom_m = [0, 0]\nto_m = [0, {}]\n"
                   "stiffness_n_per_m2 = 1\n",
                   -h),
       "neither of its ends"},
      {"[material.spare]\nyoungs_modulus_pa = 30e9\npoissons_ratio = 0.2\ndensity_kg_per_m3 = 2400\n",
       "no block is of it"},
      {"[[expect]]\nquantity = \"kinetic_energy_j_per_m\"\nvalue = 0\nof = \"ground\"\n", "has no effect"},
      {"[[expect]]\nquantity = \"displacement_m\"\nvalue = 0\n", "has no of"},
      {"[output]\nreservoir = true\n[fluid]\nmodel = \"none\"\n", "reservoir in [output] has no effect"},
      {"[contact]\nformulation = \"penalty\"\npenetration_tolerance_m = 1e-9\n", "penetration_tolerance_m"},
  };
}

TEST(SceneEffects, EveryStatementWithoutEffectInRandomScenesIsReported) {
  const char* asked = std::getenv("BLOCKWEIR_SCENES");
  const int scenes = asked == nullptr ? blockweir::test::samples(50) : std::atoi(asked);
  std::size_t statements = 0;
  for (int seed = 1; seed <= scenes; ++seed) {
    const RandomDam dam(static_cast<unsigned>(seed));
    ASSERT_THAT(sample::errors(dam.text), IsEmpty()) << "seed " << seed << "\n" << dam.text;
    ASSERT_THAT(sample::warnings(dam.text), IsEmpty()) << "seed " << seed << "\n" << dam.text;
    for (const Statement& statement : without_effect(dam)) {
      const std::string spoilt = dam.text + statement.lines;
      auto said = sample::errors(spoilt);
      if (said.empty()) said = sample::warnings(spoilt);
      ASSERT_THAT(said, Contains(HasSubstr(statement.said))) << "seed " << seed << "\n" << spoilt;
      ++statements;
    }
  }
  fmt::print("{} scenes, seeds 1 to {}, {} statements without effect, all reported\n", scenes, scenes, statements);
}

}  // namespace
}  // namespace blockweir::scene_effects_property_test
