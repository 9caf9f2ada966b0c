// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_watch fluid_reservoir bridge_schedule
// Light slabs over each other push one reservoir: the guard takes the whole added mass, on all schedules, at any ratio
// of the masses.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "bridge/scene/read/read.hpp"
#include "tests/verification/blocks_and_reservoir.hpp"

namespace blockweir::solid::slabs_in_reservoir_test {
namespace {

constexpr double depth_m = 10;
constexpr double spring_n_per_m2 = 4e6;
constexpr double push_n_per_m = 1;  // so little that all is linear

struct Run {
  int slabs;
  double density_kg_per_m3;
  const char* schedule;
  const char* integrator = "trapezoidal";
  double mesh_size_m = 0;  ///< of the slabs; 0: rigid
};

/// Slabs 1 m thick, 1 cm apart, without weight, each on a spring at its centroid; a sudden push on the lowest.
scene::Scene scene_of(const Run& run) {
  std::string text = fmt::format(
      R"(coupling = {{ schedule = "{}", window_s = 0.002 }}
water = {{ upstream_level_m = {} }}
fluid = {{ model = "reservoir", reservoir = {{ element_ratio = 0.5 }} }}
material.m = {{ youngs_modulus_pa = 50e9, poissons_ratio = 0.2, density_kg_per_m3 = {} }}
block = [ {{ name = "rock", material = "m", fixed = true, vertices_m = [[-20, -2], [1, -2], [1, -0.01], [-20, -0.01]] }} ]
point_load = [ {{ block = "slab0", point_m = [0.5, {}], force_n_per_m = [{}, 0] }} ]
)",
      run.schedule, depth_m, run.density_kg_per_m3, 6.0 / run.slabs - 0.005, push_n_per_m);
  std::string blocks;
  std::string bolts;
  for (int i = 0; i < run.slabs; ++i) {
    const double low = 12.0 / run.slabs * i;
    const double high = 12.0 / run.slabs * (i + 1) - 0.01;
    blocks += fmt::format(
        ", {{ name = \"slab{0}\", material = \"m\", {1}, vertices_m = [[0, {2}], [1, {2}], [1, {3}], [0, {3}]] }}", i,
        run.mesh_size_m > 0 ? fmt::format("mesh_size_m = {}", run.mesh_size_m) : "rigid = true", low, high);
    bolts += fmt::format(
        "{3} {{ name = \"spring{0}\", from_block = \"slab{0}\", from_m = [0.5, {1}], to_m = [200, {1}], "
        "stiffness_n_per_m2 = {2}, takes_compression = true }}",
        i, (low + high) / 2, spring_n_per_m2, i > 0 ? "," : "");
  }
  text.insert(text.find(" ]\npoint_load"), blocks);
  text += "bolt = [" + bolts + " ]\n";
  text += "[analysis]\nduration_s = 0.6\nstep_s = 0.002\ngravity_m_per_s2 = 0\nstart = \"unstressed\"\n";
  text += fmt::format("max_displacement_ratio = 1\nintegrator = \"{}\"\n", run.integrator);
  return scene::read_text(text, "slabs").scene;
}

/// (m + M) x'' + k x = f from rest, by modes.
Eigen::VectorXd exact(const Blocks& blocks, double time_s) {
  const auto slabs = static_cast<Eigen::Index>(blocks.solid.described() - 1);
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(3 * slabs, 3 * slabs);
  Eigen::MatrixXd K = M;
  for (Eigen::Index b = 0; b < slabs; ++b) {
    const auto block = static_cast<std::size_t>(b + 1);
    M.block<3, 3>(3 * b, 3 * b) = blocks.masses.own[block];
    M.block<3, 3>(3 * b, 3 * b) += blocks.solid.blocks()[block].inertia.matrix().topLeftCorner<3, 3>();
    K(3 * b, 3 * b) = spring_n_per_m2;
  }
  for (const CoupledMass& pair : blocks.masses.pairs) {
    M.block<3, 3>(3 * (pair.a - 1), 3 * (pair.b - 1)) = pair.mass;
    M.block<3, 3>(3 * (pair.b - 1), 3 * (pair.a - 1)) = pair.mass.transpose();
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(K, M);
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(3 * slabs);
  for (Eigen::Index i = 0; i < 3 * slabs; ++i) {
    const double square = modes.eigenvalues()[i];
    const double force = modes.eigenvectors()(0, i) * push_n_per_m;
    const double share = square > 1e-6 ? (1 - std::cos(std::sqrt(square) * time_s)) / square : time_s * time_s / 2;
    moved += share * force * modes.eigenvectors().col(i);
  }
  return moved;
}

/// Largest error of a slab's (u, v, turn by half its height) at the end, over the largest of the run.
double error_of(const Run& run) {
  const scene::Scene scene = scene_of(run);
  Blocks blocks(scene);
  run_with_reservoir(scene, blocks);
  if (run.mesh_size_m > 0) {  // so stiff that it moves as rigid slabs do
    Run rigid = run;
    rigid.mesh_size_m = 0;
    const scene::Scene twin = scene_of(rigid);
    Blocks of_twin(twin);
    run_with_reservoir(twin, of_twin);
    blocks.masses = of_twin.masses;
  }
  const double duration_s = scene.analysis.duration_s;
  const Eigen::Vector3d arms(1, 1, 6.0 / run.slabs);
  const auto largest_of = [&](const Eigen::VectorXd& moved) {
    double largest = 0;
    for (Eigen::Index i = 0; i < moved.size(); ++i) largest = std::max(largest, std::abs(moved[i] * arms[i % 3]));
    return largest;
  };
  double scale = 0;
  for (int k = 1; k <= 60; ++k) scale = std::max(scale, largest_of(exact(blocks, duration_s * k / 60)));
  Eigen::VectorXd off = exact(blocks, duration_s);
  for (Eigen::Index b = 0; b < off.size() / 3; ++b) {
    off.segment<3>(3 * b) -= blocks.solid.states()[static_cast<std::size_t>(b + 1)].displacement.head<3>();
  }
  return largest_of(off) / scale;
}

class SlabsInReservoir : public testing::TestWithParam<const char*> {};

TEST_P(SlabsInReservoir, MoveAsSlabsAndWaterTogetherAtAnyRatioOfTheMasses) {
  for (const int slabs : {2, 3, 5}) {
    for (const double density : {1.0, 25.0, 1000.0, 10000.0}) {
      EXPECT_LT(error_of({slabs, density, GetParam()}), 5e-3) << slabs << " slabs of " << density << " kg/m3";
    }
  }
}

TEST_P(SlabsInReservoir, DoSoWithAMeshAndByShisScheme) {
  EXPECT_LT(error_of({.slabs = 2, .density_kg_per_m3 = 100, .schedule = GetParam(), .mesh_size_m = 2}), 0.05);
  EXPECT_LT(error_of({.slabs = 3, .density_kg_per_m3 = 100, .schedule = GetParam(), .integrator = "shi"}), 0.05);
}

INSTANTIATE_TEST_SUITE_P(Schedules, SlabsInReservoir, testing::Values("serial", "parallel", "improved"),
                         [](const auto& with) { return std::string(with.param); });

}  // namespace
}  // namespace blockweir::solid::slabs_in_reservoir_test
