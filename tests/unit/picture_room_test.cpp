// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_picture
// What pictures show has room in their frames: curves stand off the axis, labels point at what is seen.
#include <gmock/gmock.h>

#include <fstream>
#include <regex>

#include "bridge/picture/plot_section.hpp"
#include "bridge/picture/plot_series.hpp"
#include "tests/own_folder.hpp"

namespace blockweir::test::picture_room_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class PictureRoom : public OwnFolder {};

TEST_F(PictureRoom, ALevelThatIsTheLowestStandsOffTheAxis) {
  std::ofstream(folder / "history.csv")
      << "time_s,upstream_level_m,downstream_level_m,largest_displacement_m\n0,14,2,0\n40,18,2,1\n";
  for (const auto& picture : picture::series_pictures({.run = folder}, json::object(), ".png")) {
    if (picture.file.filename() == "level.png") {
      EXPECT_THAT(picture.commands, HasSubstr("set offsets 0,0,graph 0.03,graph 0.03"));
    }
  }
}

/// The apron's seam reaches far beyond the frame: its label points at what is seen of it.
TEST_F(PictureRoom, LeadersOfLabelsEndInTheFrame) {
  const std::string rock = "[[-40, -14], [80, -14], [80, 0], [60, 0], [-3, -1.5], [-3, 0], [-40, 0]]";
  const std::string slab = "[[-3, -1.5], [12, -1.1428571428571428], [12, 0], [-3, 0]]";
  const std::string apron = "[[12, -1.1428571428571428], [60, 0], [12, 0]]";
  const std::string dam = "[[0, 0], [16.9, 0], [4.3, 18], [1.8, 18]]";
  std::ofstream(folder / "scene.toml")
      << "analysis.duration_s = 1\nmaterial.m = { youngs_modulus_pa = 1e10, poissons_ratio = 0.2, density_kg_per_m3 = "
         "2400 }\n"
      << "[[block]]\nname = 'rock'\nmaterial = 'm'\nfixed = true\nvertices_m = " << rock
      << "\n[[block]]\nname = 'slab'\nmaterial = 'm'\nvertices_m = " << slab
      << "\n[[block]]\nname = 'apron'\nmaterial = 'm'\nvertices_m = " << apron
      << "\n[[block]]\nname = 'dam'\nmaterial = 'm'\nvertices_m = " << dam
      << "\n[[joints]]\nname = 'seam'\nbetween = ['rock', 'apron']\n";
  json frame = {{"time_s", 0},
                {"upstream_level_m", nullptr},
                {"downstream_level_m", nullptr},
                {"panels", json::array()},
                {"contacts", json::array()},
                {"bolts", json::array()}};
  for (const auto& outline : {rock, slab, apron, dam}) {
    frame["blocks"].push_back({{"fixed", outline == rock}, {"outline", json::parse(outline)}});
  }
  std::ofstream(folder / "frames.jsonl") << frame << '\n';
  const std::string script = picture::section_picture(folder, json::object(), ".png").commands;
  EXPECT_THAT(script, HasSubstr("set label 'seam'"));
  std::smatch range;
  ASSERT_TRUE(std::regex_search(script, range, std::regex("set xrange \\[([^:]*):([^\\]]*)\\]")));
  ASSERT_LT(std::stod(range[2]), 36) << "the middle of the seam is in the frame";
  const std::regex leader("set arrow from ([^,]*),[^ ]* to ([^,]*),[^ ]* nohead lw 0.7");
  for (std::sregex_iterator at(script.begin(), script.end(), leader), end; at != end; ++at) {
    EXPECT_LE(std::stod((*at)[1]), std::stod(range[2])) << at->str();
  }
}

}  // namespace
}  // namespace blockweir::test::picture_room_test
