// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/fluid_program.hpp"

#include "bridge/process/program.hpp"
#include "bridge/process/require_fluid.hpp"
#include "bridge/scene/fluid_models.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/schedule/hello.hpp"
#include "bridge/schedule/run.hpp"

namespace blockweir::process {
namespace {

struct Options {
  std::string scene;
  std::string folder;
  std::string report;
  std::vector<std::string> overrides;
  std::uint64_t resume = 0;
  channel::Options line{.side = channel::Side::connects, .partner = "solid process"};
};

int run(Options& options, const scene::FluidEntry& entry, const FluidMaker& make) {
  const scene::Scene scene = scene::read(options.scene, options.overrides).scene;
  require_fluid(scene, entry.model);
  const auto fluid = make(scene, options.folder);
  channel::catch_stop_signals();
  options.line.timeout_s = scene.coupling.timeout_s;
  options.line.open_timeout_s = scene.coupling.open_timeout_s;
  channel::Channel channel(options.line);
  channel.handshake(schedule::hello(scene, entry.role, options.resume));
  checkpoint::Checkpoints checkpoints(options.folder, entry.role, scene.digest, 0);
  schedule::FluidReport said;
  const auto report = [&] {
    if (!options.report.empty()) schedule::write_report(options.report, said);
  };
  try {
    said = schedule::run_fluid(channel, checkpoints, options.resume, *fluid);
  } catch (...) {
    said = fluid->report();  // what it has to warn of holds for a run that was stopped, too
    report();
    throw;
  }
  report();
  return 0;
}

}  // namespace

int run_fluid_program(int argc, char** argv, scene::FluidModel model, const FluidMaker& make) {
  const scene::FluidEntry& entry = scene::fluid_entry(model);
  Options options;
  constexpr auto required = ProgramOption::Use::required;
  const Program program{
      entry.program,
      entry.about,
      {{{"scene", &options.scene, "scene file or case folder", required}},
       connection_options(options.line, required),
       {{"--out", &options.folder, "folder for checkpoints and pictures"},
        {"--set", &options.overrides, "set a key of the scene, as key=value; the same for both processes"},
        {"--resume", &options.resume,
         "continue from the checkpoint of this number in --out; the same for both processes"},
        {"--report", &options.report, "file for this process's times and counts (JSON)"}}}};
  return run_program(argc, argv, program, [&] { return run(options, entry, make); });
}

}  // namespace blockweir::process
