// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_picture bridge_scene_read
// The scripts of a run's pictures: panels that line up, titles, and water that is in view.
#include <gmock/gmock.h>

#include <fstream>

#include "bridge/picture/plot_series.hpp"
#include "bridge/picture/plot_snapshots.hpp"
#include "bridge/picture/plot_spectrum.hpp"
#include "tests/own_folder.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::picture::run_pictures_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class RunPictures : public test::OwnFolder {
 protected:
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }

  /// The picture of that name by the history.
  [[nodiscard]] Picture series(const std::string& name) const {
    for (Picture& picture : series_pictures({folder}, {{"title", "t"}}, ".png")) {
      if (picture.file.stem() == name) return std::move(picture);
    }
    return {};
  }
};

TEST_F(RunPictures, PanelsHaveTheSameEdges) {
  write("history.csv",
        "time_s,upstream_level_m,downstream_level_m,largest_displacement_m,a.displacement_x_m\n"
        "0,1,nan,0,0\n1,2,nan,0.1,0.1\n");
  const Picture level = series("level");
  EXPECT_EQ(level.height, 740);
  EXPECT_THAT(level.commands, AllOf(HasSubstr("set lmargin 12\nset rmargin 28\nset multiplot layout 2,1 title 't: "
                                              "water level and largest displacement'"),
                                    HasSubstr("'level (m)'"), HasSubstr("'largest displacement (m)'")));
}

TEST_F(RunPictures, APanelWithoutValuesIsLeftOut) {
  write("history.csv",
        "time_s,upstream_level_m,downstream_level_m,largest_displacement_m,a.displacement_x_m\n"
        "0,nan,nan,0,0\n1,nan,nan,0.1,0.1\n");
  const Picture level = series("level");
  EXPECT_EQ(level.height, 400);
  EXPECT_THAT(level.commands, AllOf(HasSubstr("set multiplot layout 1,1 title 't: largest displacement'"),
                                    Not(HasSubstr("level (m)"))));
}

TEST_F(RunPictures, TheSpectrumHasTheScenesTitle) {
  write("scene.toml",
        scene::sample::text +
            "[base_motion]\nacceleration_x_m_per_s2 = { sine = 1, frequency_hz = 2 }\nform = \"inertia\"\n");
  const auto pictures = spectrum_picture(folder, ".png");
  ASSERT_EQ(pictures.size(), 1U);
  EXPECT_THAT(pictures[0].commands, HasSubstr("set multiplot layout 2,1 title 'sample: the ground''s"));
}

/// A block of 1 m at 8 m, before which water is drawn from 0 to 3 m.
class DamBreakPictures : public RunPictures {
 protected:
  DamBreakPictures() {
    write("scene.toml", R"(
[analysis]
duration_s = 3
[material.stone]
youngs_modulus_pa = 2e10
poissons_ratio = 0.2
density_kg_per_m3 = 2200
[[block]]
name = "floor"
material = "stone"
fixed = true
vertices_m = [[0, -0.5], [12, -0.5], [12, 0], [0, 0]]
[[block]]
name = "box"
material = "stone"
vertices_m = [[8, 0], [9, 0], [9, 1], [8, 1]]
[water]
may_overtop = true
[fluid]
model = "openfoam"
level_control = "free"
initial_water_m = [[[0, 0], [3, 0], [3, 2.5], [0, 2.5]]]
)");
    std::string frames;
    for (const char* time_s : {"0", "1", "2", "3"}) {
      frames += std::string("{\"time_s\": ") + time_s +
                ", \"upstream_level_m\": null, \"downstream_level_m\": null, \"contacts\": [], \"blocks\": ["
                "{\"outline\": [[0, -0.5], [12, -0.5], [12, 0], [0, 0]], \"fixed\": true}, "
                "{\"outline\": [[8, 0], [9, 0], [9, 1], [8, 1]], \"fixed\": false}]}\n";
    }
    write("frames.jsonl", frames);
    std::filesystem::create_directories(folder / "openfoam/0");
    write("openfoam/grid.json", R"({"x_m": [0, 3, 12], "y_m": [0, 2.5]})");
    write("openfoam/0/alpha.water", "internalField nonuniform List<scalar>\n2\n(\n1\n0\n)\n;");
    write("openfoam/0/U", "internalField uniform (0 0 0);\n");
  }
};

TEST_F(DamBreakPictures, ShowTheDrawnWaterAndWhatItsShadesMean) {
  const auto pictures = snapshot_pictures(folder, {{"title", "t"}, {"failure", {{"time_s", 2.0}}}}, ".png", false);
  EXPECT_THAT(pictures.at(0).commands, AllOf(HasSubstr("'t (water: the darker the faster, up to 0.1 m/s)'"),
                                             HasSubstr("set title '0.00 s'"), HasSubstr("set title '2.00 s'"),
                                             Not(HasSubstr("set title '1.00 s'")), HasSubstr("set xrange [0:")));
}

TEST_F(DamBreakPictures, TheDarkestWaterIsTheFastestOfTheRunUpTo12MetresASecond) {
  for (const auto& [speed, shown] : {std::pair{"0.39", "0.5"}, {"1.93", "2"}, {"60", "12"}}) {
    write("openfoam/0/U",
          std::string("internalField nonuniform List<vector>\n2\n(\n(") + speed + " 0 0)\n(0 0 0)\n)\n;");
    const auto pictures = snapshot_pictures(folder, {{"title", "t"}}, ".png", false);
    EXPECT_THAT(pictures.at(0).commands, HasSubstr(std::string("the darker the faster, up to ") + shown + " m/s)"));
  }
}

}  // namespace
}  // namespace blockweir::picture::run_pictures_test
