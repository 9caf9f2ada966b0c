// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/section_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <set>
#include <stdexcept>

#include "bridge/geometry/outline.hpp"
#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/read/drawing_layers.hpp"
#include "bridge/scene/read/dxf.hpp"
#include "bridge/scene/read/dxf_entities.hpp"
#include "bridge/scene/read/dxf_pairs.hpp"
#include "bridge/scene/read/nearest.hpp"
#include "bridge/scene/read/table_reader.hpp"

namespace blockweir::scene {
namespace {

using Ring = std::vector<Point>;

toml::array array_of(const Point& p) {
  return toml::array{p.x(), p.y()};
}
toml::array array_of(const Ring& points) {
  toml::array list;
  for (const Point& p : points) list.push_back(array_of(p));
  return list;
}

/// Closed lines, joined from pieces with common ends; empty if an end is left over.
std::vector<Ring> rings_of(std::vector<Ring> pieces) {
  std::vector<Ring> rings;
  const auto meet = [](const Point& a, const Point& b) { return (a - b).norm() <= 1e-9 * (1 + a.norm()); };
  while (!pieces.empty()) {
    Ring ring = std::move(pieces.back());
    pieces.pop_back();
    while (!meet(ring.front(), ring.back()) || ring.size() < 3) {
      const auto next = std::find_if(pieces.begin(), pieces.end(), [&](const Ring& piece) {
        return meet(piece.front(), ring.back()) || meet(piece.back(), ring.back());
      });
      if (next == pieces.end()) return {};
      if (!meet(next->front(), ring.back())) std::reverse(next->begin(), next->end());
      ring.insert(ring.end(), next->begin() + 1, next->end());
      pieces.erase(next);
    }
    ring.pop_back();
    rings.push_back(std::move(ring));
  }
  std::sort(rings.begin(), rings.end(), [](const Ring& a, const Ring& b) {
    return std::abs(geometry::signed_area(a)) > std::abs(geometry::signed_area(b));
  });
  return rings;
}

bool lacks_points(const toml::table* cut) {
  return cut != nullptr && !cut->contains("points_m") && (*cut)["name"].is_string();
}

/// Where the scene states the law for cuts of this name: its first [[cut]] without points; capitals do not count.
std::optional<std::size_t> law_of(const toml::array& given, const std::string& name) {
  for (std::size_t i = 0; i < given.size(); ++i) {
    const toml::table* cut = given[i].as_table();
    if (lacks_points(cut) && boost::iequals((*cut)["name"].value_or(std::string()), name)) return i;
  }
  return std::nullopt;
}

toml::array cuts_of(const DxfDrawing& drawing, const toml::array& given, Problems& problems) {
  toml::array cuts;
  std::set<std::size_t> served;
  std::vector<std::string> layers;
  for (const DxfDrawing::Line& line : drawing.lines) {
    layers.push_back(line.layer);
    const std::string name = cut_of_layer(line.layer);
    if (name.empty()) continue;
    const auto law = law_of(given, name);
    toml::table cut = law ? *given[*law].as_table() : toml::table{{"name", name}};
    if (law) served.insert(*law);
    cut.insert_or_assign("points_m", array_of(line.points));
    cut.insert_or_assign("drawn", true);
    cuts.push_back(std::move(cut));
  }
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (served.contains(i)) continue;
    cuts.push_back(given[i]);
    const toml::table* cut = given[i].as_table();
    const std::string name = lacks_points(cut) ? (*cut)["name"].value_or(std::string()) : "";
    const auto law = law_of(given, name);
    if (name.empty() || served.contains(law.value_or(i))) continue;  // a second of one name is told as such
    const std::string layer = layer_of_cut(name);
    const std::string near = did_you_mean(layer, layers);
    problems.error(problems.at(cut->source()),
                   fmt::format("[[cut]] \"{}\" has no points_m, and no line is on the layer \"{}\"", name, layer),
                   "one of them", near.empty() ? "draw it on that layer, or add points_m = ..." : near);
  }
  return cuts;
}

void scale(DxfDrawing& drawing, double unit_m) {
  for (DxfDrawing::Line& line : drawing.lines) {
    for (Point& p : line.points) p *= unit_m;
  }
  for (DxfDrawing::Mark& mark : drawing.marks) mark.point *= unit_m;
}

}  // namespace

bool take_drawing(toml::table& file, const std::filesystem::path& folder, Problems& problems) {
  toml::table* section = file["section"].as_table();
  if (section == nullptr || !section->contains("dxf")) return false;
  const Place place = problems.at(section->get("dxf")->source());
  const auto name = (*section)["dxf"].value<std::string>();
  const toml::node* given_unit = section->get("dxf_unit_m");
  const std::optional<double> unit = given_unit == nullptr ? 1.0 : finite_number(*given_unit);
  if (!name || !unit || *unit <= 0 || section->contains("outline_m")) {
    problems.error(place, "dxf in [section] is not the path of a drawing alone",
                   "a text, dxf_unit_m above 0 if any, and no outline_m beside it", "correct the section");
    return true;
  }
  const auto refuse = [&](const std::string& found, const std::string& expected, const std::string& remedy) {
    problems.error(place, fmt::format("the drawing {}: {}", *name, found), expected, remedy);
    return true;
  };
  DxfDrawing drawing;
  try {
    const DxfFault fault = first_fault_of_dxf(folder / *name);
    if (!fault.found.empty()) {
      problems.error({(folder / *name).string(), fault.line}, "found " + fault.found, fault.expected,
                     "export the drawing again");
      return true;
    }
    const std::size_t before = problems.count();
    check_layers(entities_of_dxf(folder / *name), folder / *name, problems);
    if (problems.count() > before) return true;
    drawing = read_dxf(folder / *name);
  } catch (const std::runtime_error& error) {
    return refuse(error.what(), "a DXF file, its path from the scene's folder", "check the path, or export it again");
  }
  scale(drawing, *unit);
  std::vector<Ring> pieces;
  for (const DxfDrawing::Line& line : drawing.lines) {
    if (line.layer == "section") pieces.push_back(line.points);
  }
  const std::vector<Ring> rings = rings_of(std::move(pieces));
  if (rings.empty()) {
    return refuse("no closed line on the layer \"section\"", "the section's outline, and its holes if any",
                  "close it, or move it to that layer");
  }
  section->erase("dxf");
  section->erase("dxf_unit_m");
  section->insert_or_assign("outline_m", array_of(rings.front()));
  toml::array holes;
  for (std::size_t i = 1; i < rings.size(); ++i) holes.push_back(array_of(rings[i]));
  if (!holes.empty()) section->insert_or_assign("holes_m", std::move(holes));
  toml::array held;
  for (const DxfDrawing::Mark& mark : drawing.marks) {
    if (mark.layer == "supports") held.push_back(array_of(mark.point));
  }
  if (!held.empty()) section->insert_or_assign("held_points_m", std::move(held));
  const toml::array none;
  const toml::array* given = file["cut"].as_array();
  toml::array cuts = cuts_of(drawing, given == nullptr ? none : *given, problems);  // a copy would have no lines
  if (!cuts.empty()) file.insert_or_assign("cut", std::move(cuts));
  return true;
}

}  // namespace blockweir::scene
