// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/load_diagrams.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <map>
#include <string>

#include "bridge/picture/force_text.hpp"
#include "bridge/picture/json_point.hpp"

namespace blockweir::picture {
namespace {

using nlohmann::json;
using Point = Eigen::Vector2d;

const std::map<std::string, const char*> colour_of_kind = {
    {"weight", "#424242"}, {"earthquake", "#bf360c"}, {"load", "#7a1fa2"},        {"silt", "#795548"},
    {"water", "#1f6fb4"},  {"ice", "#00acc1"},        {"added water", "#ff8f00"}, {"uplift", "#2e7d32"}};

double largest(const json& load) {
  double size = 0;
  for (const json& strip : load["strips"]) {
    for (const json& station : strip) size = std::max(size, point_of(station, 2).norm());
  }
  return size;
}

/// The strip, and against the load's direction `by` metres for each unit of it.
json diagram(const json& strip, double by) {
  json outline = json::array();
  for (const json& station : strip) outline.push_back(pair(point_of(station)));
  for (auto station = strip.rbegin(); station != strip.rend(); ++station) {
    outline.push_back(pair(point_of(*station) - by * point_of(*station, 2)));
  }
  return outline;
}

/// An earthquake may reduce the pressure on a face: this diagram is also drawn on the outer side.
bool pulls(const json& load) {
  const double x = load["force"][0];
  return load["kind"] == "added water" && load.value("from_downstream", x < 0) == (x > 0);
}

}  // namespace

void add_diagrams(json& loads, double size_m) {
  constexpr double longest = 0.2;  // of the structure, as all that follow
  constexpr double shortest = 0.05;
  constexpr double arrow = 0.1;
  double strongest = 0;
  for (const json& load : loads) strongest = std::max(strongest, largest(load));
  for (json& load : loads) {
    const Point force = point_of(load["force"]);
    const Point at = point_of(load["at"]);
    load["colour"] = colour_of_kind.at(load["kind"]);
    load["label"] = load["name"].get<std::string>() + " " + force_text(force.norm());
    load["diagrams"] = json::array();
    const Point along = force.isZero(0) ? Point(1, 0) : Point(force.normalized());
    if (load["strips"].empty()) {
      load["arrow"] = {pair(at - arrow * size_m * along), pair(at)};
      continue;
    }
    const double reach_m = size_m * std::max(shortest, longest * largest(load) / strongest);
    for (const json& strip : load["strips"]) {
      load["diagrams"].push_back(diagram(strip, (pulls(load) ? -1 : 1) * reach_m / largest(load)));
    }
    const Point outer = at + (pulls(load) ? 1 : -1) * reach_m * along;
    load["arrow"] = pulls(load) ? json{pair(at), pair(outer)} : json{pair(outer), pair(at)};
  }
}

json load_legend(const json& loads) {
  json rows = json::array();
  std::map<std::string, std::size_t> row_of;
  for (const json& load : loads) {
    const std::string name = load["name"];
    const auto [known, added] = row_of.try_emplace(name, rows.size());
    if (!added) {
      rows[known->second]["label"] = name;  // sizes stand at the loads themselves
      continue;
    }
    rows.push_back({{"label", load["label"]}, {"colour", load["colour"]}});
  }
  return rows;
}

}  // namespace blockweir::picture
