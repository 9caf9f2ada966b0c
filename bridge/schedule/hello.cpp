// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/schedule/hello.hpp"

namespace blockweir::schedule {
namespace {

const char* name(scene::Schedule schedule) {
  switch (schedule) {
    case scene::Schedule::parallel:
      return "parallel";
    case scene::Schedule::improved:
      return "improved";
    case scene::Schedule::serial:
      break;
  }
  return "serial";
}

}  // namespace

wire::Hello hello(const scene::Scene& scene, const std::string& role, std::uint64_t first_window) {
  wire::Hello hello;
  hello.role = role;
  hello.build = BLOCKWEIR_VERSION;
  hello.scene_digest = scene.digest;
  hello.schedule = name(scene.coupling.schedule);
  hello.first_window = first_window;
  hello.units = "SI per metre";
  hello.window_s = scene.coupling.window_s;
  hello.duration_s = scene.analysis.duration_s;
  for (const scene::Block& block : scene.blocks) {
    hello.block_names.push_back(block.name);
    hello.vertex_counts.push_back(static_cast<std::uint32_t>(block.vertices.size()));
    for (const scene::Point& p : block.vertices) {
      hello.vertices_m.push_back(p.x());
      hello.vertices_m.push_back(p.y());
    }
  }
  return hello;
}

}  // namespace blockweir::schedule
