// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_reservoir fmt::fmt
// What a window costs of a reservoir of 100 m beside a dam whose blocks move in each: with the mesh kept, with one
// whose nodes follow the dam, with a mesh of its own, and stage by stage. The upstream face is of rough stone: so many
// wet faces, on so many blocks above each other. Least processor time of so many turns, on one thread. Arguments: faces
// (1,000), turns (9), blocks (1, 10 and 100).
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <vector>

#include "fluid/reservoir/pressure_equation.hpp"
#include "fluid/reservoir/reservoir_model.hpp"
#include "fluid/reservoir/scene_water.hpp"

namespace {

using namespace blockweir;

constexpr double height_m = 100;
constexpr double rough_m = 0.02;  // by as much every other corner is set back

scene::Scene dam(int blocks, int faces) {
  scene::Scene scene;
  scene.materials.push_back({"stone", 30e9, 0.2, 2400});
  scene::Block rock;
  rock.name = "rock";
  rock.fixed = true;
  rock.vertices = {{-100, -20}, {200, -20}, {200, 0}, {-100, 0}};
  scene.blocks.push_back(rock);
  const auto corner = [&](int i) { return scene::Point(i % 2 == 0 ? 0 : rough_m, height_m * i / faces); };
  for (int b = 0; b < blocks; ++b) {
    const int from = b * faces / blocks;
    const int to = (b + 1) * faces / blocks;
    scene::Block block;
    block.name = fmt::format("b{}", b);
    block.vertices = {{80, corner(from).y()}, {80, corner(to).y()}};
    for (int i = to; i >= from; --i) block.vertices.push_back(corner(i));
    scene.blocks.push_back(block);
  }
  scene.fluid = scene::FluidModel::reservoir;
  scene.water.upstream_level_m = scene::TimeTable::constant(height_m);
  scene.water.elements_per_face = 1;
  return scene;
}

double least_ms(int turns, const std::function<void()>& prepare, const std::function<void()>& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < turns; ++i) {
    prepare();
    const std::clock_t begin = std::clock();
    work();
    least = std::min(least, 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return least;
}

void print(const char* what, double ms) {
  fmt::print("  {:<38} {:9.3f} ms\n", what, ms);
}

void measure(int blocks, int faces, int turns) {
  const scene::Scene scene = dam(blocks, faces);
  wire::Motion motion;
  motion.displacement.own().resize(scene.blocks.size());
  motion.velocity.own().resize(scene.blocks.size());
  int turn = 0;
  const auto move_by = [&](double most_m) {
    ++turn;
    for (std::size_t b = 1; b < scene.blocks.size(); ++b) {
      const double share = static_cast<double>((b * 7919 + static_cast<std::size_t>(turn) * 31) % 13) / 13;
      motion.displacement.own()[b][0] = -most_m * ((turn % 2) + share) / 2;
      motion.velocity.own()[b][0] = 0.1 * share;
    }
  };
  const auto a_little = [&] { move_by(1e-5); };
  const auto far = [&] { move_by(1); };  // a hundredth of the depth: the mesh is for a thousandth
  const auto slide = [&] {               // as one: other faces do not become wet
    ++turn;
    for (std::size_t b = 1; b < scene.blocks.size(); ++b) motion.displacement.own()[b][0] = -0.2 * (turn % 20);
  };
  double time_s = 0;
  wire::Load load;
  reservoir::ReservoirModel water(scene);
  const auto window = [&] { water.advance(motion, time_s += 0.01, load); };
  window();
  fmt::print("{} faces on {} blocks: {} panels of load\n", faces, blocks, load.block.size());
  print("a window, mesh kept", least_ms(turns, a_little, window));
  print("a window, mesh moved", least_ms(turns, slide, window));
  scene::Scene unmoved = scene;
  unmoved.reservoir.move_tolerance = 0;
  reservoir::ReservoirModel afresh(unmoved);
  print("a window, meshed anew", least_ms(turns, far, [&] { afresh.advance(motion, time_s += 0.01, load); }));
  hydrostatic::HydrostaticModel still(scene);
  const auto stand = [&] { still.advance(motion, time_s += 0.01, load); };
  print("still water", least_ms(turns, a_little, stand));
  const hydrostatic::WaterBody& body = still.bodies().front();
  reservoir::WaterMesh mesh;
  const double meshing = least_ms(
      turns, [] {}, [&] { mesh = reservoir::mesh_of(scene, body, {still.outlines()}); });
  print(fmt::format("mesh: {} nodes, {} triangles", mesh.node.size(), mesh.triangle.size()).c_str(), meshing);
  const std::vector<bool> ground(scene.blocks.size(), false);
  print("matrix and factors",
        least_ms(
            turns, [] {}, [&] { reservoir::PressureEquation(mesh, reservoir::physics_of(scene), ground, 0.01); }));
}

}  // namespace

int main(int argc, char** argv) {
  const int faces = argc > 1 ? std::atoi(argv[1]) : 1000;
  const int turns = argc > 2 ? std::atoi(argv[2]) : 9;
  const std::vector<int> blocks = argc > 3 ? std::vector{std::atoi(argv[3])} : std::vector{1, 10, 100};
  for (const int count : blocks) measure(count, faces, turns);
}
