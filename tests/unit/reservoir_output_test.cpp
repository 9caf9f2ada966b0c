// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_reservoir bridge_scene_read VTK::IOXML
// Pictures of water that answers accelerations are what VTK's own reader, and so ParaView, reads.
#include <gmock/gmock.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "bridge/scene/read/read.hpp"
#include "fluid/reservoir/reservoir_model.hpp"
#include "tests/own_folder.hpp"

namespace blockweir::reservoir::reservoir_output_test {
namespace {

constexpr double depth_m = 20;

scene::Scene wall(const std::string& output, const std::string& reservoir = "{}") {
  return scene::read_text(R"(analysis = { duration_s = 1, rigid = "all" }
water = { upstream_level_m = 20 }
material.m = { youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }
block = [
  { name = "rock", material = "m", fixed = true, vertices_m = [[-50, -10], [80, -10], [80, 0], [-50, 0]] },
  { name = "wall", material = "m", vertices_m = [[0, 0], [16, 0], [16, 22], [0, 22]] },
]
fluid = { model = "reservoir", reservoir = )" +
                              reservoir + " }\noutput = { frame_every_s = 0.01, " + output + " }\n",
                          "wall")
      .scene;
}

using ReservoirFiles = test::OwnFolder;

/// Two windows of 0.01 s; in the second the wall gets 0.2 m/s2, away from the water.
void run(const scene::Scene& scene, const std::filesystem::path& folder) {
  ReservoirModel water(scene, folder);
  wire::Load load;
  for (const double speed : {0.0, 2e-3}) {
    wire::Motion motion;
    motion.displacement.own() = {{}, {}};
    motion.velocity.own() = {{}, {speed, 0, 0, 0, 0, 0}};
    const double time_s = speed > 0 ? 0.01 : 0;
    water.advance(motion, time_s, load);
    if (scene.output.reservoir) {
      EXPECT_EQ(load.holds_until_s, time_s);  // there is a picture to take
    }
    water.record(time_s);
  }
}

TEST_F(ReservoirFiles, HaveThePressureOfEachMomentOnQuadraticTriangles) {
  run(wall("reservoir = true"), folder);
  std::ostringstream list;
  list << std::ifstream(folder / "reservoir.pvd").rdbuf();
  EXPECT_THAT(list.str(), testing::HasSubstr("frames/reservoir_000001.vtu"));
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName((folder / "frames/reservoir_000001.vtu").string().c_str());
  reader->Update();
  auto* water = reader->GetOutput();
  ASSERT_GT(water->GetNumberOfCells(), 100);
  EXPECT_EQ(water->GetCellType(0), VTK_QUADRATIC_TRIANGLE);
  auto* all = water->GetPointData()->GetArray("pressure_pa");
  auto* added = water->GetPointData()->GetArray("added_pressure_pa");
  double at_foot = 0;
  for (vtkIdType i = 0; i < water->GetNumberOfPoints(); ++i) {
    const double* x = water->GetPoint(i);
    EXPECT_NEAR(all->GetComponent(i, 0) - added->GetComponent(i, 0), 9810 * (depth_m - x[1]), 1e-6);
    if (std::hypot(x[0], x[1]) < 1e-9) at_foot = added->GetComponent(i, 0);
  }
  EXPECT_NEAR(at_foot, -0.2 * 0.742454 * 1000 * depth_m, 1e-3 * 3000);  // Westergaard's series at the foot
}

TEST_F(ReservoirFiles, LeaveOutTheStretchThatDampsWaves) {
  run(wall("reservoir = true", "{ compressible = true }"), folder);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName((folder / "frames/reservoir_000001.vtu").string().c_str());
  reader->Update();
  std::array<double, 6> box{};
  reader->GetOutput()->GetBounds(box.data());
  EXPECT_LT(box[0], -50 - 1.5 * depth_m);
  EXPECT_GT(box[0], -50 - 3 * depth_m);
}

TEST_F(ReservoirFiles, AreWrittenOnlyWhereTheyAreAskedFor) {
  run(wall("reservoir = false"), folder);
  EXPECT_FALSE(std::filesystem::exists(folder / "reservoir.pvd"));
}

}  // namespace
}  // namespace blockweir::reservoir::reservoir_output_test
