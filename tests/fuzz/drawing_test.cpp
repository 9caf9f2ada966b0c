// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Drawings with bytes changed, lost and put in: each is read or refused with a reason, and none crashes.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <random>

#include "bridge/scene/read/read.hpp"

namespace blockweir::scene::drawing_test {
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

class SpoiledDrawing : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "scene.toml") << "[analysis]\nduration_s = 1\n[material.c]\nyoungs_modulus_pa = 1e9\n"
                                            "poissons_ratio = 0.2\ndensity_kg_per_m3 = 2400\n"
                                            "[section]\nmaterial = \"c\"\ndxf = \"d.dxf\"\n";
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  /// What the scene says with this drawing; empty where it is refused.
  [[nodiscard]] std::string text_with(const std::string& drawing) const {
    std::ofstream(folder / "d.dxf", std::ios::binary) << drawing;
    try {
      return read(folder).scene.text;
    } catch (const SceneError& error) {
      EXPECT_FALSE(error.diagnostics().empty());
      return "";
    }
  }

  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("blockweir-fuzz-" + std::to_string(getpid()));
};

TEST_F(SpoiledDrawing, CutOffAnywhereItIsRefusedOrReadTheSame) {
  const std::string whole = text_with(sound);
  ASSERT_FALSE(whole.empty());
  for (std::size_t length = 0; length < sound.size(); ++length) {
    const std::string text = text_with(sound.substr(0, length));
    EXPECT_TRUE(text.empty() || text == whole) << length;
  }
}

TEST_F(SpoiledDrawing, NumbersThatAreNoneAreRefused) {
  std::mt19937 random(3);
  const std::vector<std::string> wrong = {"3x0", "nan", "-inf", "", "1,5", "1e999", "0x10", "4 4", "--4"};
  // The values of the group codes 10, 20, 11 and 21 stand in lines of their own after these.
  std::vector<std::size_t> starts;
  for (const std::string code : {"\n10\n", "\n20\n", "\n11\n", "\n21\n"}) {
    for (std::size_t at = 0; (at = sound.find(code, at)) != std::string::npos;) starts.push_back(at += code.size());
  }
  ASSERT_EQ(starts.size(), 14U);
  for (const std::size_t start : starts) {
    std::string text = sound;
    const std::size_t which = std::uniform_int_distribution<std::size_t>(0, wrong.size() - 1)(random);
    text.replace(start, sound.find('\n', start) - start, wrong[which]);
    EXPECT_EQ(text_with(text), "") << wrong[which] << " at " << start;
  }
}

TEST_F(SpoiledDrawing, SpoiledOnesAreReadOrRefused) {
  std::mt19937 random(2);
  int read_soundly = 0;
  for (int trial = 0; trial < 500; ++trial) {
    if (!text_with(spoiled(random)).empty()) ++read_soundly;
  }
  EXPECT_GT(read_soundly, 0);
}

}  // namespace
}  // namespace blockweir::scene::drawing_test
