// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic fmt::fmt
// What a window costs of the water that flows through a wall of bricks: nothing moved, apertures changed a little with
// the factor of before and with a new one, and the network alone. Medians. Arguments: number of joints (10,000), turns
// (9).
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <vector>

#include "fluid/hydrostatic/hydrostatic_model.hpp"

namespace {

using namespace blockweir;

/// Rows of bricks of 1 m by 0.5 m, every other row half a brick off, on rock; a joint has two stretches or three.
scene::Scene wall(int joints) {
  scene::Scene scene;
  scene.materials.push_back({"stone", 30e9, 0.2, 2400});
  const auto add = [&](double left, double low, double right, double high) {
    scene::Block block;
    block.name = fmt::format("b{}", scene.blocks.size());
    block.vertices = {{left, low}, {right, low}, {right, high}, {left, high}};
    scene.blocks.push_back(block);
  };
  const int columns = 40;
  const int rows = joints / (3 * columns);
  add(-50, -5, columns + 50, 0);
  scene.blocks[0].fixed = true;
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i <= columns; ++i) {
      const double shift = row % 2 == 0 ? 0 : 0.5;
      const double left = std::max(0.0, i - shift);
      const double right = std::min<double>(columns, i + 1 - shift);
      if (right > left) add(left, row * 0.5, right, row * 0.5 + 0.5);
    }
  }
  scene.default_joint.uplift = scene::Uplift::flow;
  scene.water.upstream_level_m = scene::TimeTable::constant(0.5 * rows);
  scene.water.elements_per_face = 1;
  return scene;
}

double median_ms(int turns, const std::function<void()>& prepare, const std::function<void()>& work) {
  std::vector<double> times;
  for (int i = 0; i < turns; ++i) {
    prepare();
    const auto begin = std::chrono::steady_clock::now();
    work();
    times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  const int joints = argc > 1 ? std::atoi(argv[1]) : 10'000;
  const int turns = argc > 2 ? std::atoi(argv[2]) : 9;
  const scene::Scene scene = wall(joints);
  hydrostatic::HydrostaticModel model(scene);
  wire::Motion motion;
  motion.displacement.own().resize(scene.blocks.size());
  motion.velocity.own().resize(scene.blocks.size());
  wire::Load load;
  double time_s = 0;
  model.advance(motion, time_s, load);
  const auto& network = model.flow_in_joints().joints().network();
  fmt::print("{} blocks, {} stretches of joint, {} channels, {} nodes\n", scene.blocks.size(),
             model.flow_in_joints().joints().stretches().size(), network.channels.size(), network.nodes.size());
  int turn = 0;
  const auto open_a_little = [&] {
    ++turn;
    for (std::size_t b = 1; b < scene.blocks.size(); ++b) {
      motion.displacement.own()[b][1] = 1e-8 * static_cast<double>((b * 7919U + static_cast<std::size_t>(turn)) % 13);
    }
  };
  const auto window = [&] { model.advance(motion, time_s += 0.01, load); };
  fmt::print("a window, nothing has moved        {:8.3f} ms\n", median_ms(
                                                                    turns, [] {}, window));
  fmt::print("a window, all blocks have moved    {:8.3f} ms\n", median_ms(turns, open_a_little, window));
  joints::Network own = network;
  joints::NetworkFlow flow({});
  joints::Filling filling;
  flow.steady(own, filling);
  const auto widen = [&] {
    ++turn;
    for (std::size_t c = 0; c < own.channels.size(); ++c) {
      own.channels[c].aperture_m[0] *= 1 + 1e-5 * static_cast<double>((c + static_cast<std::size_t>(turn)) % 3);
    }
  };
  const auto solve = [&] { flow.steady(own, filling); };
  fmt::print("the network, factor of before      {:8.3f} ms\n", median_ms(turns, widen, solve));
  const auto solve_anew = [&] { joints::NetworkFlow({}).steady(own, filling); };
  fmt::print("the network, a new factor          {:8.3f} ms\n", median_ms(turns, widen, solve_anew));
  for (joints::Node& node : own.nodes) {
    if (node.kind == joints::NodeKind::held) node.pressure_pa += 1e6;  // all of it is full
  }
  flow.steady(own, filling = {});
  fmt::print("all joints full, factor of before  {:8.3f} ms\n", median_ms(turns, widen, solve));
  fmt::print("all joints full, a new factor      {:8.3f} ms\n", median_ms(turns, widen, solve_anew));
}
