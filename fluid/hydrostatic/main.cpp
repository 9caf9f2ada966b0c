// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir-hydrostatic: the reference fluid as a process of its own.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "bridge/channel/line_options.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/scene/exit_status.hpp"
#include "bridge/scene/read.hpp"
#include "bridge/schedule/hello.hpp"
#include "bridge/schedule/run.hpp"
#include "fluid/hydrostatic/reservoir_output.hpp"

namespace {

using namespace blockweir;

struct Arguments {
  std::string scene;
  channel::Options line{.side = channel::Side::connects, .partner = "solid process"};
  std::string profile_out;
  std::string folder;
  std::vector<std::string> overrides;
  std::uint64_t resume = 0;
};

void write_profile(const std::string& path, const hydrostatic::HydrostaticModel& model,
                   const hydrostatic::RecordedModel* recorded, schedule::ExchangeTime exchange, double total_s) {
  const double output_s = recorded != nullptr ? recorded->output_s() : 0;
  const nlohmann::json profile = {
      {"seconds",
       {{"wait", exchange.wait_s},
        {"pack", exchange.pack_s},
        {"wire", exchange.wire_s},
        {"output", output_s},
        {"pressure", total_s - exchange.wait_s - exchange.pack_s - exchange.wire_s - output_s}}},
      {"counts",
       {{"updates", model.updates()},
        {"unchanged", model.unchanged()},
        {"meshes", recorded != nullptr ? recorded->meshes() : 0}}}};
  std::ofstream(path) << profile.dump(2) << '\n';
}

void run(Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  const scene::Scene scene = scene::read(arguments.scene, arguments.overrides).scene;
  if (scene.output.reservoir && arguments.folder.empty()) {
    throw std::invalid_argument("[output] reservoir = true: say with --out where its files shall go");
  }
  if (scene.output.reservoir) results::make_folder(arguments.folder);
  checkpoint::Checkpoints checkpoints(arguments.folder, "hydrostatic", scene.digest, 0);
  channel::catch_stop_signals();
  arguments.line.timeout_s = scene.coupling.timeout_s;
  arguments.line.open_timeout_s = scene.coupling.open_timeout_s;
  channel::Channel channel(arguments.line);
  channel.handshake(schedule::hello(scene, "hydrostatic", arguments.resume));
  hydrostatic::HydrostaticModel model(scene);
  std::optional<hydrostatic::RecordedModel> recorded;
  if (scene.output.reservoir) recorded.emplace(model, scene, arguments.folder);
  schedule::FluidSide& fluid = recorded ? static_cast<schedule::FluidSide&>(*recorded) : model;
  const auto exchange = schedule::run_fluid(channel, checkpoints, arguments.resume, fluid);
  if (arguments.profile_out.empty()) return;
  const std::chrono::duration<double> total = std::chrono::steady_clock::now() - start;
  write_profile(arguments.profile_out, model, recorded ? &*recorded : nullptr, exchange, total.count());
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app{"blockweir-hydrostatic: still water that presses on the blocks of a scene"};
  app.add_option("scene", arguments.scene, "scene file or case folder")->required();
  channel::add_line_options(app, arguments.line)->required();
  app.add_option("--out", arguments.folder,
                 "folder for checkpoints, and for the reservoir's mesh where [output] reservoir is true");
  app.add_option("--set", arguments.overrides, "key=value over the scene's own; the same for both processes");
  app.add_option("--resume", arguments.resume, "number of the checkpoint in --out to go on from; the same for both");
  app.add_option("--profile-out", arguments.profile_out, "file for this process's times (JSON)");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return scene::exit_status("blockweir-hydrostatic", [&] {
    run(arguments);
    return 0;
  });
}
