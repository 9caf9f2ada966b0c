// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_picture bridge_study
// Text of a scene is text in gnuplot's scripts: nothing of it is a command, a macro or markup.
#include "bridge/picture/gnuplot.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>

#include "bridge/picture/curve.hpp"
#include "bridge/picture/draw.hpp"
#include "bridge/picture/plot_flow.hpp"
#include "bridge/picture/plot_series.hpp"
#include "bridge/picture/plot_snapshots.hpp"
#include "bridge/study/map_figure.hpp"
#include "tests/own_folder.hpp"

namespace blockweir::test::gnuplot_text_test {
namespace {

namespace fs = std::filesystem;
using picture::Picture;

/// All printable letters of ASCII, and some that are none.
std::string all_letters() {
  std::string text;
  for (char c = ' '; c < 0x7f; ++c) text += c;
  return text + "äß–水\u202e";
}

/// What a script has outside texts in single quotes, data blocks and the breaks of a title.
std::string unquoted(const std::string& script) {
  std::string rest;
  std::istringstream lines(script);
  for (std::string line; std::getline(lines, line);) {
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '\'') {
        quoted = !quoted;
      } else if (!quoted && line.compare(i, 6, ".\"\\n\".") == 0) {
        i += 5;
      } else if (!quoted) {
        rest += line[i];
      }
    }
    EXPECT_FALSE(quoted) << line;
    rest += '\n';
    if (line.starts_with('$') && line.find(" << ") != std::string::npos) {
      const std::string end = line.substr(line.rfind(' ') + 1);
      while (std::getline(lines, line) && line != end) continue;
    }
  }
  return rest;
}

class GnuplotText : public OwnFolder {
 protected:
  /// Histories, frames and flows of a run with one block of this name.
  void write_run(const std::string& name) {
    std::string cell = name;
    for (std::size_t at = 0; (at = cell.find('"', at)) != std::string::npos; at += 2) cell.insert(at, 1, '"');
    const auto quoted = [&](const std::string& ending) { return '"' + cell + ending + '"'; };
    std::ofstream(folder / "history.csv")
        << "time_s,upstream_level_m," << quoted(".displacement_x_m") << ',' << quoted(".displacement_y_m") << ','
        << quoted(".rotation_rad") << "\n0,1,0,0,0\n1,2,1,1,1\n";
    const auto outline = nlohmann::json::parse("[[0, 0], [1, 0], [1, 1]]");
    const nlohmann::json block = {{"name", name}, {"fixed", false}, {"outline", outline}};
    std::ofstream(folder / "frames.jsonl") << nlohmann::json{{"time_s", 0.0},
                                                             {"blocks", nlohmann::json::array({block})},
                                                             {"contacts", nlohmann::json::array()},
                                                             {"panels", nlohmann::json::array()},
                                                             {"upstream_level_m", nullptr},
                                                             {"downstream_level_m", nullptr}}
                                           << '\n';
    std::ofstream(folder / "joint_water.csv") << "time_s,joint,x_m,y_m,aperture_m,pressure_pa\n0," << quoted("")
                                              << ",0,0,0,1\n0," << quoted("") << ",1,0,0,1\n";
    std::ofstream(folder / "flow.csv") << "time_s," << quoted("_m2_per_s") << "\n0,1\n1,2\n";
    std::ofstream(folder / "joint_uplift.csv")
        << "time_s,joint,length_m,inflow,mean,uplift_n_per_m,triangular,drained,full\n0," << quoted("")
        << ",1,1,1,1,1,1,1\n1," << quoted("") << ",1,1,1,1,1,1,1\n";
  }

  std::vector<Picture> pictures_of(const std::string& name) {
    write_run(name);
    const nlohmann::json summary = {{"title", name}, {"failure", {{"time_s", 0.5}}}};
    std::vector<Picture> all = picture::series_pictures({.run = folder}, summary, ".png");
    for (const auto& more : {picture::snapshot_pictures(folder, summary, ".png", true),
                             picture::flow_picture(folder, {{"title", name}}, ".png")}) {
      all.insert(all.end(), more.begin(), more.end());
    }
    const std::array<scene::Sweep, 2> axes = {scene::Sweep{name, {"1"}}, scene::Sweep{"key", {name}}};
    const nlohmann::json cell = {{"shown", "stands"}, {"verdict", "right"}};
    all.push_back({folder / "map.png", 800, 600, study::map_figure(axes, nlohmann::json::array({cell}))});
    return all;
  }
};

/// The room of a legend is as wide as its names are long.
std::string without_margin(const std::string& script) {
  return std::regex_replace(script, std::regex("set rmargin [0-9]+\n"), "");
}

TEST_F(GnuplotText, NoLetterOfANameLeavesItsQuotes) {
  std::vector<std::string> names = {"a", all_letters(), "`touch x`", "'.system('touch x').'"};
  for (char c = ' '; c < 0x7f; ++c) names.push_back(std::string("a") + c + "b" + c);
  const std::vector<Picture> plain = pictures_of("a");
  ASSERT_EQ(plain.size(), 8);  // displacements, rotations, level, snapshots, picture, animation, flow and a map
  for (const std::string& name : names) {
    const std::vector<Picture> pictures = pictures_of(name);
    ASSERT_EQ(pictures.size(), plain.size());
    for (std::size_t i = 0; i < plain.size(); ++i) {
      EXPECT_EQ(without_margin(unquoted(pictures[i].commands)), without_margin(unquoted(plain[i].commands)))
          << name << " in " << plain[i].file;
    }
  }
}

TEST_F(GnuplotText, ALineOfAScriptDoesNotEndInAText) {
  EXPECT_EQ(picture::gnuplot_text(std::string("it's\r\nsystem\0('x')\x7f", 19)), "'it''s  system (''x'') '");
}

TEST_F(GnuplotText, EveryTerminalIsOpenedWithoutMarkup) {
  for (const char* file : {"a.png", "a.svg", "a.gif"}) {
    const std::string script = gnuplot_script(Picture{file, 100, 100, ""}, "out");
    EXPECT_NE(script.find(" noenhanced "), std::string::npos) << script;
  }
}

TEST_F(GnuplotText, StaysAsItIsInThePictureAndRunsNothing) {
  const std::string ran = (folder / "ran").string();
  const std::string name = all_letters() + "`touch " + ran + "` %d @x";
  std::vector<Picture> pictures = pictures_of(name);
  for (const char* end : {"'", "\n"}) {
    const fs::path odd = folder / ("| touch " + ran + "\nsystem(\"touch " + ran + "\")\n#" + end);
    fs::create_directories(odd);
    pictures.push_back({odd / "`touch ran`'.svg", 3000, 400,
                        "set title " + picture::gnuplot_text(name) + "\nset xtics (" + picture::gnuplot_tic(name) +
                            " 1)\nplot x title " + picture::gnuplot_text(name) + "\n"});
  }
  picture::draw(pictures);
  EXPECT_FALSE(fs::exists(ran));
  std::ifstream stream(pictures.back().file);
  const std::string svg(std::istreambuf_iterator<char>(stream), {});
  std::size_t shown = 0;
  for (std::size_t at = 0; (at = svg.find("`touch " + ran + "` %d @x", at)) != std::string::npos; ++at) ++shown;
  EXPECT_EQ(shown, 2) << svg;  // of a tic gnuplot itself keeps no more than 50 letters
  EXPECT_NE(svg.find("()*+,-./0123456789:;&lt;=>?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_`abc"), std::string::npos) << svg;
}

TEST_F(GnuplotText, ALongTitleIsBrokenAndThenCut) {
  EXPECT_EQ(picture::gnuplot_title("short", 500), "'short'");
  EXPECT_EQ(picture::gnuplot_title("ten letters and more", 96), "'ten'.\"\\n\".'letters'.\"\\n\".'and more'");
  EXPECT_EQ(picture::gnuplot_title(std::string(100, 'x'), 48), "'xxxxx'.\"\\n\".'xxxxx'.\"\\n\".'xxxx…'");
  EXPECT_EQ(picture::shortened("ääää", 3), "ää…");
}

TEST_F(GnuplotText, NoFileIsLeftWhereGnuplotRefuses) {
  const Picture sound{folder / "sound.png", 100, 100, "plot x\n"};
  EXPECT_THROW(picture::draw({sound, {folder / "wrong.png", 100, 100, "no command\n"}}), std::runtime_error);
  EXPECT_TRUE(fs::is_empty(folder));
  picture::draw({sound});
  EXPECT_GT(fs::file_size(sound.file), 100U);
}

TEST_F(GnuplotText, AFullDiskIsToldWithItsReason) {
  const fs::path full = folder / "full.png";
  fs::create_symlink("/dev/full", full);
  try {
    picture::draw({{full, 100, 100, "plot x\n"}});
    FAIL() << "a full disk took a picture";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), "cannot write " + full.string() +
                                             ": is the disk full, or the folder not writable? (No space left on "
                                             "device); make room, or choose another folder");
  }
}

TEST(Curve, KeepsTheLowestAndHighestOfEachSpanAndTheGaps) {
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 0; i <= 10000; ++i) {
    x.push_back(i);
    y.push_back(i == 5003 ? 7 : i == 5004 ? -7 : i % 2);
  }
  const std::string rows = picture::curve_rows(x, y, 10);
  EXPECT_LE(std::count(rows.begin(), rows.end(), '\n'), 24);
  EXPECT_NE(rows.find("5003 7\n5004 -7\n"), std::string::npos) << rows;
  EXPECT_TRUE(rows.starts_with("0 0\n")) << rows;
  EXPECT_NE(rows.find("\n10000 0\n"), std::string::npos) << rows;
  EXPECT_EQ(picture::curve_rows({0, 1, 2, 3}, {1, std::nan(""), 2, 4}, 100, 2), "0 2\n\n2 4\n3 8\n");
}

}  // namespace
}  // namespace blockweir::test::gnuplot_text_test
