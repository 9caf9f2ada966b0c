// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_output VTK::IOXML
// What is written is what VTK's own reader, and so ParaView, reads.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "solid/output/history_writer.hpp"
#include "solid/output/vtk_writer.hpp"
#include "tests/own_folder.hpp"

namespace blockweir::solid::output::vtk_test {
namespace {

namespace fs = std::filesystem;

Frame frame_at(double time_s) {
  Frame frame{.time_s = time_s, .upstream_level_m = 1.5, .downstream_level_m = std::nan("")};
  BlockRow block;  // concave: an L
  block.vertices_m = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (std::size_t v = 0; v < 6; ++v) {
    block.displacement_m.emplace_back(0.1 * static_cast<double>(v), time_s);
    block.velocity_m_per_s.emplace_back(1, 2);
  }
  block.centroid_m = block.centroid_displacement_m = block.centroid_velocity_m_per_s = Point(1, 1);
  block.stress_yy_pa = -1.25e5;
  frame.blocks.push_back(block);
  frame.contacts.push_back(
      {.point_m = {0, 0}, .normal = {0, 1}, .state = 2, .normal_force_n_per_m = 3e4, .shear_force_n_per_m = 1e4});
  frame.panels.push_back({.from_m = {0, 1.5}, .to_m = {0, 0}, .pressure_to_pa = 14715});
  return frame;
}

vtkUnstructuredGrid* read(vtkXMLUnstructuredGridReader* reader, const fs::path& file) {
  reader->SetFileName(file.string().c_str());
  reader->Update();
  return reader->GetOutput();
}

using VtkFiles = test::OwnFolder;

TEST_F(VtkFiles, AreReadBackToTheBit) {
  VtkWriter writer(folder);
  writer.write(frame_at(0));
  writer.write(frame_at(1.0 / 3));
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  auto* blocks = read(reader, folder / "frames/blocks_000001.vtu");
  ASSERT_EQ(blocks->GetNumberOfCells(), 1);
  ASSERT_EQ(blocks->GetNumberOfPoints(), 6);
  EXPECT_EQ(blocks->GetCellType(0), VTK_POLYGON);
  EXPECT_EQ(blocks->GetPointData()->GetArray("displacement_m")->GetComponent(3, 1), 1.0 / 3);
  EXPECT_EQ(blocks->GetCellData()->GetArray("stress_pa")->GetComponent(0, 1), -1.25e5);
  auto* joints = read(reader, folder / "frames/joints_000001.vtu");
  EXPECT_EQ(joints->GetCellData()->GetArray("state")->GetComponent(0, 0), 2);
  EXPECT_EQ(joints->GetCellData()->GetArray("force_n_per_m")->GetComponent(0, 1), 3e4);
  auto* water = read(reader, folder / "frames/water_000001.vtu");
  EXPECT_EQ(water->GetNumberOfCells(), 2);  // the panel and the surface of one pool
  EXPECT_EQ(water->GetPointData()->GetArray("pressure_pa")->GetComponent(1, 0), 14715);
}

TEST_F(VtkFiles, OfJointsWithoutContactsAreOneForAllFrames) {
  Frame frame = frame_at(0);
  frame.contacts.clear();
  VtkWriter writer(folder);
  writer.write(frame);
  writer.write(frame);
  writer.write(frame_at(2));
  EXPECT_TRUE(fs::exists(folder / "frames/joints_000000.vtu"));
  EXPECT_FALSE(fs::exists(folder / "frames/joints_000001.vtu"));
  EXPECT_TRUE(fs::exists(folder / "frames/joints_000002.vtu"));
}

/// From the model's end, wherever the model is.
TEST_F(VtkFiles, AreDrawnWithTheWatersSurfaceWhereTheModelStands) {
  Frame frame = frame_at(0);
  for (Point& p : frame.blocks[0].vertices_m) p.x() += 1000;
  VtkWriter(folder).write(frame);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  auto* water = read(reader, folder / "frames/water_000000.vtu");
  EXPECT_EQ(water->GetPoint(2)[0], 1000);
  EXPECT_EQ(water->GetPoint(2)[1], 1.5);
}

/// Of no values there is no range: VTK's reader cannot read the bounds with which a search for one begins.
TEST_F(VtkFiles, OfNoWaterHaveRangesThatCanBeRead) {
  Frame dry = frame_at(0);
  dry.panels.clear();
  dry.upstream_level_m = std::nan("");
  VtkWriter(folder).write(dry);
  std::ifstream file(folder / "frames/water_000000.vtu");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  EXPECT_EQ(text.find("e+308"), std::string::npos) << text;
}

/// Debian 12's ParaView reads no others from 4 kB on.
TEST_F(VtkFiles, AreXmlThroughout) {
  VtkWriter(folder).write(frame_at(1.0 / 3));
  for (const char* name : {"blocks", "joints", "water"}) {
    std::ifstream file(folder / "frames" / (std::string(name) + "_000000.vtu"));
    const std::string text(std::istreambuf_iterator<char>(file), {});
    EXPECT_FALSE(text.empty());
    EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }))
        << name;
  }
}

TEST_F(VtkFiles, AreListedInTheCollectionWithTheirTimes) {
  VtkWriter writer(folder);
  writer.write(frame_at(0.5));
  std::ostringstream text;
  text << std::ifstream(folder / "blocks.pvd").rdbuf();
  for (const char* part :
       {"timestep=\"0.5\" part=\"0\" name=\"blocks\"", "part=\"1\" name=\"joints\"", "part=\"2\" name=\"water\""}) {
    EXPECT_THAT(text.str(), testing::HasSubstr(part));
  }
}

/// Those of many blocks are written beside what follows.
Frame of_many_blocks(double time_s) {
  Frame frame = frame_at(time_s);
  frame.blocks.resize(100, frame.blocks[0]);
  return frame;
}

TEST_F(VtkFiles, ThatCannotBeWrittenGiveOneClearError) {
  for (const Frame& frame : {frame_at(0), of_many_blocks(0)}) {
    VtkWriter writer(folder);
    fs::remove_all(folder / "frames");
    try {
      writer.write(frame);
      writer.finish();
      FAIL() << "a frame went to a folder that is gone";
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("is the disk full, or the folder not writable?"));
    }
  }
}

TEST_F(VtkFiles, OfManyBlocksAreAllThereAtTheEnd) {
  constexpr int frames = 5;
  VtkWriter writer(folder);
  for (int n = 0; n < frames; ++n) writer.write(of_many_blocks(n));
  writer.finish();
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  std::ostringstream list;
  list << std::ifstream(folder / "blocks.pvd").rdbuf();
  for (int n = 0; n < frames; ++n) {
    const std::string file = "blocks_00000" + std::to_string(n) + ".vtu";
    EXPECT_THAT(list.str(), testing::HasSubstr(file));
    auto* blocks = read(reader, folder / "frames" / file);
    ASSERT_EQ(blocks->GetNumberOfCells(), 100);
    EXPECT_EQ(blocks->GetPointData()->GetArray("displacement_m")->GetComponent(3, 1), n);
  }
}

TEST(History, AFullDiskGivesOneClearError) {
  const fs::path folder = fs::temp_directory_path() / ("blockweir-full-" + std::to_string(getpid()));
  fs::create_directories(folder);
  fs::create_symlink("/dev/full", folder / "history.csv");
  scene::Scene scene;
  try {
    HistoryWriter writer(folder, scene, results::Begin::anew);
    FAIL() << "a line went to a full disk";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("history.csv: is the disk full"));
  }
  fs::remove_all(folder);
}

TEST(History, AColumnOfTheGroundsMotionHasNoNamesake) {
  const fs::path folder = fs::temp_directory_path() / ("blockweir-namesakes-" + std::to_string(getpid()));
  fs::create_directories(folder);
  scene::Scene scene;
  scene.base_motion.emplace();
  scene::Block& block = scene.blocks.emplace_back();
  block.name = "base";
  block.vertices = {Point(0, 0), Point(1, 0), Point(0, 1)};
  scene.joints.emplace_back().name = "base";
  scene.bolts.emplace_back().name = "base";
  { const HistoryWriter writer(folder, scene, results::Begin::anew); }
  std::ifstream file(folder / "history.csv");
  std::string header;
  std::getline(file, header);
  std::istringstream cells(header);
  std::vector<std::string> columns;
  for (std::string cell; std::getline(cells, cell, ',');) columns.push_back(cell);
  EXPECT_THAT(columns, testing::IsSupersetOf({"base_motion_displacement_x_m", "base_motion_displacement_y_m",
                                              "base_motion_acceleration_x_m_per_s2",
                                              "base_motion_acceleration_y_m_per_s2", "base.displacement_x_m"}));
  std::sort(columns.begin(), columns.end());
  EXPECT_EQ(std::adjacent_find(columns.begin(), columns.end()), columns.end());
  fs::remove_all(folder);
}

}  // namespace
}  // namespace blockweir::solid::output::vtk_test
