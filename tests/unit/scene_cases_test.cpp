// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// The project's own scenes and their variants are sound, and warn of nothing that is not meant.
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_cases_test {
using namespace blockweir::scene;

namespace {

TEST(SceneCases, WarnOfNothingThatIsNotMeant) {
  int scenes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(std::string(BLOCKWEIR_SOURCE) + "/cases")) {
    if (entry.path().extension() != ".toml") continue;
    const auto expect_quiet = [&](const ReadScene& read, const std::string& variant) {
      ++scenes;
      for (const Diagnostic& warning : read.warnings) {
        // Blocks as light as air, so that no strain is seen over thirteen powers of ten.
        const bool light = entry.path().filename() == "ratios.toml" && warning.found.find("density") == 0;
        // The cracks of the paper's dams fall, and its full uplift is that of their mouths.
        const bool papers = entry.path().string().find("/cracked-dam-") != std::string::npos &&
                            warning.found.find("uplift = \"full\"") == 0;
        EXPECT_TRUE(light || papers) << variant << ": " << warning.text();
      }
    };
    const ReadScene scene = read(entry.path());
    expect_quiet(scene, "");
    for (const Variant& variant : scene.scene.variants) {
      expect_quiet(read_variant(entry.path(), variant.name), variant.name);
    }
  }
  EXPECT_GT(scenes, 100);
}

}  // namespace
}  // namespace blockweir::scene_cases_test
