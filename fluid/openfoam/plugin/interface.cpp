// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/plugin/interface.hpp"

#include <vector2D.H>

#include <cstdlib>

namespace blockweir::openfoam {
namespace {

using Foam::dictionary;

Polygon polygon(const dictionary& dict, const char* key) {
  Polygon points;
  for (const Foam::vector2D& p : dict.get<Foam::List<Foam::vector2D>>(key)) points.emplace_back(p.x(), p.y());
  return points;
}

Point point(const dictionary& dict, const char* key) {
  const auto p = dict.get<Foam::vector2D>(key);
  return {p.x(), p.y()};
}

/// Of a polygon of no zero area.
Point centroid(const Polygon& polygon) {
  Point sum = Point::Zero();
  const Point& origin = polygon.front();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point p = polygon[i] - origin;
    const Point q = polygon[i + 1 < polygon.size() ? i + 1 : 0] - origin;
    sum += (p.x() * q.y() - p.y() * q.x()) * (p + q);
  }
  return origin + sum / (6 * area(polygon));
}

CrackOpening opening(const dictionary& dict) {
  return {dict.get<Foam::label>("block"), point(dict, "point"), point(dict, "direction")};
}

scene::KnownHeads known_heads(const dictionary& dict) {
  scene::KnownHeads known;
  if (dict.found("drain")) {
    const dictionary& drain = dict.subDict("drain");
    known.drain = scene::Drain{drain.get<Foam::scalar>("station"), drain.get<Foam::scalar>("efficiency")};
    if (drain.found("head")) known.drain->head_m = drain.get<Foam::scalar>("head");
  }
  if (!dict.found("heads")) return known;
  known.level_m = dict.get<Foam::scalar>("headsAtLevel");
  for (const Foam::vector2D& p : dict.get<Foam::List<Foam::vector2D>>("heads")) {
    known.piezometers.push_back({p.x(), p.y()});
  }
  return known;
}

Crack crack(const dictionary& dict) {
  Crack crack;
  const auto law = dict.get<Foam::word>("law");
  for (const scene::UpliftName& one : scene::uplift_names) {
    if (law == one.name) crack.law = one.law;
  }
  crack.known = known_heads(dict);
  crack.length_m = dict.get<Foam::scalar>("length");
  for (const Foam::vector2D& p : dict.getOrDefault("bends", Foam::List<Foam::vector2D>())) {
    crack.bends.push_back({p.x(), p.y()});
  }
  crack.mouth = opening(dict.subDict("mouth"));
  crack.end = opening(dict.subDict("end"));
  for (const auto& row : dict.get<Foam::List<Foam::FixedList<Foam::scalar, 6>>>("panels")) {
    crack.panels.push_back({static_cast<int>(row[0]), static_cast<int>(row[1]), row[2], row[3], row[4], row[5]});
  }
  return crack;
}

void read_blocks(const dictionary& dict, Interface& into) {
  for (const Foam::entry& entry : dict) {
    const dictionary& block = entry.dict();
    InterfaceBlock b;
    b.vertices = polygon(block, "vertices");
    b.outline = block.found("outline") ? polygon(block, "outline") : b.vertices;
    b.centroid = centroid(b.vertices);
    b.loaded = block.get<Foam::Switch>("loaded");
    b.movable = block.get<Foam::Switch>("movable");
    into.hello.block_names.push_back(block.get<Foam::string>("name"));
    into.hello.vertex_counts.push_back(static_cast<std::uint32_t>(b.vertices.size()));
    for (const Point& p : b.vertices) {
      into.hello.vertices_m.push_back(p.x());
      into.hello.vertices_m.push_back(p.y());
    }
    into.blocks.push_back(std::move(b));
  }
}

}  // namespace

Interface read_interface(const dictionary& dict) {
  Interface i;
  i.endpoint = dict.get<Foam::string>("endpoint");
  if (const char* given = std::getenv("BLOCKWEIR_ENDPOINT")) i.endpoint = given;
  if (const char* given = std::getenv("BLOCKWEIR_KEYS")) i.keys = given;
  i.insecure = std::getenv("BLOCKWEIR_INSECURE") != nullptr;
  i.timeout_s = dict.get<Foam::scalar>("timeout");
  i.open_timeout_s = dict.get<Foam::scalar>("openTimeout");
  i.hello.role = "openfoam";
  i.hello.build = BLOCKWEIR_VERSION;
  i.hello.scene_digest = dict.get<Foam::string>("sceneDigest");
  i.hello.schedule = dict.get<Foam::string>("schedule");
  i.hello.units = dict.get<Foam::string>("units");
  i.hello.window_s = dict.get<Foam::scalar>("window");
  i.hello.first_window = static_cast<std::uint64_t>(dict.get<Foam::label>("firstWindow"));
  i.hello.duration_s = dict.get<Foam::scalar>("duration");
  i.steps_per_window = dict.get<Foam::label>("stepsPerWindow");
  i.max_courant = dict.get<Foam::scalar>("maxCourant");
  if (dict.found("cell")) i.cell_m = dict.get<Foam::scalar>("cell");
  i.own_case = dict.getOrDefault<Foam::Switch>("ownCase", false);
  i.water_density = dict.get<Foam::scalar>("waterDensity");
  i.gravity = dict.get<Foam::scalar>("gravity");
  i.depth_m = dict.get<Foam::scalar>("depth");
  i.open_crack_width_m = dict.get<Foam::scalar>("openCrackWidth");
  i.move_tolerance = dict.get<Foam::scalar>("moveTolerance");
  i.rest_tolerance = dict.get<Foam::scalar>("restTolerance");
  i.flow_in_joints = dict.getOrDefault<Foam::Switch>("flowInJoints", false);
  read_blocks(dict.subDict("blocks"), i);
  for (const Foam::entry& entry : dict.subDict("cracks")) i.cracks.push_back(crack(entry.dict()));
  return i;
}

}  // namespace blockweir::openfoam
