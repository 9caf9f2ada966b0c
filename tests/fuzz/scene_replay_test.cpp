// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Scenes spoiled at random, with a fixed seed: each gives a scene or a SceneError, never a crash and never a hang.
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "tests/fuzz/spoiler.hpp"
#include "tests/samples.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_replay_test {
using namespace blockweir::scene;

namespace {

using blockweir::test::Spoiler;
namespace test = blockweir::test;

struct Count {
  int scenes = 0;
  int errors = 0;
};

void replay(const std::string& scene, const std::vector<std::string>& overrides, Count& count) {
  const auto start = std::chrono::steady_clock::now();
  try {
    const ReadScene read = read_text(scene, "fuzz.toml", overrides);
    EXPECT_FALSE(read.scene.blocks.empty());
    ++count.scenes;
  } catch (const SceneError& error) {
    EXPECT_FALSE(error.diagnostics().empty());
    for (const Diagnostic& d : error.diagnostics()) {
      EXPECT_FALSE(d.found.empty());
      EXPECT_FALSE(d.expected.empty()) << d.text();
    }
    ++count.errors;
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  EXPECT_LT(took.count(), 10) << scene;
}

std::vector<std::string> sound_scenes() {
  std::vector<std::string> scenes{sample::text};
  for (const auto& entry : std::filesystem::directory_iterator(BLOCKWEIR_SOURCE "/cases")) {
    std::ifstream file(entry.path() / "scene.toml");
    if (file) scenes.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return scenes;
}

TEST(SceneReplay, SpoiledScenesAreReadOrRefused) {
  Spoiler spoiler(20260101);
  Count count;
  const auto scenes = sound_scenes();
  for (int i = 0; i < test::samples(20'000); ++i) {
    SCOPED_TRACE(i);
    replay(spoiler.spoil(scenes[spoiler.below(scenes.size())], 4), {}, count);
  }
  EXPECT_GT(count.scenes, test::samples(500))
      << "hardly anything was read: the changes are too rough to reach the checks";
  EXPECT_GT(count.errors, test::samples(5000));
}

TEST(SceneReplay, SpoiledOverridesAreReadOrRefused) {
  Spoiler spoiler(7);
  Count count;
  const std::array<std::string, 6> sound{"analysis.step_s=0.1",
                                         "block.top.fixed=true",
                                         "block.1.vertices_m=[[0,0],[1,0],[0,1]]",
                                         "water.upstream_level_m={ from = 1, rate_per_s = 1 }",
                                         "joint.uplift=full",
                                         "material.concrete.density_kg_per_m3=2400"};
  for (int i = 0; i < test::samples(5'000); ++i) {
    SCOPED_TRACE(i);
    replay(sample::text, {spoiler.spoil(sound[spoiler.below(sound.size())], 1)}, count);
  }
  EXPECT_GT(count.scenes, test::samples(50));
  EXPECT_GT(count.errors, test::samples(1000));
}

/// Outlines with every kind of coincidence: few grid points, many vertices, many blocks on each other.
TEST(SceneReplay, RandomOutlinesAreReadOrRefused) {
  Spoiler spoiler(3);
  Count count;
  for (int i = 0; i < test::samples(3'000); ++i) {
    SCOPED_TRACE(i);
    std::ostringstream scene;
    scene
        << "analysis.duration_s = 1\n[material.m]\nyoungs_modulus_pa = 1\npoissons_ratio = 0\ndensity_kg_per_m3 = 1\n";
    const double grid = spoiler.below(2) == 0 ? 1 : 1.0 / 3;
    for (std::size_t b = 0; b < 1 + spoiler.below(5); ++b) {
      scene << "[[block]]\nname = \"b" << b << "\"\nmaterial = \"m\"\nfixed = true\nvertices_m = [";
      for (std::size_t v = 3 + spoiler.below(4); v > 0; --v) {
        scene << "[" << grid * static_cast<double>(spoiler.below(6)) << ","
              << grid * static_cast<double>(spoiler.below(6)) << "],";
      }
      scene << "]\n";
    }
    replay(scene.str(), {}, count);
  }
  EXPECT_GT(count.scenes, test::samples(100));
  EXPECT_GT(count.errors, test::samples(100));
}

}  // namespace
}  // namespace blockweir::scene_replay_test
