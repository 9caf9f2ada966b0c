// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Drawings with bytes changed, lost and put in: each is read or refused with a reason, and none crashes.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <random>

#include "bridge/scene/read/read.hpp"

namespace blockweir::scene {
namespace {

const std::string sound =
    "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nsection\n90\n4\n70\n1\n10\n0\n20\n0\n10\n4\n20\n0\n10\n4\n20\n4\n10\n0"
    "\n"
    "20\n4\n0\nLINE\n8\njoints "
    "crack\n10\n0\n20\n2\n11\n4\n21\n2\n0\nPOINT\n8\nsupports\n10\n1\n20\n0\n0\nENDSEC\n0\nEOF\n";

std::string spoiled(std::mt19937& random) {
  std::string text = sound;
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  for (std::size_t times = 1 + below(6); times > 0 && !text.empty(); --times) {
    const std::size_t at = below(text.size());
    switch (below(4)) {
      case 0:
        text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text.erase(at, 1 + below(30));
        break;
      case 2:
        text.insert(at, std::string(1 + below(8), "0123456789.-\ne"[below(14)]));
        break;
      default:
        text.resize(at + 1);
    }
  }
  return text;
}

TEST(Drawing, SpoiledOnesAreReadOrRefused) {
  const auto folder = std::filesystem::temp_directory_path() / ("blockweir-fuzz-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "scene.toml") << "[analysis]\nduration_s = 1\n[material.c]\nyoungs_modulus_pa = 1e9\n"
                                          "poissons_ratio = 0.2\ndensity_kg_per_m3 = 2400\n"
                                          "[section]\nmaterial = \"c\"\ndxf = \"d.dxf\"\n";
  std::mt19937 random(2);
  int read_soundly = 0;
  for (int trial = 0; trial < 500; ++trial) {
    std::ofstream(folder / "d.dxf", std::ios::binary) << spoiled(random);
    try {
      read(folder);
      ++read_soundly;
    } catch (const SceneError& error) {
      EXPECT_FALSE(error.diagnostics().empty());
    }
  }
  EXPECT_GT(read_soundly, 0);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace blockweir::scene
