// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Loads in time: base motion, line and body loads, initial stress, records in files.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <tuple>

#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_loads_test {
using namespace blockweir::scene;
using sample::errors;
using sample::expect_error;
using sample::SceneFolder;
using sample::text;
using sample::warnings;
using sample::with;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

/// The sample with another section at its end, whose first line is line 56.
std::string and_also(const std::string& section) {
  return text + section;
}

Scene scene_of(const std::string& scene) {
  return read_text(scene, "s.toml").scene;
}

TEST(SceneLoads, ASineSwingsAboutItsMean) {
  const Scene scene = scene_of(and_also(
      "[base_motion]\nacceleration_x_m_per_s2 = { sine = 3, frequency_hz = 0.5, phase_deg = 90, mean = 1 }\n"));
  const TimeTable& a = scene.base_motion->acceleration_x_m_per_s2;
  EXPECT_DOUBLE_EQ(a.at(0), 4);
  EXPECT_NEAR(a.at(0.5), 1, 1e-12);
  EXPECT_NEAR(a.at(1), -2, 1e-12);
  EXPECT_EQ(scene.base_motion->acceleration_y_m_per_s2.at(1), 0);
  EXPECT_EQ(scene.base_motion->form, BaseForm::inertia);
  expect_error(and_also("[base_motion]\nacceleration_x_m_per_s2 = { sine = 3 }\n"), 57, {"has no \"frequency_hz\""});
  expect_error(and_also("[base_motion]\nacceleration_x_m_per_s2 = { sine = 3, frequency_hz = 0 }\n"), 57,
               {"frequency_hz in", "is 0", "a number above 0"});
  expect_error(and_also("[base_motion]\nacceleration_x_m_per_s2 = { sine = 3, frequency_hz = 1, from = 2, "
                        "rate_per_s = 1 }\n"),
               57, {"does not state one course in time", "sine"});
}

TEST(SceneLoads, AWaterLevelThatSwingsStaysWithinTheModel) {
  expect_error(with("{ table = [[0, 1], [2, 3]] }", "{ sine = 2, frequency_hz = 1, mean = 3 }"), 45,
               {"upstream_level_m reaches 5 m"});
}

TEST(SceneLoads, ABaseMotionMovesSomethingInOneOfTwoForms) {
  expect_error(and_also("[base_motion]\nform = \"support\"\n"), 56, {"[base_motion] moves nothing"});
  expect_error(and_also("[base_motion]\nform = \"bodies\"\nacceleration_x_m_per_s2 = 1\n"), 57,
               {"one of inertia, support"});
}

TEST(SceneLoads, ALineLoadStatesEachAxisOnce) {
  const std::string load = "[[line_load]]\nblock = \"top\"\nfrom_m = [3, 2]\nto_m = [3, 4]\n";
  const Scene scene = scene_of(and_also(load + "force_x_n_per_m2 = 5\nforce_from_y_n_per_m2 = 1\n"
                                               "force_to_y_n_per_m2 = { from = 2, rate_per_s = 1 }\n"));
  EXPECT_EQ(scene.line_loads[0].force_from_n_per_m2[0].at(0), 5);
  EXPECT_EQ(scene.line_loads[0].force_to_n_per_m2[0].at(0), 5);
  EXPECT_EQ(scene.line_loads[0].force_from_n_per_m2[1].at(1), 1);
  EXPECT_EQ(scene.line_loads[0].force_to_n_per_m2[1].at(1), 3);
  expect_error(and_also(load), 56, {"[[line_load]] does not state one force"});
  expect_error(and_also(load + "force_from_x_n_per_m2 = 5\n"), 56, {"does not state one force"});
  expect_error(and_also(load + "force_x_n_per_m2 = 5\nforce_from_x_n_per_m2 = 5\nforce_to_x_n_per_m2 = 5\n"), 56,
               {"does not state one force", "keep one of the two ways for each axis"});
  expect_error(and_also("[[line_load]]\nblock = \"top\"\nfrom_m = [3, 2]\nto_m = [0, 4]\nforce_x_n_per_m2 = 5\n"), 58,
               {"does not lie on one edge of block \"top\""});
  expect_error(and_also("[[line_load]]\nblock = \"top\"\nfrom_m = [3, 2]\nto_m = [3, 2]\nforce_x_n_per_m2 = 5\n"), 56,
               {"begins and ends at the same point"});
}

TEST(SceneLoads, ABodyLoadIsOnNamedBlocksOrOnAllThatMove) {
  const Scene scene =
      scene_of(and_also("[[body_load]]\nacceleration_x_m_per_s2 = 2\n"
                        "[[body_load]]\nblocks = [\"top\"]\nforce_y_n_per_m3 = 3\n"));
  EXPECT_THAT(scene.body_loads[0].blocks, ElementsAre(1, 2));
  EXPECT_TRUE(scene.body_loads[0].per_mass);
  EXPECT_THAT(scene.body_loads[1].blocks, ElementsAre(2));
  EXPECT_FALSE(scene.body_loads[1].per_mass);
  EXPECT_EQ(scene.body_loads[1].value[1].at(0), 3);
  expect_error(and_also("[[body_load]]\nblocks = [\"tpo\"]\nforce_y_n_per_m3 = 3\n"), 57,
               {"blocks in [[body_load]] names no block: \"tpo\"", "did you mean \"top\"?"});
  expect_error(and_also("[[body_load]]\nblocks = \"top\"\nforce_y_n_per_m3 = 3\n"), 57, {"a list of texts"});
  expect_error(and_also("[[body_load]]\n"), 56, {"[[body_load]] has no load"});
  expect_error(and_also("[[body_load]]\nforce_y_n_per_m3 = 3\nacceleration_x_m_per_s2 = 1\n"), 56,
               {"states both acceleration and force"});
}

TEST(SceneLoads, AnInitialStressHasThreeComponents) {
  const std::string scene = with("name = \"top\"", "name = \"top\"\ninitial_stress_pa = [-1, -2, 3]");
  EXPECT_EQ(*scene_of(scene).blocks[2].initial_stress_pa, Eigen::Vector3d(-1, -2, 3));
  EXPECT_FALSE(scene_of(scene).blocks[1].initial_stress_pa.has_value());
  EXPECT_EQ(scene_of(with("poissons_ratio = 0.2", "poissons_ratio = 0.2\ninitial_stress_pa = [0, -5, 0]"))
                .materials[0]
                .initial_stress_pa[1],
            -5);
  expect_error(with("name = \"top\"", "name = \"top\"\ninitial_stress_pa = [-1, -2]"), 25,
               {"initial_stress_pa", "three finite numbers [xx, yy, xy]"});
  expect_error(with("name = \"top\"", "name = \"top\"\ninitial_stress_pa = [-1, nan, 3]"), 25, {"is nan"});
}

class SceneRecord : public SceneFolder {
 protected:
  /// The scene of a base that follows a record.
  std::filesystem::path shaken(const std::string& record, const std::string& keys = "") {
    return write("scene.toml",
                 with("\n[water]\nupstream_level_m = { table = [[0, 1], [2, 3]] }\n[fluid]\nmodel = "
                      "\"hydrostatic\"",
                      "\n[base_motion]\nacceleration_x_m_per_s2 = { file = \"" + record + "\"" + keys + " }"));
  }
  /// What the reader says of the record "r.csv" that holds this.
  std::string complaint(const std::string& rows, const std::string& keys = "") {
    static_cast<void>(write("r.csv", rows));
    return error(shaken("r.csv", keys));
  }
};

/// A scale of its own may be what makes a record too large.
TEST_F(SceneRecord, ThatIsTooLargeHasItsScaleNamed) {
  static_cast<void>(write("r.csv", "0, 1\n1, 4\n2, 0\n"));
  const auto said = [&](const std::string& keys) {
    std::string all;
    for (const Diagnostic& d : read(shaken("r.csv", keys)).warnings) all += d.text() + "\n";
    return all;
  };
  EXPECT_THAT(said(", scale = 9.81"),
              HasSubstr("acceleration_x_m_per_s2 in [base_motion] reaches 39.24 m/s2, which is unusual; expected up to "
                        "30 m/s2; the rows of r.csv are multiplied by scale = 9.81: take it out where they are in "
                        "m/s2, and give 0.01 where they are in cm/s2"));
  static_cast<void>(write("r.csv", "0, 1\n1, 40\n2, 0\n"));
  EXPECT_THAT(said(""), HasSubstr("981 is cm/s2: give scale = 0.01 beside the record"));
}

TEST_F(SceneRecord, IsReadByColumnStepAndScale) {
  static_cast<void>(write("r.csv", "# station 7\ntime_s, east_g, north_g\n0, 1, 10\n\n0.5, +2e0, 20\n1, 3, 30\n"));
  const TimeTable second = read(shaken("r.csv")).scene.base_motion->acceleration_x_m_per_s2;
  EXPECT_THAT(second.time_s, ElementsAre(0, 0.5, 1));
  EXPECT_THAT(second.value, ElementsAre(1, 2, 3));
  const TimeTable third = read(shaken("r.csv", ", column = 3, scale = 0.5")).scene.base_motion->acceleration_x_m_per_s2;
  EXPECT_THAT(third.value, ElementsAre(5, 10, 15));
  static_cast<void>(write("r.txt", "1\n2\n  4\n"));
  const TimeTable plain = read(shaken("r.txt", ", step_s = 0.25")).scene.base_motion->acceleration_x_m_per_s2;
  EXPECT_THAT(plain.time_s, ElementsAre(0, 0.25, 0.5));
  EXPECT_THAT(plain.value, ElementsAre(1, 2, 4));
}

constexpr const char* peer_heading =
    "PEER NGA STRONG MOTION DATABASE RECORD\nTest, 1/1/2000, Station, 090\nACCELERATION TIME SERIES IN UNITS OF G\n";

/// Several values a row, the last row not full, and both ways to write the distance.
TEST_F(SceneRecord, OfThePeerDataBaseIsReadAsItIs) {
  for (const char* header : {"NPTS=  7, DT=   .2500 SEC", "  npts=7,dt=0.25 sec,", "NPTS=   7, DT= 2.5E-01 SEC\r"}) {
    static_cast<void>(write(
        "r.at2", std::string(peer_heading) + header + "\n  .1000E+00 -.2000E+00  .3000E+00 .4 .5\n  0.6  7.0E-01\n"));
    const TimeTable found = read(shaken("r.at2", ", scale = 10")).scene.base_motion->acceleration_x_m_per_s2;
    EXPECT_THAT(found.time_s, ElementsAre(0, 0.25, 0.5, 0.75, 1, 1.25, 1.5)) << header;
    EXPECT_THAT(found.value, testing::Pointwise(testing::DoubleNear(1e-12), {1., -2., 3., 4., 5., 6., 7.})) << header;
  }
}

TEST_F(SceneRecord, FaultsOfThePeerDataBaseAreNamed) {
  const std::string heading = std::string(peer_heading) + "NPTS= 3, DT= .01 SEC\n";
  EXPECT_THAT(complaint(heading + "1 2 3\n"),
              HasSubstr("it is a PEER file, whose fourth line states NPTS and DT = 0.01 "
                        "s; expected `scale` beside it, and neither step_s nor column; "
                        "write scale = 9.81 for values in g"));
  EXPECT_THAT(complaint(heading + "1 2 3\n", ", scale = 9.81, step_s = 0.01"), HasSubstr("neither step_s nor column"));
  EXPECT_THAT(complaint(heading + "1 2\n", ", scale = 9.81"),
              HasSubstr("it has 2 values, and line 4 states NPTS = 3; expected as many values as it states"));
  EXPECT_THAT(complaint(heading + "1 2\nx\n", ", scale = 9.81"), HasSubstr("\"x\" at line 6 is not a number"));
  EXPECT_THAT(complaint(std::string(peer_heading) + "NPTS= 300000, DT= .01 SEC\n1\n", ", scale = 9.81"),
              HasSubstr("line 4 states 300000 values"));
  EXPECT_THAT(complaint("1 2 3\n4 5 6\n", ", step_s = 0.1"), HasSubstr("put one in each row"));
}

TEST_F(SceneRecord, FarLongerThanTheRunIsWarnedOf) {
  const auto warned = [&](double last_s) {
    static_cast<void>(write("r.csv", fmt::format("0 0\n{0} 1\n{1} 0\n", last_s / 2, last_s)));
    const auto found = read(shaken("r.csv")).warnings;
    return std::any_of(found.begin(), found.end(), [](const Diagnostic& one) {
      return one.text().find("of which it gives the beginning alone") != std::string::npos;
    });
  };
  EXPECT_FALSE(warned(2));
  EXPECT_FALSE(warned(190));
  EXPECT_TRUE(warned(2000));  // the run takes 2 s
}

TEST_F(SceneRecord, BecomesPartOfTheTextAndItsDigest) {
  static_cast<void>(write("r.csv", "0 1\n1 0.1\n"));
  const Scene scene = read(shaken("r.csv")).scene;
  EXPECT_THAT(scene.text, testing::Not(HasSubstr("r.csv")));
  const Scene again = read_text(scene.text, "elsewhere/scene.toml").scene;
  EXPECT_EQ(again.base_motion, scene.base_motion);
  EXPECT_EQ(again.digest, scene.digest);
  static_cast<void>(write("r.csv", "0 1\n1 0.2\n"));
  EXPECT_NE(read(shaken("r.csv")).scene.digest, scene.digest);
}

TEST_F(SceneRecord, FaultsNameTheFileAndItsLine) {
  EXPECT_THAT(error(shaken("none.csv")), HasSubstr(":45: error: the record none.csv: there is no such file; expected"));
  EXPECT_THAT(error(shaken("")), HasSubstr("file in a record in a file is ''"));
  EXPECT_THAT(complaint("0,1\n1,x\n"), HasSubstr("the record r.csv: \"x\" at line 2 is not a number"));
  EXPECT_THAT(complaint("0,1\n1,nan\n"), HasSubstr("\"nan\" at line 2 is not a number; expected rows of finite"));
  EXPECT_THAT(complaint("nan,NaN\n0,1\n1,2\n"), HasSubstr("\"nan\" at line 1 is not a number"));
  EXPECT_THAT(complaint("0,1\n1,inf\n"), HasSubstr("\"inf\" at line 2 is not a number"));
  EXPECT_THAT(complaint("t,a\nu,b\n"), HasSubstr("\"u\" at line 2 is not a number"));
  EXPECT_THAT(complaint("0,1\n1,\n"), HasSubstr("line 2 has nothing in column 2; expected rows of finite numbers"));
  EXPECT_THAT(complaint("0,1\n,2\n"), HasSubstr("line 2 has nothing in column 1"));
  EXPECT_THAT(complaint(",\n0,1\n1,2\n"), HasSubstr("line 1 has nothing in column 1"));
  EXPECT_THAT(complaint("0,1\n1\n"), HasSubstr("line 2 has no column 2"));
  EXPECT_THAT(complaint("0,1\n1,2\n", ", column = 3"), HasSubstr("line 1 has no column 3; expected the same columns"));
  EXPECT_THAT(complaint("0,1\n1,2\n", ", column = 1"), HasSubstr("column 1 is the time; expected the column of"));
  EXPECT_THAT(complaint("0,1\n1,2\n1,3\n"), HasSubstr("time goes from 1 s to 1 s at line 3; expected times that"));
  EXPECT_THAT(complaint("0,1\n2,2\n1,3\n"), HasSubstr("time goes from 2 s to 1 s at line 3"));
  EXPECT_THAT(complaint("0,1\n"), HasSubstr("it has one row; expected two rows or more"));
  EXPECT_THAT(complaint(""), HasSubstr("it has no row; expected"));
  EXPECT_THAT(complaint("0,1e300\n1,2\n", ", scale = 1e300"), HasSubstr("the value at line 1 is too large"));
  EXPECT_THAT(complaint("0,1\n1,2\n", ", step_s = 0"), HasSubstr("step_s in a record in a file is 0"));
  EXPECT_THAT(complaint("0,1\n1,2\n", ", colum = 2"), HasSubstr("did you mean \"column\"?"));
  EXPECT_THAT(complaint("0,1\n1,2\n", ", step_s = 1"),
              HasSubstr("line 1 has 2 numbers, of which step_s makes the first the value; expected one number a row"));
  EXPECT_THAT(complaint("0;0,5\n1;0,7\n"), HasSubstr("line 1 has commas and semicolons; expected one of both"));
  std::string rows;
  for (int i = 0; i <= 100'000; ++i) rows += "1\n";
  EXPECT_THAT(complaint(rows, ", step_s = 1"), HasSubstr("more than 100000 rows"));
}

/// The structure of the sample alone.
const std::string structure = text.substr(0, text.find("[[joints]]"));

/// Forces in kN and pressures in kPa press on a block of 300 kN as good as nothing.
TEST(SceneLoads, ThoseThatAreNextToNothingBesideTheBlocksWeight) {
  const auto loaded = [](const std::string& list, const std::string& values) {
    return structure + fmt::format("[[{}]]\nblock = \"top\"\n{}\n", list, values);
  };
  for (const auto& [list, values, unit] :
       {std::tuple{"point_load", "point_m = [0, 4]\nforce_n_per_m = [{}, 0]", 1.0},
        {"face_pressure", "from_m = [0, 4]\nto_m = [0, 2]\npressure_pa = {}", 2.0},
        {"line_load", "from_m = [0, 4]\nto_m = [0, 2]\nforce_x_n_per_m2 = {}", 2.0}}) {
    const std::string text = values;
    const auto with_value = [&, list = list, unit = unit](double newtons) {
      return loaded(list, fmt::format(fmt::runtime(text), newtons / unit));
    };
    EXPECT_THAT(warnings(with_value(60)),
                Contains(AllOf(HasSubstr(fmt::format("a [[{}]] on block \"top\" is 60 N", list)),
                               HasSubstr("is it in kN, kPa or MN?"))));
    EXPECT_THAT(warnings(with_value(60e3)), IsEmpty()) << list;
  }
}

/// A dam of 25 m with a joint each 1500 m, in millimetres.
TEST(SceneLoads, LengthsBeyondTheStructure) {
  const std::string sound = structure;
  EXPECT_THAT(warnings(with("[joint]\n", "[joint]\ncohesion_pa = 1e5\nbonded_length_m = 250\n", sound)),
              Contains(AllOf(HasSubstr("bonded_length_m in [joint] is 250 m in a structure of"),
                             HasSubstr("no joint is that long"), HasSubstr("if it is in mm, write 0.25"))));
  EXPECT_THAT(warnings(with("name = \"top\"\n", "name = \"top\"\nmesh_size_m = 200\n", sound)),
              Contains(HasSubstr("mesh_size_m in [[block]] \"top\" is 200 m")));
}

}  // namespace
}  // namespace blockweir::scene_loads_test
