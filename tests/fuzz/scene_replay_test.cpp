// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene
// Scenes spoiled at random, with a fixed seed: each gives a scene or a SceneError, never a crash and never a hang.
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>

#include "tests/unit/scene_sample.hpp"

using namespace blockweir::scene;

namespace {

/// What people and machines put where it does not belong.
const std::array<std::string, 30> scraps{
    "inf",    "nan",       "-1",     "0",   "1e308", "-1e-308",     "99999999999999999999",
    "1e400",  "true",      "\"\"",   "'x'", "[",     "]",           "{",
    "}",      "[[",        "]]",     "[]",  "{}",    "=",           "\n",
    ".",      "[block]\n", "\"\"\"", "#",   "\xff",  "[[block]]\n", ",",
    "[0, 0]", "a.b.c"};

class Spoiler {
 public:
  explicit Spoiler(std::uint32_t seed) : random_(seed) {}

  std::string spoil(std::string scene, std::size_t most_changes) {
    for (std::size_t changes = 1 + below(most_changes); changes > 0; --changes) change_once(scene);
    return scene;
  }
  const std::string& scrap() { return scraps[below(scraps.size())]; }
  std::size_t below(std::size_t end) { return random_() % end; }

 private:
  void change_once(std::string& scene) {
    if (scene.empty()) scene = "=";
    switch (below(7)) {
      case 0:
        scene[below(scene.size())] = static_cast<char>(below(256));
        break;
      case 1:
        scene.insert(below(scene.size()), scrap());
        break;
      case 2:
        scene.erase(below(scene.size()), 1 + below(12));
        break;
      case 3:
        replace_number(scene);
        break;
      case 4:
        swap_lines(scene);
        break;
      case 5: {
        const std::size_t from = below(scene.size());
        scene.insert(below(scene.size()), scene.substr(from, below(200)));
        break;
      }
      default:
        scene.resize(below(scene.size()) + 1);
        break;
    }
  }

  void replace_number(std::string& scene) {
    const auto at = scene.find_first_of("0123456789", below(scene.size()));
    if (at == std::string::npos) return;
    const auto end = std::min(scene.find_first_not_of("0123456789.e", at), scene.size());
    scene.replace(at, end - at, scrap());
  }

  void swap_lines(std::string& scene) {
    std::vector<std::string> lines;
    std::istringstream stream(scene);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    if (lines.empty()) return;
    std::swap(lines[below(lines.size())], lines[below(lines.size())]);
    scene.clear();
    for (const std::string& line : lines) scene += line + "\n";
  }

  std::mt19937 random_;
};

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
  for (int i = 0; i < 20'000; ++i) {
    SCOPED_TRACE(i);
    replay(spoiler.spoil(scenes[spoiler.below(scenes.size())], 4), {}, count);
  }
  EXPECT_GT(count.scenes, 500) << "hardly anything was read: the changes are too rough to reach the checks";
  EXPECT_GT(count.errors, 5000);
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
  for (int i = 0; i < 5'000; ++i) {
    SCOPED_TRACE(i);
    replay(sample::text, {spoiler.spoil(sound[spoiler.below(sound.size())], 1)}, count);
  }
  EXPECT_GT(count.scenes, 50);
  EXPECT_GT(count.errors, 1000);
}

/// Outlines with every kind of coincidence: few grid points, many vertices, many blocks on each other.
TEST(SceneReplay, RandomOutlinesAreReadOrRefused) {
  Spoiler spoiler(3);
  Count count;
  for (int i = 0; i < 3'000; ++i) {
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
  EXPECT_GT(count.scenes, 100);
  EXPECT_GT(count.errors, 100);
}

}  // namespace
