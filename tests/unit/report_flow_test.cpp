// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_report
// Tables of the water in joints, as pictures and the report read them.
#include "bridge/report/flow_data.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "bridge/picture/flow_files.hpp"
#include "bridge/picture/plot_flow.hpp"
#include "tests/own_folder.hpp"

namespace blockweir::test::report_flow_test {
namespace {

class ReportFlow : public OwnFolder {
 protected:
  const nlohmann::json summary = nlohmann::json::object();

  /// Two moments, into a folder of the run.
  void write_tables(const std::filesystem::path& into) const {
    std::filesystem::create_directories(into);
    std::ofstream(into / "flow.csv")
        << "time_s,from_open_water_m2_per_s,to_open_water_m2_per_s,to_air_m2_per_s,drain_main gallery_m2_per_s,"
           "stored_m2,largest_m2_per_s,largest_in_joint\n"
           "0,1e-6,0,1e-6,0,0.1,1e-6,base\n5,3e-6,0,1e-6,2e-6,0.1,1e-6,base\n";
    std::ofstream(into / "joint_water.csv") << "time_s,joint,x_m,y_m,aperture_m,pressure_pa,flow_m2_per_s\n"
                                               "0,base,0,0,1e-4,9810,1e-6\n0,base,8,0,1e-4,0,1e-6\n";
    std::ofstream(into / "joint_uplift.csv")
        << "time_s,joint,length_m,flow_m2_per_s,reynolds_number,uplift_n_per_m,triangular_n_per_m,drained_n_per_m,"
           "full_n_per_m\n"
           "0,base,8,1e-6,0.8,39240,39240,,78480\n5,lift,8,1e-6,0.8,1000,1100,,2000\n"
           "5,base,8,3e-6,2.3,20000,40000,19000,80000\n";
    std::ofstream(folder / "history.csv") << "time_s,upstream_level_m\n0,1\n5,2\n";
  }
};

TEST_F(ReportFlow, HasTheJointsOfTheEndByUpliftAndTheDrains) {
  for (const char* into : {"", "openfoam"}) {  // still water's folder, and that of OpenFOAM's plugin
    write_tables(folder / into);
    const nlohmann::json data = picture::flow_data(folder, summary);
    EXPECT_EQ(data["time_s"], 5);
    ASSERT_EQ(data["joints"].size(), 2);
    EXPECT_EQ(data["joints"][0]["name"], "base");
    EXPECT_EQ(data["joints"][0]["drained_n_per_m"], 19000);
    EXPECT_TRUE(data["joints"][1]["drained_n_per_m"].is_null());
    ASSERT_EQ(data["flows"].size(), 4);
    EXPECT_EQ(data["flows"][3]["name"], "drain main gallery");
    EXPECT_EQ(data["flows"][3]["m2_per_s"], 2e-6);
    std::filesystem::remove(folder / into / "flow.csv");
    EXPECT_TRUE(picture::flow_data(folder, summary).is_null());
  }
}

/// Joints that open wide in a fall say nothing of the structure.
TEST_F(ReportFlow, EndsBeforeFailureButHasTheFirstMoment) {
  write_tables(folder);
  for (const double failure_s : {4.9, -1.0}) {
    const nlohmann::json failed = {{"failure", {{"time_s", failure_s}}}};
    const nlohmann::json data = picture::flow_data(folder, failed);
    EXPECT_EQ(data["time_s"], 0);
    EXPECT_EQ(data["joints"][0]["uplift_n_per_m"], 39240);
    EXPECT_EQ(data["flows"][0]["m2_per_s"], 1e-6);
    EXPECT_EQ(picture::flow_picture(folder, failed, ".png").front().commands.find("\n5 "), std::string::npos);
  }
}

TEST_F(ReportFlow, IsDrawnBesideTheLawsOfTheJointWithMostUplift) {
  write_tables(folder);
  const auto pictures = picture::flow_picture(folder, summary, ".png");
  ASSERT_EQ(pictures.size(), 1);
  const std::string& script = pictures.front().commands;
  EXPECT_NE(script.find("layout 3,1"), std::string::npos);
  EXPECT_NE(script.find("joint base"), std::string::npos);
  EXPECT_NE(script.find("$law_7 << EOD\n5 19\nEOD"), std::string::npos) << script;
}

}  // namespace
}  // namespace blockweir::test::report_flow_test
