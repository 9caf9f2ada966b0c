// SPDX-License-Identifier: GPL-3.0-or-later
// The cases of this project, and what makes those with OpenFOAM short.
#pragma once

#include "tests/processes.hpp"

namespace blockweir::test {

/// What makes a case short, and how far off its figures may then be.
struct Short {
  std::string of;
  std::string variant{};
  std::vector<std::string> set{};

  /// Of `blockweir run`.
  [[nodiscard]] std::string options() const {
    std::string words = variant.empty() ? "" : " --variant '" + variant + "'";
    for (const std::string& key_and_value : set) words += " --set '" + key_and_value + "'";
    return words;
  }
};

inline const std::vector<Short>& short_versions() {
  static const std::vector<Short> all{
      {"accelerated-wall", "", {"fluid.cells_in_depth=10", "analysis.duration_s=1"}},
      {"breach"},  // as README has it, to its end
      {"caisson",  // slips by 2 cm
       "",
       {"fluid.cells_in_depth=10", "analysis.stop_at_failure=true", "expect.1.tolerance=0.05"}},
      {"cracked-dam-lower-openfoam",
       "",
       {"fluid.cells_in_depth=10", "analysis.duration_s=2", "water.upstream_level_m={table=[[0,20.4],[2,21.2]]}"}},
      {"cracked-dam-upper-openfoam",  // within 1 s its top slides by less than 0.001 of the dam's size
       "",
       {"fluid.cells_in_depth=10", "analysis.duration_s=1", "water.upstream_level_m={table=[[0,21.9],[1,22.4]]}",
        "analysis.failure_displacement_m=0.01"}},
      {"dam-break", "", {"fluid.cells_in_depth=20"}},
      {"floating-block", "", {"fluid.cells_in_depth=16"}},
      {"floating-block", "light slab", {"fluid.cells_in_depth=16"}},
      {"hydrostatic-wall-openfoam", "", {"fluid.cells_in_depth=10", "analysis.duration_s=0.1"}},
      {"hydrostatic-wall-openfoam", "level between lines", {"fluid.cells_in_depth=10", "analysis.duration_s=0.1"}},
      {"overtopping",  // its bore sets out nearer
       "",
       {"fluid.cells_in_depth=10", "analysis.duration_s=5", "fluid.upstream_depths=3",
        "fluid.initial_water_m=[[[-70,20.5],[-20,20.5],[-20,25.5],[-70,25.5]]]"}},
      {"own-openfoam-case"},
      {"rising-pool", "", {"fluid.cells_in_depth=10", "coupling.window_s=0.1"}},
      {"standing-wave",  // higher waves, of more cells
       "",
       {"fluid.cells_in_depth=16", "analysis.duration_s=16", "fluid.upstream_depths=2", "coupling.window_s=0.04",
        "fluid.wave={kind=\"regular\",height_m=0.5,period_s=4}", "expect_water.0.value=15398.7",
        "expect_water.1.value=0.5"}},
      {"shaken-tank", "", {"fluid.cells_in_depth=20", "analysis.duration_s=0.5", "expect_water.0.tolerance=0.05"}}};
  return all;
}

inline bool has_openfoam(const std::string& name) {
  std::ostringstream scene;
  scene << std::ifstream(cases + name + "/scene.toml").rdbuf();
  return scene.str().find("model = \"openfoam\"") != std::string::npos;
}

inline std::vector<std::string> all_cases(bool openfoam) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(cases)) {
    const std::string name = entry.path().filename();
    if (fs::exists(entry.path() / "scene.toml") && has_openfoam(name) == openfoam) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// As a part of a test's name.
inline std::string name_of(const testing::TestParamInfo<std::string>& tested) {
  std::string name = tested.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace blockweir::test
