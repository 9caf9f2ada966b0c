// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic nlohmann_json::nlohmann_json bridge_scene_read bridge_study
// Where friction is not determined, blocks listed in one order may stand and in the other fall: `safety`
// looks at more than one.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/scene/reordered.hpp"
#include "bridge/study/safety.hpp"

namespace blockweir::test::order_of_blocks_test {
namespace {

using nlohmann::json;

constexpr const char* stone = R"(joint = { friction_angle_deg = 30 }
material.stone = { youngs_modulus_pa = 20e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }
[[block]]
name = "floor"
material = "stone"
fixed = true
vertices_m = [[-5, -1], [12, -1], [12, 0], [-5, 0]]
)";

std::string stand(double tilt_deg, const char* rigid) {
  return fmt::format("analysis = {{ duration_s = 1, gravity_tilt_deg = {}, rigid = \"{}\" }}\n{}", tilt_deg, rigid,
                     stone);
}

std::string box(int number, double from_m, double to_m, double bottom_m, double top_m) {
  return fmt::format(
      "[[block]]\nname = \"b{0}\"\nmaterial = \"stone\"\n"
      "vertices_m = [[{1}, {3}], [{2}, {3}], [{2}, {4}], [{1}, {4}]]\n",
      number, from_m, to_m, bottom_m, top_m);
}

json safety_of(const scene::Scene& scene) {
  return process::safety_answer(scene, hydrostatic::make);
}

/// A slab of 0.18 m by 2.3 m that turns over by itself, beside a block that its upright face may hang on.
std::string slab(const char* rigid) {
  return stand(5, rigid) + box(0, 0, 1, 0, 2.3) + box(1, 1, 1.18, 0, 2.3);
}

scene::Scene reversed(const scene::Scene& scene) {
  std::vector<int> order(scene.blocks.size());
  std::iota(order.rbegin(), order.rend(), 0);
  return scene::reordered(scene, order);
}

TEST(OrderOfBlocks, ASlabThatOnlyAnUprightFaceHoldsIsNotSafeInEitherOrder) {
  for (const char* rigid : {"all", "none"}) {
    const scene::Scene scene = scene::read_text(slab(rigid), "slab").scene;
    EXPECT_LT(study::deciding_factor(safety_of(scene)), 0.1) << rigid;
    EXPECT_LT(study::deciding_factor(safety_of(reversed(scene))), 0.1) << rigid;
  }
}

/// Columns of blocks side by side, of random widths and heights.
std::string columns(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  std::string scene = stand(between(8, 18), "all");
  const int count = std::uniform_int_distribution(2, 5)(random);
  double x = 0;
  int number = 0;
  for (int column = 0; column < count; ++column) {
    const double width = between(0.15, 1);
    const double height = between(0.5, 2.5);
    const int blocks = std::uniform_int_distribution(1, 3)(random);
    for (int k = 0; k < blocks; ++k) {
      scene += box(number++, x, x + width, height * k / blocks, height * (k + 1) / blocks);
    }
    x += width;
  }
  return scene;
}

TEST(OrderOfBlocks, BothOrdersGiveTheSameFactor) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    const scene::Scene scene = scene::read_text(columns(seed), "columns").scene;
    const double one = study::deciding_factor(safety_of(scene));
    const double other = study::deciding_factor(safety_of(reversed(scene)));
    EXPECT_NEAR(one, other, 0.06 * one) << seed;
  }
}

/// BLOCKWEIR_CAMPAIGN=N: so many in place of a few.
unsigned columns_tried() {
  const char* asked = std::getenv("BLOCKWEIR_CAMPAIGN");
  return asked == nullptr ? 12 : static_cast<unsigned>(std::stoul(asked));
}

TEST(OrderOfBlocks, WhetherAStructureIsSafeDoesNotDependOnIt) {
  for (unsigned seed = 100; seed < 100 + columns_tried(); ++seed) {
    const scene::Scene scene = scene::read_text(columns(seed), "columns").scene;
    const bool is_safe = study::deciding_factor(safety_of(scene)) >= 1;
    std::vector<int> order(scene.blocks.size());
    std::iota(order.begin(), order.end(), 0);
    std::mt19937 random(seed);
    for (int shuffled = 0; shuffled < 3; ++shuffled) {
      std::shuffle(order.begin(), order.end(), random);
      const scene::Scene other = scene::reordered(scene, order);
      EXPECT_EQ(study::deciding_factor(safety_of(other)) >= 1, is_safe) << seed << ' ' << shuffled;
    }
  }
}

}  // namespace
}  // namespace blockweir::test::order_of_blocks_test
