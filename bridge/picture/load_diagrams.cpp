// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/load_diagrams.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

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

/// Of each load, the largest force a metre of it and of those of its kind that go on where it ends, as uplift does from
/// one joint of a line to the next: drawn to one scale, they make one diagram.
std::vector<double> largest_in_line(const json& loads, double size_m) {
  constexpr double near = 1e-6;  // of the structure
  std::vector<std::size_t> next(loads.size());
  std::iota(next.begin(), next.end(), 0);
  const auto first_of = [&](std::size_t i) {
    while (next[i] != i) i = next[i];
    return i;
  };
  std::map<std::tuple<std::string, long long, long long>, std::size_t> at_end;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    for (const json& strip : loads[i]["strips"]) {
      for (const json& end : {strip.front(), strip.back()}) {
        const Point cell = point_of(end) / (near * size_m);
        const auto [other, alone] =
            at_end.try_emplace({loads[i]["kind"], std::llround(cell.x()), std::llround(cell.y())}, i);
        if (!alone)
          next[std::max(first_of(i), first_of(other->second))] = std::min(first_of(i), first_of(other->second));
      }
    }
  }
  std::vector<double> sizes(loads.size(), 0);
  for (std::size_t i = 0; i < loads.size(); ++i) sizes[first_of(i)] = std::max(sizes[first_of(i)], largest(loads[i]));
  for (std::size_t i = 0; i < loads.size(); ++i) sizes[i] = sizes[first_of(i)];
  return sizes;
}

constexpr std::size_t most_named = 4;

/// Do the joints with uplift have one row of the legend together, and no labels? Where they are many, each of a line of
/// joints would have its own.
bool sums_uplift(const json& loads) {
  return std::count_if(loads.begin(), loads.end(), [](const json& l) { return l["kind"] == "uplift"; }) >
         static_cast<std::ptrdiff_t>(most_named);
}

json sum_of_uplift(const json& loads) {
  Point force = Point::Zero();
  int joints = 0;
  for (const json& load : loads) {
    if (load["kind"] != "uplift") continue;
    force += point_of(load["force"]);
    ++joints;
  }
  return {{"label", fmt::format("uplift in {} joints {}", joints, force_text(force.norm()))},
          {"colour", colour_of_kind.at("uplift")}};
}

}  // namespace

void add_diagrams(json& loads, double size_m) {
  constexpr double longest = 0.2;  // of the structure, as all that follow
  constexpr double shortest = 0.05;
  constexpr double arrow = 0.1;
  const std::vector<double> in_line = largest_in_line(loads, size_m);
  const double strongest = in_line.empty() ? 0 : *std::max_element(in_line.begin(), in_line.end());
  const bool summed = sums_uplift(loads);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    json& load = loads[i];
    const Point force = point_of(load["force"]);
    const Point at = point_of(load["at"]);
    load["colour"] = colour_of_kind.at(load["kind"]);
    load["label"] = load["name"].get<std::string>() + " " + force_text(force.norm());
    load["labelled"] = !summed || load["kind"] != "uplift";
    load["diagrams"] = json::array();
    const Point along = force.isZero(0) ? Point(1, 0) : Point(force.normalized());
    if (load["strips"].empty()) {
      load["arrow"] = {pair(at - arrow * size_m * along), pair(at)};
      continue;
    }
    const double by = size_m * std::max(shortest / in_line[i], longest / strongest);
    const double reach_m = by * largest(load);
    for (const json& strip : load["strips"]) load["diagrams"].push_back(diagram(strip, pulls(load) ? -by : by));
    const Point outer = at + (pulls(load) ? 1 : -1) * reach_m * along;
    load["arrow"] = pulls(load) ? json{pair(at), pair(outer)} : json{pair(outer), pair(at)};
  }
}

json load_legend(const json& loads) {
  json rows = json::array();
  std::map<std::string, std::size_t> row_of;
  for (const json& load : loads) {
    if (!load["labelled"].get<bool>()) continue;
    const std::string name = load["name"];
    const auto [known, added] = row_of.try_emplace(name, rows.size());
    if (!added) {
      rows[known->second]["label"] = name;  // sizes stand at the loads themselves
      continue;
    }
    rows.push_back({{"label", load["label"]}, {"colour", load["colour"]}});
  }
  if (sums_uplift(loads)) rows.push_back(sum_of_uplift(loads));
  return rows;
}

}  // namespace blockweir::picture
