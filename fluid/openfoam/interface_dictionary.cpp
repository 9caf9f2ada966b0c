// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/interface_dictionary.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/results/result_file.hpp"
#include "bridge/scene/cracks.hpp"
#include "bridge/schedule/hello.hpp"
#include "fluid/joints/flow_scene.hpp"
#include "fluid/openfoam/dictionary.hpp"

namespace blockweir::openfoam {
namespace {

std::string blocks(const scene::Scene& scene, const Surroundings& around) {
  std::string text = "blocks\n{\n";
  for (std::size_t b = 0; b < scene.blocks.size(); ++b) {
    const bool ground = around.site.is_ground(b);
    text += fmt::format("    block{}\n    {{\n        name {};\n        vertices {};\n", b,
                        quoted(scene.blocks[b].name), point_list(scene.blocks[b].vertices));
    if (ground) text += fmt::format("        outline {};  // the ground goes on\n", point_list(around.outlines[b]));
    text += fmt::format("        loaded {};\n        movable {};\n    }}\n", ground ? "no" : "yes",
                        scene.blocks[b].fixed ? "no" : "yes");
  }
  return text + "}\n\n";
}

/// Rows for OpenFOAM's table, linear in between.
std::string time_table(const char* key, const std::optional<scene::TimeTable>& table, const scene::Scene& scene) {
  if (!table) return "";
  std::string rows;
  const auto row = [&](double time, double value) { rows += fmt::format(" ({} {})", exact(time), exact(value)); };
  if (table->sine) {
    const double step = scene.coupling.window_s;
    const auto windows = static_cast<long>(std::ceil(scene.analysis.duration_s / step));
    for (long n = 0; n <= windows; ++n) row(static_cast<double>(n) * step, table->at(static_cast<double>(n) * step));
  } else {
    for (std::size_t i = 0; i < table->time_s.size(); ++i) {
      const double just_before = table->time_s[i] - 1e-9 * scene.coupling.window_s;
      if (table->stepwise && i > 0) row(just_before, table->value[i - 1]);
      row(table->time_s[i], table->value[i]);
    }
  }
  return fmt::format("{} table ({} );\n", key, rows);
}

std::string pools(const scene::Scene& scene, const Surroundings& around) {
  std::string text = "// Whose level follows its table: all cells up to, or from, this x [m]\n";
  const auto control = scene.openfoam.level_control;
  text += fmt::format("upstreamTo {};\ndownstreamFrom {};\nsetLevels {};\nopenEnds {};\n",
                      exact(around.site.structure_left_m), exact(around.site.structure_right_m),
                      control == scene::LevelControl::table ? "yes" : "no",
                      control == scene::LevelControl::inflow ? "yes" : "no");
  if (const auto& wave = around.wave) {
    text += fmt::format("wave {{ height {}; period {}; depth {}; }}\n", exact(wave->height_m), exact(wave->period_s),
                        exact(wave->depth_m));
  }
  return text + time_table("upstreamLevel", scene.water.upstream_level_m, scene) +
         time_table("downstreamLevel", scene.water.downstream_level_m, scene) + "\n";
}

/// Of a mesh that moves with the ground.
std::string ground(const scene::Scene& scene) {
  if (!scene.base_motion) return "";
  const auto table = [&](const char* key, const scene::TimeTable& a) { return time_table(key, a, scene); };
  return table("groundAccelerationX", scene.base_motion->acceleration_x_m_per_s2) +
         table("groundAccelerationY", scene.base_motion->acceleration_y_m_per_s2) + "\n";
}

/// A place on a block's outline where water enters a crack, and which way the water lies.
std::string opening(const char* key, int block, const scene::Point& at, const scene::Point& outwards) {
  return fmt::format("        {} {{ block {}; point ({} {}); direction ({} {}); }}\n", key, block, exact(at.x()),
                     exact(at.y()), exact(outwards.x()), exact(outwards.y()));
}

std::string known_heads(const scene::KnownHeads& known) {
  std::string text;
  if (known.drain) {
    text += fmt::format("        drain {{ station {}; efficiency {}; ", exact(known.drain->station_m),
                        exact(known.drain->efficiency));
    if (!std::isnan(known.drain->head_m)) text += fmt::format("head {}; ", exact(known.drain->head_m));
    text += "}\n";
  }
  if (known.piezometers.empty()) return text;
  text += fmt::format("        headsAtLevel {};\n        heads (", exact(known.level_m));
  for (const scene::Piezometer& p : known.piezometers) {
    text += fmt::format(" ({} {})", exact(p.station_m), exact(p.head_m));
  }
  return text + " );\n";
}

std::string bends(const std::vector<scene::Bend>& all) {
  if (all.empty()) return "";
  std::string text = "        bends (";
  for (const scene::Bend& bend : all) text += fmt::format(" ({} {})", exact(bend.station_m), exact(bend.above_m));
  return text + " );\n";
}

/// Panels: block, edge, from and to along the edge, from and to along the crack, all but the first two as fractions.
std::string cracks(const scene::Scene& scene) {
  std::string text = "cracks\n{\n";
  int number = 0;
  for (const scene::Crack& crack : scene::find_cracks(scene)) {
    text += fmt::format("    crack{}\n    {{\n        law {};\n        length {};\n", number++,
                        scene::named(crack.law).name, exact(crack.length_m));
    text += known_heads(crack.known) + bends(crack.bends);
    const auto& first = crack.parts.front();
    const auto& last = crack.parts.back();
    const auto direction = [](const scene::TracePiece& piece) -> scene::Point {
      return (piece.to_m - piece.from_m).normalized();
    };
    text += opening("mouth", first.block_a, first.trace.mouth(), -direction(first.trace.pieces.front()));
    text += opening("end", last.block_a, last.trace.end(), direction(last.trace.pieces.back()));
    text += "        panels\n        (\n";
    double travelled = 0;
    for (const scene::CrackPart& part : crack.parts) {
      for (const scene::TracePiece& piece : part.trace.pieces) {
        const double from = travelled / crack.length_m;
        travelled += (piece.to_m - piece.from_m).norm();
        const double to = travelled / crack.length_m;
        const auto face = [&](int block, int edge, double s_from, double s_to) {
          const bool along = s_from <= s_to;
          text += fmt::format("            ({} {} {} {} {} {})\n", block, edge, exact(along ? s_from : s_to),
                              exact(along ? s_to : s_from), exact(along ? from : to), exact(along ? to : from));
        };
        face(part.block_a, piece.edge_a, piece.s_from_a, piece.s_to_a);
        face(part.block_b, piece.edge_b, piece.s_from_b, piece.s_to_b);
      }
    }
    text += "        );\n    }\n";
  }
  return text + "}\n";
}

}  // namespace

std::string interface_dictionary(const scene::Scene& scene, const Surroundings& around, const std::string& endpoint,
                                 std::uint64_t first_window) {
  const wire::Hello hello = schedule::hello(scene, "openfoam", first_window);
  std::string text = file_header("dictionary", "blockweir");
  text += fmt::format(
      "endpoint {};  // of the solid process; BLOCKWEIR_ENDPOINT in the environment takes precedence\n"
      "timeout {};\nopenTimeout {};\n\n"
      "sceneDigest {};\nschedule {};\nunits {};\nwindow {};\nduration {};\nfirstWindow {};\nstepsPerWindow "
      "{};\nmaxCourant {};\nwaterDensity {};\ngravity {};\ndepth {};\nopenCrackWidth {};\nmoveTolerance "
      "{};\nrestTolerance {};\n\n",
      quoted(endpoint), exact(scene.coupling.timeout_s), exact(scene.coupling.open_timeout_s),
      quoted(hello.scene_digest), quoted(hello.schedule), quoted(hello.units), exact(hello.window_s),
      exact(hello.duration_s), hello.first_window, scene.openfoam.steps_per_window, exact(scene.openfoam.max_courant),
      exact(scene.water.density_kg_per_m3), exact(scene.analysis.gravity_m_per_s2), exact(around.depth_m),
      exact(scene.water.open_crack_width_m), exact(scene.openfoam.move_tolerance),
      exact(scene.openfoam.rest_tolerance));
  text += around.cell_m ? fmt::format("cell {};\n\n", exact(*around.cell_m))
                        : "ownCase yes;  // not written from the scene\n\n";
  if (scene::flows_in_joints(scene)) text += "flowInJoints yes;  // constant/blockweirJoints\n\n";
  return text + pools(scene, around) + ground(scene) + blocks(scene, around) + cracks(scene);
}

void write_interface(const std::filesystem::path& folder, const scene::Scene& scene, const Surroundings& around,
                     const std::string& endpoint, std::uint64_t first_window) {
  if (scene::flows_in_joints(scene)) {
    results::replace_file(folder / "constant/blockweirJoints", joints::pack({scene, joints::ground_cut(scene)}));
  }
  results::replace_file(folder / "constant/blockweir", interface_dictionary(scene, around, endpoint, first_window));
}

}  // namespace blockweir::openfoam
