// SPDX-License-Identifier: GPL-3.0-or-later
// A sound scene for tests to spoil, and what the reader then says.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "bridge/scene/read/read.hpp"

namespace blockweir::scene::sample {

/// Two blocks on a foundation behind water, every section in use. Line numbers below are those of tests.
inline const std::string text = R"(title = "sample"
note = "made up"
[analysis]
duration_s = 2.0
step_s = 0.01
[contact]
max_iterations = 100
[material.concrete]
youngs_modulus_pa = 50e9
poissons_ratio = 0.2
density_kg_per_m3 = 2500
[joint]
friction_angle_deg = 30
[[block]]
name = "ground"
material = "concrete"
fixed = true
vertices_m = [[-5, -1], [8, -1], [8, 0], [-5, 0]]
[[block]]
name = "base"
material = "concrete"
vertices_m = [[0, 0], [3, 0], [3, 2], [0, 2]]
[[block]]
name = "top"
material = "concrete"
vertices_m = [[0, 2], [3, 2], [3, 4], [0, 4]]
[[joints]]
name = "crack"
between = ["base", "top"]
cohesion_pa = 1e5
[[support]]
block = "base"
point_m = [0, 0]
displacement_x_m = 0
[[point_load]]
block = "top"
point_m = [0, 4]
force_n_per_m = [100, -200]
[[face_pressure]]
block = "top"
from_m = [3, 2]
to_m = [3, 4]
pressure_pa = 1000
[water]
upstream_level_m = { table = [[0, 1], [2, 3]] }
[fluid]
model = "hydrostatic"
[coupling]
window_s = 0.02
[output]
frame_every_s = 0.5
[[expect]]
quantity = "failure_head_m"
value = 1.0
of = "crack"
)";

/// The sample with the only occurrence of `from` replaced.
inline std::string with(const std::string& from, const std::string& to, std::string scene = text) {
  const auto at = scene.find(from);
  if (at == std::string::npos || scene.find(from, at + 1) != std::string::npos) {
    throw std::logic_error("the sample does not hold exactly one: " + from);
  }
  return scene.replace(at, from.size(), to);
}

/// All that is wrong, a line each; empty when it reads the scene.
inline std::vector<std::string> errors(const std::string& scene, const std::vector<std::string>& overrides = {}) {
  std::vector<std::string> texts;
  try {
    read_text(scene, "s.toml", overrides);
  } catch (const SceneError& error) {
    for (const Diagnostic& d : error.diagnostics()) {
      if (d.severity == Diagnostic::Severity::error) texts.push_back(d.text());
    }
  }
  return texts;
}

/// All that the reader warns of, a line each.
inline std::vector<std::string> warnings(const std::string& scene, const std::vector<std::string>& overrides = {}) {
  std::vector<std::string> texts;
  for (const Diagnostic& d : read_text(scene, "s.toml", overrides).warnings) texts.push_back(d.text());
  return texts;
}

/// One warning and no other: at this line, with these words in it.
inline void expect_warning(const std::string& scene, int line, const std::vector<std::string>& words) {
  const auto found = warnings(scene);
  ASSERT_THAT(found, ::testing::SizeIs(1));
  const std::string place = line > 0 ? "s.toml:" + std::to_string(line) : "s.toml";
  EXPECT_THAT(found[0], ::testing::StartsWith(place + ": warning: "));
  for (const std::string& word : words) EXPECT_THAT(found[0], ::testing::HasSubstr(word));
}

/// One error and no other: at this line ("s.toml:12: error: "), with these words in it.
inline void expect_error(const std::string& scene, int line, const std::vector<std::string>& words) {
  const auto found = errors(scene);
  ASSERT_THAT(found, ::testing::SizeIs(1));
  const std::string place = line > 0 ? "s.toml:" + std::to_string(line) : "s.toml";
  EXPECT_THAT(found[0], ::testing::StartsWith(place + ": error: "));
  for (const std::string& word : words) EXPECT_THAT(found[0], ::testing::HasSubstr(word));
}

/// A folder of the test's own for files, gone with it.
class SceneFolder : public ::testing::Test {
 protected:
  SceneFolder() { std::filesystem::create_directories(folder_); }
  ~SceneFolder() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name) << content;
    return folder_ / name;
  }
  /// What the reader says of a file with one error; empty when it reads it.
  static std::string error(const std::filesystem::path& path) {
    try {
      read(path);
    } catch (const SceneError& error) {
      EXPECT_EQ(error.diagnostics().size(), 1u);
      return error.what();
    }
    return "";
  }
  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("blockweir-scene-" + std::to_string(::getpid()));
};

}  // namespace blockweir::scene::sample
