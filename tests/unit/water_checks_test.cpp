// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_openfoam bridge_scene_read
// [[expect_water]]: what it needs is said before a run, and water.csv is read whatever blocks are called.
#include "fluid/openfoam/water_checks.hpp"

#include "bridge/results/csv.hpp"
#include "bridge/scene/water_quantities.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::water_checks_test {
namespace {

using scene::sample::expect_error;
using scene::sample::with;
using testing::HasSubstr;

std::string expecting(const std::string& keys, const std::string& fluid = "") {
  return with("\"hydrostatic\"", "\"openfoam\"\n" + fluid) + "[[expect_water]]\nvalue = 1\n" + keys;
}
const std::string waves = "wave = { kind = \"regular\", height_m = 0.2, period_s = 0.1 }\n";

TEST(ExpectWater, SaysWhatItsQuantityNeeds) {
  expect_error(expecting("quantity = \"force_x_n_per_m\""), 59, {"force_x_n_per_m without of", "name the block"});
  expect_error(expecting("quantity = \"force_x_amplitude_n_per_m\"", waves), 60, {"amplitude_n_per_m without of"});
  expect_error(expecting("quantity = \"front_arrival_s\""), 59, {"front_arrival_s without at_m"});
  expect_error(expecting("quantity = \"level_amplitude_m\""), 59, {"level_amplitude_m without regular waves"});
  expect_error(expecting("quantity = \"front_arival_s\""), 59,
               {"names no quantity: \"front_arival_s\"", "did you mean \"front_arrival_s\"?"});
}

TEST(ExpectWater, OfGroundIsRefused) {
  const auto sound = scene::read_text(expecting("quantity = \"force_x_n_per_m\"\nof = \"base\""), "s.toml");
  EXPECT_NO_THROW(openfoam::require_water_columns(sound.scene));
  const auto ground = scene::read_text(expecting("quantity = \"force_x_n_per_m\"\nof = \"ground\""), "s.toml");
  try {
    openfoam::require_water_columns(ground.scene);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("force_x_n_per_m of \"ground\": this is ground"));
  }
}

class WaterFile : public scene::sample::SceneFolder {};

TEST_F(WaterFile, HasEveryQuantityWhateverTheBlockIsCalled) {
  const std::string name = "a, \"b\"";
  std::string heading =
      "time_s,upstream_level_m,downstream_level_m,water_area_m2,front_m,fastest_m_per_s,ground_acceleration_x_m_per_s2";
  for (const char* what : {"force_x_n_per_m", "force_y_n_per_m", "moment_n", "velocity_x_m_per_s"}) {
    heading += "," + results::csv_cell(name + "." + what);
  }
  std::string rows;
  for (int i = 0; i <= 20; ++i) rows += fmt::format("{},{},nan,10,{},0.5,{},7,8,9,{}\n", 0.1 * i, i, i, i % 7, i * i);
  const auto file = write("water.csv", heading + "\n" + rows);
  scene::Scene scene = scene::read_text(expecting("quantity = \"level_swing_m\"", waves), "s.toml").scene;
  scene.water_expectations.clear();
  for (const scene::WaterQuantity& quantity : scene::water_quantities) {
    scene::Expectation& e = scene.water_expectations.emplace_back();
    e.quantity = quantity.name;
    e.value = 1;
    if (quantity.of_block) e.of = name;
    if (quantity.at_point) e.at_m = scene::Point(5.5, 5.5);
  }
  const auto checks = openfoam::water_checks(scene, file);
  const auto got = [&](const std::string& quantity) {
    for (const auto& check : checks) {
      if (check["name"].get<std::string>().rfind(quantity, 0) == 0) return check["got"].get<double>();
    }
    return std::nan("");
  };
  EXPECT_EQ(checks.size(), scene::water_quantities.size());
  EXPECT_EQ(got("force_x_n_per_m"), 7);
  EXPECT_EQ(got("force_y_n_per_m"), 8);
  EXPECT_NEAR(got("front_arrival_s"), 0.55, 1e-12);
  EXPECT_EQ(got("level_swing_m"), 5);
  scene.water_expectations[7].of = "c";
  EXPECT_THROW(openfoam::water_checks(scene, file), std::runtime_error);
}

TEST(Csv, CellsAreReadAsTheyWereWritten) {
  const std::vector<std::string> names = {"time_s", "a, \"b\".x", "", "\"", ",", "plain"};
  std::string line;
  for (const std::string& name : names) line += (&name == names.data() ? "" : ",") + results::csv_cell(name);
  EXPECT_EQ(results::csv_cells(line), names);
}

}  // namespace
}  // namespace blockweir::water_checks_test
