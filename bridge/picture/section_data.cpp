// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/section_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "bridge/geometry/outline.hpp"
#include "bridge/geometry/polygon.hpp"
#include "bridge/picture/acting_loads.hpp"
#include "bridge/picture/json_point.hpp"
#include "bridge/picture/pictured_structure.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/joint_trace.hpp"
#include "bridge/scene/structure_size.hpp"
#include "bridge/scene/touching_pairs.hpp"

namespace blockweir::picture {
namespace {

using nlohmann::json;
using scene::Point;

constexpr double touching_ratio = 1e-6;  // of the structure

json outline_of(const std::vector<Point>& points) {
  json list = json::array();
  for (const Point& p : points) list.push_back(pair(p));
  return list;
}

/// The law of the water in a joint, with what the scene states of it.
std::string water_in(const scene::JointLaw& law) {
  std::string text = scene::named(law.uplift).name;
  if (const auto& drain = law.known_heads.drain) {
    text += fmt::format(", drain at {:.4g} m from the upstream end, efficiency {:.4g}", drain->station_m,
                        drain->efficiency);
    if (std::isfinite(drain->head_m)) text += fmt::format(", to a head at {:.4g} m", drain->head_m);
  }
  if (law.has_flow()) text += fmt::format(", aperture {:.3g} mm", 1e3 * law.hydraulic_aperture_m);
  const std::size_t piezometers = law.known_heads.piezometers.size();
  if (piezometers > 0) text += fmt::format(" of {} piezometer{}", piezometers, piezometers == 1 ? "" : "s");
  return text;
}

/// The part of a joint that has cohesion or tension strength, in words where it has no length.
json bonded_part(const scene::JointLaw& law) {
  if (!law.is_bonded()) return "none";
  return law.bonded_length_m ? json(*law.bonded_length_m) : json("all");
}

json law(const std::string& name, const scene::JointLaw& law) {
  return {{"name", name},
          {"friction", law.friction_angle_deg},
          {"residual", law.residual_friction_angle_deg},
          {"cohesion", law.cohesion_pa},
          {"tension", law.tension_strength_pa},
          {"bonded", bonded_part(law)},
          {"uplift", water_in(law)}};
}

/// Joints of one set, cut or region share name and law: listed once.
json laws(const scene::Scene& scene) {
  json rows = json::array();
  std::set<std::string> named;
  for (const scene::Joint& joint : scene.joints) {
    const std::string& name = joint.set.empty() ? joint.name : joint.set;
    if (named.insert(name).second) rows.push_back(law(name, joint.law));
  }
  rows.push_back(law(rows.empty() ? "all joints" : "all other joints", scene.default_joint));
  return rows;
}

/// Lines of drains and grout curtains that the water in joints meets.
json drainage_rows(const scene::JointFlow& flow) {
  json rows = json::array();
  const auto place = [](const Point& p) { return fmt::format("({:.4g}, {:.4g})", p.x(), p.y()); };
  for (const scene::DrainLine& drain : flow.drains) {
    rows.push_back(
        {drain.name.empty() ? "drain" : fmt::format("drain \"{}\"", drain.name),
         fmt::format("from {} to {} m, efficiency {:.4g}, {}", place(drain.from_m), place(drain.to_m), drain.efficiency,
                     drain.head_m ? fmt::format("to a head at {:.4g} m", *drain.head_m) : "into air")});
  }
  for (const scene::Grout& grout : flow.grouts) {
    std::string corners;
    for (const Point& p : grout.outline_m) corners += (corners.empty() ? "" : ", ") + place(p);
    rows.push_back({grout.name.empty() ? "grout" : fmt::format("grout \"{}\"", grout.name),
                    fmt::format("within {} m: apertures times {:.3g}", corners, grout.aperture_factor)});
  }
  return rows;
}

json joints(const scene::Scene& scene) {
  const double touching_m = touching_ratio * scene::structure_size_m(scene.blocks);
  json list = json::array();
  std::set<std::string> named;
  for (const scene::Joint& joint : scene.joints) {
    const auto trace =
        scene::trace_joint(scene.blocks[at(joint.between[0])], scene.blocks[at(joint.between[1])], touching_m);
    if (trace.pieces.empty()) continue;
    json line = json::array({pair(trace.mouth())});
    for (const auto& piece : trace.pieces) line.push_back(pair(piece.to_m));
    const std::string& name = joint.set.empty() ? joint.name : joint.set;
    list.push_back({{"name", name}, {"lines", json::array({line})}, {"labelled", named.insert(name).second}});
  }
  return list;
}

/// x of the ends of all that stands on fixed blocks; none where nothing does.
json ends_on_ground(const scene::Scene& scene) {
  const double touching_m = touching_ratio * scene::structure_size_m(scene.blocks);
  json ends = nullptr;
  for (const auto& [pair, trace] : scene::touching_joints(scene, touching_m)) {
    if (!scene.blocks[at(pair.first)].fixed && !scene.blocks[at(pair.second)].fixed) continue;
    for (const auto& piece : trace.pieces) {
      const auto [left, right] = std::minmax(piece.from_m.x(), piece.to_m.x());
      ends = ends.is_null() ? json{left, right}
                            : json{std::min(ends[0].get<double>(), left), std::max(ends[1].get<double>(), right)};
    }
  }
  return ends;
}

/// Of the structure in the picture: height, and the ends of its base and its highest line. The base is the lowest line,
/// or what stands on the ground where that dips.
json dimensions(const scene::Scene& scene) {
  const geometry::Bounds box = pictured_structure(scene);
  std::vector<Point> movable;
  for (const auto& block : scene.blocks) {
    if (block.fixed) continue;
    for (const Point& p : block.vertices) {
      if ((p.array() >= box.low.array()).all() && (p.array() <= box.high.array()).all()) movable.push_back(p);
    }
  }
  if (movable.empty()) return nullptr;
  const double near = 1e-6 * box.size();
  const auto ends_at = [&](double y) {
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    for (const Point& p : movable) {
      if (std::abs(p.y() - y) > near) continue;
      left = std::min(left, p.x());
      right = std::max(right, p.x());
    }
    return json{left, right};
  };
  json base = ends_at(box.low.y());
  if (base[1].get<double>() - base[0].get<double>() <= near) base = ends_on_ground(scene);
  return {{"bottom", box.low.y()},
          {"top", box.high.y()},
          {"right", box.high.x()},
          {"base", base},
          {"crest", ends_at(box.high.y())}};
}

}  // namespace

json section_data(const scene::Scene& scene) {
  json blocks = json::array();
  for (const auto& block : scene.blocks) {
    blocks.push_back({{"name", block.name},
                      {"fixed", block.fixed},
                      {"outline", outline_of(block.vertices)},
                      {"centroid", pair(geometry::centroid(block.vertices))}});
  }
  json materials = json::array();
  for (const auto& material : scene.materials) {
    materials.push_back({{"name", material.name},
                         {"density", material.density_kg_per_m3},
                         {"modulus", material.youngs_modulus_pa},
                         {"poisson", material.poissons_ratio}});
  }
  return {{"blocks", blocks},
          {"materials", materials},
          {"laws", laws(scene)},
          {"drainage", drainage_rows(scene.joint_flow)},
          {"joints", joints(scene)},
          {"bolts", bolts_data(scene)},
          {"dimensions", dimensions(scene)},
          {"size_m", pictured_structure(scene).size()}};
}

}  // namespace blockweir::picture
