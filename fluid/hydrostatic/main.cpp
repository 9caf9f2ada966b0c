// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir-hydrostatic: the reference fluid as a process of its own.
#include "bridge/channel/line_options.hpp"
#include "bridge/scene/exit_status.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/schedule/hello.hpp"
#include "bridge/schedule/processes.hpp"
#include "bridge/schedule/run.hpp"

int main(int argc, char** argv) {
  using namespace blockweir;
  std::string path;
  std::string report;
  std::vector<std::string> overrides;
  std::string folder;
  std::uint64_t resume = 0;
  channel::Options line{.side = channel::Side::connects, .partner = "solid process"};
  CLI::App app{"blockweir-hydrostatic: still water that presses on the blocks of a scene"};
  app.add_option("scene", path, "scene file or case folder")->required();
  channel::add_line_options(app, line)->required();
  app.add_option("--out", folder,
                 "folder for checkpoints, and for the reservoir's mesh where [output] reservoir is true");
  app.add_option("--set", overrides, "key=value over the scene's own; the same for both processes");
  app.add_option("--resume", resume, "number of the checkpoint in --out to go on from; the same for both");
  app.add_option("--report", report, "file for this process's times and counts (JSON)");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return scene::exit_status("blockweir-hydrostatic", [&] {
    const scene::Scene scene = scene::read(path, overrides).scene;
    const auto fluid = schedule::make_hydrostatic(scene, folder);
    channel::catch_stop_signals();
    line.timeout_s = scene.coupling.timeout_s;
    line.open_timeout_s = scene.coupling.open_timeout_s;
    channel::Channel channel(line);
    channel.handshake(schedule::hello(scene, "hydrostatic", resume));
    checkpoint::Checkpoints checkpoints(folder, "hydrostatic", scene.digest, 0);
    const schedule::FluidReport said = schedule::run_fluid(channel, checkpoints, resume, *fluid);
    if (!report.empty()) schedule::write_report(report, said);
    return 0;
  });
}
