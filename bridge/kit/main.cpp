// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir-dummy: replaces the solid, to test a fluid alone. Blocks move as the command line says.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/channel/handshake.hpp"
#include "bridge/process/program.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/schedule/hello.hpp"
#include "bridge/schedule/turn.hpp"
#include "bridge/statics/loads.hpp"

namespace {

using namespace blockweir;

struct Options {
  std::string scene;
  std::vector<std::string> overrides;
  std::vector<std::string> moves;
  std::uint64_t windows = 0;
  std::uint64_t save_every = 0;
  std::uint64_t resume = 0;
  channel::Options line{.side = channel::Side::listens, .partner = "fluid"};
};

/// Velocities (u, v [m/s], turn [rad/s]) of all blocks, from BLOCK=U,V,TURN each.
std::vector<std::array<double, 6>> velocities_of(const scene::Scene& scene, const std::vector<std::string>& moves) {
  std::vector<std::array<double, 6>> all(scene.blocks.size());
  for (const std::string& move : moves) {
    const std::size_t equals = move.rfind('=');
    const std::string name = move.substr(0, equals);
    const auto block =
        std::find_if(scene.blocks.begin(), scene.blocks.end(), [&](const scene::Block& b) { return b.name == name; });
    double u = 0;
    double v = 0;
    double turn = 0;
    char rest = 0;
    const bool read = equals != std::string::npos &&
                      std::sscanf(move.c_str() + equals + 1, "%lf,%lf,%lf%c", &u, &v, &turn, &rest) == 3;
    if (block == scene.blocks.end() || !read || !std::isfinite(u + v + turn)) {
      throw std::invalid_argument(fmt::format(
          "--move: found \"{}\"; expected BLOCK=U,V,TURN, the name of a block of the scene and three numbers, its "
          "velocities in m/s and rad/s; correct it",
          move));
    }
    all[static_cast<std::size_t>(block - scene.blocks.begin())] = {u, v, turn, 0, 0, 0};
  }
  return all;
}

void require_blocks(const scene::Scene& scene, const wire::Load& load, const std::string& fluid) {
  for (std::size_t i = 0; i < load.block.size(); ++i) {
    if (load.block[i] < scene.blocks.size() && load.edge[i] < scene.blocks[load.block[i]].vertices.size()) continue;
    throw channel::PartnerFault(fmt::format("{} loads block {}, edge {} in window {}, which the scene does not have",
                                            fluid, load.block[i], load.edge[i], load.window));
  }
}

void print(const scene::Scene& scene, const wire::Load& load) {
  const statics::Wrenches forces = statics::water_forces(scene, load);
  for (std::size_t b = 0; b < forces.size(); ++b) {
    const auto panels = std::count(load.block.begin(), load.block.end(), b);
    fmt::print("{},{:.9g},{:.9g},{},{},{:.9g},{:.9g},{:.9g}\n", load.window, load.time_s, load.upstream_level_m,
               scene.blocks[b].name, panels, forces[b].x(), forces[b].y(), forces[b].z());
  }
}

void exchange(channel::Channel& line, const std::string& fluid, const scene::Scene& scene, const Options& options) {
  const double window_s = scene.coupling.window_s;
  const auto last = static_cast<std::uint64_t>(std::ceil(scene.analysis.duration_s / window_s - 1e-9));
  const std::uint64_t end = options.resume + (options.windows > 0 ? options.windows : last + 1);
  const auto velocities = velocities_of(scene, options.moves);
  wire::Motion motion;
  wire::Load load;
  fmt::print("window,time_s,upstream_level_m,block,panels,force_x_n_per_m,force_y_n_per_m,moment_n\n");
  for (std::uint64_t window = options.resume; window < end; ++window) {
    motion.window = window;
    motion.time_s = std::min(static_cast<double>(window) * window_s, scene.analysis.duration_s);
    const bool saves = options.save_every > 0 && window > options.resume && window % options.save_every == 0;
    motion.order = saves ? wire::Order::save_and_compute : wire::Order::compute;
    motion.velocity = velocities;
    auto& displacement = motion.displacement.own();
    displacement = velocities;
    for (auto& row : displacement) {
      for (double& number : row) number *= motion.time_s;
    }
    line.send(motion);
    line.receive(load);
    schedule::require_turn(load.window, window, fluid);
    require_blocks(scene, load, fluid);
    print(scene, load);
  }
  line.send(wire::Farewell{"the run is complete"});
}

int run(Options& options) {
  const scene::Scene scene = scene::read(options.scene, options.overrides).scene;
  (void)velocities_of(scene, options.moves);  // before anybody waits
  options.line.timeout_s = scene.coupling.timeout_s;
  options.line.open_timeout_s = scene.coupling.open_timeout_s;
  channel::Channel line(options.line);
  const wire::Hello theirs = line.handshake(schedule::hello(scene, "solid", options.resume));
  const std::string fluid = fmt::format("fluid \"{}\"", channel::printable(theirs.role));
  line.call_partner(fluid);
  try {
    exchange(line, fluid, scene, options);
  } catch (const channel::PartnerFault& fault) {
    line.send(wire::Failure{fault.what()});
    throw;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr auto required = process::ProgramOption::Use::required;
  Options options;
  const process::Program program{
      "blockweir-dummy",
      "stands in for the solid, so that a fluid can be tested alone; prints its forces (CSV)",
      {{{"scene", &options.scene, "scene file or case folder", required}},
       process::connection_options(options.line, required),
       {{"--set", &options.overrides, "set a key of the scene, as key=value"},
        {"--move", &options.moves, "BLOCK=U,V,TURN: the block's velocities, in m/s and rad/s; others rest"},
        {"--windows", &options.windows, "number of motions (default: all of the scene's duration)"},
        {"--save-every", &options.save_every, "the fluid is told to save its state every so many windows"},
        {"--resume", &options.resume, "begin with the motion of this number, as a resumed run does"}}}};
  return process::run_program(argc, argv, program, [&] { return run(options); });
}
