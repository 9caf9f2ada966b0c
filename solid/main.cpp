// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir-solid: the DDA solid as a process of its own.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>

#include "bridge/channel/line_options.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/scene/exit_status.hpp"
#include "bridge/scene/read.hpp"
#include "bridge/schedule/hello.hpp"
#include "bridge/schedule/run.hpp"
#include "solid/output/recorder.hpp"

namespace {

using namespace blockweir;
using Clock = std::chrono::steady_clock;

struct Arguments {
  std::string scene;
  std::string folder;
  channel::Options line{.side = channel::Side::listens};
  std::vector<std::string> overrides;
  int progress_fd = -1;
  std::uint64_t resume = 0;
};

/// At most twenty reports a second: lines "time_s level_m largest_displacement_m" on a pipe, or text for people.
auto progress_to(int fd, double duration_s) {
  return [fd, duration_s, last = Clock::time_point(), silent = false](double time_s, double level_m,
                                                                      double displacement_m) mutable {
    if (silent) return;
    const auto now = Clock::now();
    if (now - last < std::chrono::milliseconds(fd >= 0 ? 50 : 2000) && time_s < duration_s) return;
    last = now;
    if (fd < 0) {
      fmt::print(stderr, "{:.4g} of {:.4g} s, level {:.4g} m, largest displacement {:.3g} m\n", time_s, duration_s,
                 level_m, displacement_m);
      return;
    }
    const std::string line = fmt::format("{:.9g} {:.9g} {:.9g}\n", time_s, level_m, displacement_m);
    silent = silent || ::write(fd, line.data(), line.size()) < 0;  // nobody listens any more: go on without
  };
}

void run(Arguments& arguments) {
  const auto start = Clock::now();
  const scene::Scene scene = scene::read(arguments.scene, arguments.overrides).scene;
  if (scene.fluid != scene::FluidModel::none && arguments.line.endpoint.empty()) {
    throw std::invalid_argument("the scene has water: say with --endpoint where to listen for the fluid process");
  }
  channel::catch_stop_signals();
  results::make_folder(arguments.folder);
  const std::uint64_t first = arguments.resume;
  checkpoint::Checkpoints checkpoints(arguments.folder, "solid", scene.digest, scene.output.checkpoint_every_s);
  if (first == 0) checkpoint::forget(arguments.folder);
  solid::output::Recorder recorder(scene, arguments.folder,
                                   first == 0 ? results::Begin::anew : results::Begin::where_it_stopped,
                                   progress_to(arguments.progress_fd, scene.analysis.duration_s));
  schedule::ExchangeTime exchange;
  double connected_s = 0;
  const auto finish = [&](const std::string& stopped) {
    const std::chrono::duration<double> total = Clock::now() - start;
    recorder.finish({{"wall_time_s", total.count()},
                     {"profile_s",
                      {{"start_up", connected_s},
                       {"wait_for_fluid", exchange.wait_s},
                       {"pack", exchange.pack_s},
                       {"wire", exchange.wire_s}}}},
                    stopped);
  };
  try {
    if (scene.fluid == scene::FluidModel::none) {
      schedule::run_solid(nullptr, scene, checkpoints, first, recorder);
    } else {
      arguments.line.partner = fmt::format("fluid process ({})", scene::name(scene.fluid));
      arguments.line.timeout_s = scene.coupling.timeout_s;
      arguments.line.open_timeout_s = scene.coupling.open_timeout_s;
      channel::Channel channel(arguments.line);
      channel.handshake(schedule::hello(scene, "solid", first));
      connected_s = std::chrono::duration<double>(Clock::now() - start).count();
      const double waited_before = channel.waited_s();
      exchange = schedule::run_solid(&channel, scene, checkpoints, first, recorder);
      exchange.wait_s -= waited_before;
    }
  } catch (const std::exception& error) {
    finish(error.what());
    throw;
  }
  finish("");
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app{"blockweir-solid: blocks of a scene, moved by discontinuous deformation analysis"};
  app.add_option("scene", arguments.scene, "scene file or case folder")->required();
  app.add_option("--out", arguments.folder, "folder for the results")->required();
  channel::add_line_options(app, arguments.line);
  app.add_option("--set", arguments.overrides, "key=value over the scene's own; the same for both processes");
  app.add_option("--resume", arguments.resume, "number of the checkpoint in --out to go on from; the same for both");
  app.add_option("--progress-fd", arguments.progress_fd, "file descriptor for progress lines");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return scene::exit_status("blockweir-solid", [&] {
    run(arguments);
    return 0;
  });
}
