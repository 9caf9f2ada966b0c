// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir-column: a pipe of water as a process of its own. Whoever writes a new fluid begins with a copy of this.
#include <CLI/CLI.hpp>

#include "bridge/channel/line_options.hpp"
#include "bridge/scene/exit_status.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/schedule/hello.hpp"
#include "bridge/schedule/run.hpp"
#include "fluid/column/column.hpp"

int main(int argc, char** argv) {
  using namespace blockweir;
  std::string path;
  channel::Options line{.side = channel::Side::connects, .partner = "solid process"};
  std::string folder;
  std::string report;
  std::vector<std::string> overrides;
  std::uint64_t resume = 0;
  CLI::App app{"blockweir-column: a pipe of water at the edge of a block"};
  app.add_option("scene", path, "scene file or case folder")->required();
  channel::add_line_options(app, line)->required();
  app.add_option("--out", folder, "folder for checkpoints");
  app.add_option("--set", overrides, "key=value over the scene's own; the same for both processes");
  app.add_option("--resume", resume, "number of the checkpoint in --out to go on from; the same for both");
  app.add_option("--report", report, "file for this process's times (JSON)");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return scene::exit_status("blockweir-column", [&] {
    const scene::Scene scene = scene::read(path, overrides).scene;
    if (scene.fluid != scene::FluidModel::column) throw std::invalid_argument("the scene's fluid is not a column");
    channel::catch_stop_signals();
    line.timeout_s = scene.coupling.timeout_s;
    line.open_timeout_s = scene.coupling.open_timeout_s;
    channel::Channel channel(line);
    channel.handshake(schedule::hello(scene, "column", resume));
    column::Column column(scene);
    checkpoint::Checkpoints checkpoints(folder, "column", scene.digest, 0);
    const schedule::FluidReport said = schedule::run_fluid(channel, checkpoints, resume, column);
    if (!report.empty()) schedule::write_report(report, said);
    return 0;
  });
}
