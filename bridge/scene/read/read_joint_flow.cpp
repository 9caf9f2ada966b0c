// SPDX-License-Identifier: GPL-3.0-or-later
// The water that flows through joints: its own keys, its drains and its grout, and whether these lie in such a joint.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/geometry/crossing.hpp"
#include "bridge/geometry/outline.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/cracks.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {
namespace {

const Range share{[](double s) { return s >= 0 && s <= 1; }, "a number from 0 to 1"};

void refuse_without_flow(Reading& reading, TableReader& table) {
  if (!table.present() || flows_in_joints(reading.scene)) return;
  reading.problems.error(table.place(), fmt::format("{} has no effect: no water flows through a joint", table.name()),
                         "uplift = \"flow\" in [joint] or in a [[joints]]",
                         fmt::format("state it, or leave {} out", table.name()));
}

bool crosses(const Point& from, const Point& to, const TracePiece& piece) {
  return geometry::crossing({piece.from_m, piece.to_m}, {from, to}).has_value();
}

void read_drains(Reading& reading) {
  reading.each("drain", [&](TableReader& table) {
    DrainLine drain;
    drain.line = table.place().line;
    table.text("name", drain.name, true);
    table.point("from_m", drain.from_m, true);
    table.point("to_m", drain.to_m, true);
    table.number("head_m", drain.head_m);
    table.number("efficiency", drain.efficiency, share);
    refuse_without_flow(reading, table);
    const auto& others = reading.scene.joint_flow.drains;
    if (std::any_of(others.begin(), others.end(), [&](const DrainLine& d) { return d.name == drain.name; })) {
      refuse_second(reading, table.place("name"), "drain", drain.name, {"drain"});
    }
    reading.scene.joint_flow.drains.push_back(std::move(drain));
  });
}

void read_grouts(Reading& reading) {
  reading.each("grout", [&](TableReader& table) {
    Grout grout;
    grout.line = table.place().line;
    table.text("name", grout.name, true);
    table.points("outline_m", grout.outline_m);
    table.number("aperture_factor", grout.aperture_factor, positive(), true);
    refuse_without_flow(reading, table);
    const auto& others = reading.scene.joint_flow.grouts;
    if (std::any_of(others.begin(), others.end(), [&](const Grout& g) { return g.name == grout.name; })) {
      refuse_second(reading, table.place("name"), "grout", grout.name, {"grout"});
    }
    reading.scene.joint_flow.grouts.push_back(std::move(grout));
  });
}

void check_apertures(Reading& reading, const std::string& whose, const JointLaw& law) {
  if (law.uplift != Uplift::flow) return;
  const double least_m = law.least_aperture_m.value_or(0);
  const double largest_m = law.largest_aperture_m.value_or(reading.scene.water.open_crack_width_m);
  const auto refuse = [&](const char* key, double found, const std::string& expected) {
    reading.problems.error(reading.problems.at(law.known_heads.line),
                           fmt::format("{} of {} is {} m", key, whose, found), expected,
                           "correct the one or the other");
  };
  if (largest_m > reading.scene.water.open_crack_width_m) {
    refuse("largest_aperture_m", largest_m,
           fmt::format("at most open_crack_width_m of [water], {} m, from which on open water comes in",
                       reading.scene.water.open_crack_width_m));
  }
  if (law.hydraulic_aperture_m > largest_m) {
    refuse("hydraulic_aperture_m", law.hydraulic_aperture_m, fmt::format("at most the largest one, {} m", largest_m));
  }
  if (least_m > law.hydraulic_aperture_m) {
    refuse("least_aperture_m", least_m, fmt::format("at most hydraulic_aperture_m, {} m", law.hydraulic_aperture_m));
  }
}

/// The highest that either pool stands at within the run [m].
double highest_level(const Scene& scene) {
  double highest_m = -std::numeric_limits<double>::infinity();
  for (const auto* level : {&scene.water.upstream_level_m, &scene.water.downstream_level_m}) {
    if (!*level) continue;
    const TimeTable& table = **level;
    const double duration_s = scene.analysis.duration_s;
    double high = std::max(table.rows_at(0), table.rows_at(duration_s));
    for (std::size_t i = 0; i < table.time_s.size(); ++i) {
      if (table.time_s[i] >= 0 && table.time_s[i] <= duration_s) high = std::max(high, table.value[i]);
    }
    highest_m = std::max(highest_m, high + (table.sine ? std::abs(table.sine->amplitude) : 0));
  }
  return highest_m;
}

void warn_of_idle_drain(Reading& reading, const DrainLine& drain) {
  const Place place = reading.problems.at(drain.line);
  if (drain.efficiency == 0) {
    reading.problems.warning(place, fmt::format("drain \"{}\" has an efficiency of 0: it takes nothing", drain.name),
                             "an efficiency above 0", "state one, or leave the drain out");
  }
  const double highest_m = highest_level(reading.scene);
  if (!drain.head_m || *drain.head_m < highest_m || std::isinf(highest_m)) return;
  reading.problems.warning(
      place,
      fmt::format("drain \"{}\" drains to a head of {} m, and no level is above {:.6g} m: it takes nothing", drain.name,
                  *drain.head_m, highest_m),
      "a head below the reservoir's level", "state the height of the gallery on the y axis");
}

/// The fluid receives only the mean motion of a mesh.
void refuse_mesh(Reading& reading, const Block& block, const std::string& joint) {
  if (block.mesh_size_m == 0 || reading.problems.full()) return;
  reading.problems.error(
      reading.problems.at(block.line),
      fmt::format("block \"{}\" has a mesh, and water flows through its joint \"{}\"", block.name, joint),
      "blocks without a mesh at joints with uplift = \"flow\"",
      "leave out its mesh_size_m, or cut it into blocks, or state another uplift");
}

}  // namespace

void read_joint_flow(Reading& reading) {
  TableReader table(reading.problems, reading.section("joint_flow"), "[joint_flow]");
  JointFlow& flow = reading.scene.joint_flow;
  table.choice<FlowKind>("kind", flow.kind, {{"steady", FlowKind::steady}, {"transient", FlowKind::transient}});
  table.number("viscosity_pa_s", flow.viscosity_pa_s, positive());
  table.number("bulk_modulus_pa", flow.bulk_modulus_pa, positive());
  table.integer("panels_per_joint", flow.panels_per_joint, 1);
  constexpr int most_panels = 1000;
  if (flow.panels_per_joint > most_panels) {
    reading.problems.error(table.place("panels_per_joint"),
                           fmt::format("panels_per_joint in [joint_flow] is {}", flow.panels_per_joint),
                           fmt::format("at most {}", most_panels), "take fewer: errors fall with their square");
  }
  refuse_without_flow(reading, table);
  read_drains(reading);
  read_grouts(reading);
  if (flow.kind == FlowKind::steady && table.has("bulk_modulus_pa")) {
    reading.problems.warning(table.place("bulk_modulus_pa"),
                             "bulk_modulus_pa in [joint_flow] has no effect: steady flow stores no water",
                             "kind = \"transient\"", "state that kind, or leave bulk_modulus_pa out");
  }
  if (flows_in_joints(reading.scene) && reading.scene.fluid == FluidModel::external) {
    reading.problems.error(reading.problems.at(0), "uplift = \"flow\" with model = \"external\"",
                           "model = \"hydrostatic\", \"reservoir\" or \"openfoam\" in [fluid]",
                           "change the model, or state another uplift");
  }
}

void check_joint_flow(Reading& reading) {
  const Scene& scene = reading.scene;
  if (!flows_in_joints(scene)) return;
  check_apertures(reading, "[joint]", scene.default_joint);
  for (const Joint& joint : scene.joints) check_apertures(reading, fmt::format("joint \"{}\"", joint.name), joint.law);
  std::vector<TracePiece> pieces;
  for (const Crack& joint : find_flow_joints(scene)) {
    const CrackPart& part = joint.parts.front();
    pieces.insert(pieces.end(), part.trace.pieces.begin(), part.trace.pieces.end());
    for (const int b : {part.block_a, part.block_b}) refuse_mesh(reading, scene.blocks[at(b)], name_of(scene, joint));
  }
  for (const DrainLine& drain : scene.joint_flow.drains) {
    warn_of_idle_drain(reading, drain);
    if (std::any_of(pieces.begin(), pieces.end(),
                    [&](const TracePiece& p) { return crosses(drain.from_m, drain.to_m, p); }))
      continue;
    reading.problems.error(
        reading.problems.at(drain.line), fmt::format("drain \"{}\" crosses no joint with flow", drain.name),
        "a line from_m to to_m that crosses one", "lengthen it beyond the joint, or state uplift = \"flow\" there");
  }
  for (const Grout& grout : scene.joint_flow.grouts) {
    const auto holds = [&](const TracePiece& p) {
      return geometry::holds_point(grout.outline_m, (p.from_m + p.to_m) / 2, 0) ||
             geometry::holds_point(grout.outline_m, p.from_m, 0) || geometry::holds_point(grout.outline_m, p.to_m, 0);
    };
    const auto passes = [&](const TracePiece& p) {
      for (std::size_t i = 0; i < grout.outline_m.size(); ++i) {
        const Point& next = grout.outline_m[(i + 1) % grout.outline_m.size()];
        if (crosses(grout.outline_m[i], next, p)) return true;
      }
      return false;
    };
    if (std::any_of(pieces.begin(), pieces.end(), [&](const auto& p) { return holds(p) || passes(p); })) continue;
    reading.problems.error(reading.problems.at(grout.line),
                           fmt::format("grout \"{}\" holds no joint with flow", grout.name),
                           "an outline_m around part of one", "move it, or state uplift = \"flow\" there");
  }
}

}  // namespace blockweir::scene
