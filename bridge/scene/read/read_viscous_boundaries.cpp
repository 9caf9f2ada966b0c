// SPDX-License-Identifier: GPL-3.0-or-later
// [[viscous_boundary]]: faces beyond which the ground goes on, so that waves leave through them.
#include <fmt/format.h>

#include <algorithm>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {
namespace {

constexpr double rounding = 1e-6;  // of the model's size

geometry::Bounds bounds_of_model(const Scene& scene) {
  std::vector<Point> all;
  for (const Block& block : scene.blocks) all.insert(all.end(), block.vertices.begin(), block.vertices.end());
  if (all.empty()) return {Point::Zero(), Point::Zero()};
  return geometry::bounds_of(all);
}

/// Edges of a block on the model's bottom and its left and right end.
std::vector<ViscousFace> outer_faces(const Scene& scene, const geometry::Bounds& model, int block) {
  const double near_m = rounding * model.size();
  const auto& outline = scene.blocks[at(block)].vertices;
  std::vector<ViscousFace> faces;
  for (std::size_t v = 0; v < outline.size(); ++v) {
    const Point& a = outline[v];
    const Point& b = outline[(v + 1) % outline.size()];
    const auto both = [&](int axis, double value) {
      return std::abs(a[axis] - value) <= near_m && std::abs(b[axis] - value) <= near_m;
    };
    if (both(1, model.low.y()) || both(0, model.low.x()) || both(0, model.high.x())) {
      faces.push_back({.block = block, .from_m = a, .to_m = b});
    }
  }
  return faces;
}

/// Along the outline, whichever way it is stated.
ViscousFace along_outline(const Block& block, ViscousFace face) {
  const Point middle = (face.from_m + face.to_m) / 2;
  const double little = 1e-3 * face.length_m();
  if (geometry::holds_point(block.vertices, middle + little * face.normal(), little / 2)) {
    std::swap(face.from_m, face.to_m);
  }
  return face;
}

bool overlap(const ViscousFace& one, const ViscousFace& other) {
  if (one.block != other.block) return false;
  const Point along = (one.to_m - one.from_m).normalized();
  const double near_m = rounding * one.length_m();
  const auto off = [&](const Point& p) { return std::abs(one.normal().dot(p - one.from_m)) > near_m; };
  if (off(other.from_m) || off(other.to_m)) return false;
  const double low = along.dot(other.from_m - one.from_m);  // both run along the outline
  const double high = along.dot(other.to_m - one.from_m);
  return std::min(high, one.length_m()) - std::max(low, 0.0) > near_m;
}

/// The face from from_m to to_m; empty if it is not part of an edge.
std::vector<ViscousFace> stated_face(TableReader& table, Reading& reading, int index) {
  ViscousFace face{.block = index};
  if (table.has("from_m") != table.has("to_m")) {
    reading.problems.error(table.place(), fmt::format("{} states one end of its face", table.name()),
                           "from_m and to_m, or neither: all faces on the model's bottom, left and right end",
                           "state the other end, too");
  }
  const bool from = table.point("from_m", face.from_m);
  const bool to = table.point("to_m", face.to_m);
  const Block* block = reading.sound_block(index);
  if (!from || !to || block == nullptr) return {};
  const double tolerance_m = rounding * geometry::bounds_of(block->vertices).size();
  if (face.length_m() > tolerance_m && geometry::on_one_edge(block->vertices, face.from_m, face.to_m, tolerance_m)) {
    return {along_outline(*block, face)};
  }
  reading.problems.error(
      table.place("from_m"),
      fmt::format("{} from ({}, {}) to ({}, {}) is no part of one edge of block \"{}\"", table.name(), face.from_m.x(),
                  face.from_m.y(), face.to_m.x(), face.to_m.y(), block->name),
      "two points of one edge", "state a boundary for each edge, or leave both points out");
  return {};
}

/// All of the block, or of all blocks that can move, on the model's bottom and ends.
std::vector<ViscousFace> automatic_faces(TableReader& table, Reading& reading, int index) {
  const geometry::Bounds model = bounds_of_model(reading.scene);
  std::vector<ViscousFace> faces;
  for (int b = 0; b < static_cast<int>(reading.scene.blocks.size()); ++b) {
    if (index >= 0 ? b != index : reading.scene.blocks[at(b)].fixed) continue;
    const std::vector<ViscousFace> of_block = outer_faces(reading.scene, model, b);
    faces.insert(faces.end(), of_block.begin(), of_block.end());
  }
  if (!faces.empty() || (index >= 0 && reading.sound_block(index) == nullptr)) return faces;
  const std::string whose = index < 0 ? fmt::format("all blocks that can move have")
                                      : fmt::format("block \"{}\" has", reading.scene.blocks[at(index)].name);
  reading.problems.error(
      table.place(),
      fmt::format("{} has no face: {} no edge on the model's bottom, left or right end", table.name(), whose),
      "a block that can move and reaches the model's bottom or an end", "state from_m and to_m, or name the block");
  return faces;
}

void add_faces(TableReader& table, Reading& reading, const std::vector<ViscousFace>& faces) {
  for (const ViscousFace& face : faces) {
    const std::string& name = reading.scene.blocks[at(face.block)].name;
    const auto refuse = [&](const char* found, const char* expected, const char* remedy) {
      reading.problems.error(table.place(), fmt::format("{} on block \"{}\" {}", table.name(), name, found), expected,
                             remedy);
    };
    const auto& others = reading.scene.viscous_faces;
    if (!face.is_side() && face.normal().y() > 0) {
      return refuse("has a face that looks up", "ground below a face or beside it", "state a lower face");
    }
    if (std::any_of(others.begin(), others.end(), [&](const auto& other) { return overlap(face, other); })) {
      return refuse("covers a face that another one covers", "each face once", "leave one of the two out");
    }
    reading.scene.viscous_faces.push_back(face);
  }
}

}  // namespace

void read_viscous_boundaries(Reading& reading) {
  reading.each("viscous_boundary", [&](TableReader& table) {
    const bool stated = table.has("from_m") || table.has("to_m");
    const int index = table.reference("block", reading.blocks, /*required=*/stated);
    const int material = table.reference("material", reading.materials, /*required=*/false);
    table.know("from_m"), table.know("to_m");
    if (index < 0 && (stated || table.has("block"))) return;
    if (const Block* block = reading.sound_block(index); block != nullptr && block->fixed) {
      reading.problems.error(table.place("block"),
                             fmt::format("{} has no effect: block \"{}\" is fixed", table.name(), block->name),
                             "a block that can move", "take fixed = true from the block, or leave the boundary out");
      return;
    }
    std::vector<ViscousFace> faces =
        stated ? stated_face(table, reading, index) : automatic_faces(table, reading, index);
    for (ViscousFace& face : faces) {
      face.material = material >= 0 ? material : reading.scene.blocks[at(face.block)].material;
    }
    add_faces(table, reading, faces);
  });
}

void check_viscous_boundaries(const Reading& reading) {
  const Scene& scene = reading.scene;
  if (scene.viscous_faces.empty()) return;
  const toml::array* stated = reading.file["viscous_boundary"].as_array();
  const Place place =
      stated == nullptr || stated->empty() ? reading.problems.at(0) : reading.problems.at((*stated)[0].source());
  if (scene.analysis.start == Start::unstressed && scene.analysis.gravity_m_per_s2 != 0) {
    reading.problems.error(place, "[[viscous_boundary]] bears no weight with start = \"unstressed\" in [analysis]",
                           "start = \"equilibrium\": the forces that hold the ground at rest remain as loads",
                           "leave start out, or set gravity_m_per_s2 = 0");
  }
  if (!scene.base_motion) return;
  const auto is_side = [](const ViscousFace& face) { return face.is_side(); };
  if (std::none_of(scene.viscous_faces.begin(), scene.viscous_faces.end(), is_side)) return;
  const int material = scene.viscous_faces.front().material;
  const auto other = std::find_if(scene.viscous_faces.begin(), scene.viscous_faces.end(),
                                  [&](const ViscousFace& face) { return face.material != material; });
  if (other == scene.viscous_faces.end()) return;
  reading.problems.error(
      place,
      fmt::format(
          "[[viscous_boundary]] beside the model is in ground of materials \"{}\" and \"{}\", and [base_motion] "
          "comes up in it",
          scene.materials[at(material)].name, scene.materials[at(other->material)].name),
      "ground of one material below and beside the model", "state boundaries below the model only, by from_m and to_m");
}

}  // namespace blockweir::scene
