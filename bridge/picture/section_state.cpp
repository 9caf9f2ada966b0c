// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/section_state.hpp"

#include <algorithm>

#include "bridge/picture/acting_loads.hpp"
#include "bridge/picture/force_text.hpp"
#include "bridge/picture/json_point.hpp"
#include "bridge/picture/load_diagrams.hpp"
#include "bridge/picture/pictured_structure.hpp"
#include "bridge/picture/still_pools.hpp"

namespace blockweir::picture {
namespace {

using nlohmann::json;

json level_at(const std::optional<scene::TimeTable>& level_m, double time_s) {
  return level_m ? json(level_m->at(time_s)) : json();
}

View neither_flat_nor_steep(const View& view) {
  constexpr double steepest = 0.85;  // a narrow picture leaves room for texts beside a tower
  constexpr double flattest = 0.35;
  const double wider = std::max(0.0, (view.top - view.bottom) / steepest - (view.right - view.left)) / 2;
  const double higher = std::max(0.0, (view.right - view.left) * flattest - (view.top - view.bottom)) / 2;
  return {view.left - wider, view.right + wider, view.bottom - higher, view.top + higher};
}

/// The ground reaches far beyond what is of interest: it is shown as far as bolts reach, and as loads do within half
/// the structure's size around it.
View view_of(const geometry::Bounds& structure, const json& state) {
  const double size_m = structure.size();
  View view{structure.low.x(), structure.high.x(), structure.low.y(), structure.high.y()};
  const scene::Point low = structure.low - scene::Point::Constant(size_m / 2);
  const scene::Point high = structure.high + scene::Point::Constant(size_m / 2);
  for (const char* pool : {"upstream", "downstream"}) {
    if (state[pool].is_number()) view.include(view.left, state[pool]);
  }
  View around = {view.left - 0.3 * size_m, view.right + 0.2 * size_m, view.bottom - 0.12 * size_m,
                 view.top + 0.17 * size_m};
  constexpr double edge = 0.07;  // for texts
  const auto include = [&](const json& p) {
    for (const double side : {-edge, edge}) {
      around.include(p[0].get<double>() + side * size_m, p[1].get<double>() + side * size_m);
    }
  };
  const auto include_near = [&](const json& p) { include(pair(point_of(p).cwiseMax(low).cwiseMin(high))); };
  for (const json& load : state["acting"]) {
    for (const json& p : load["arrow"]) include_near(p);
    for (const json& outline : load["diagrams"]) std::for_each(outline.begin(), outline.end(), include_near);
  }
  for (const json& bolt : state["bolts"]) {
    include(bolt["from"]);
    include(bolt["to"]);
  }
  return neither_flat_nor_steep(around);
}

/// A resultant whose point lies beyond the view is left to the legend; one that begins beyond it is cut there.
void cut_arrows(json& acting, const View& view) {
  const scene::Point low(view.left, view.bottom);
  const scene::Point high(view.right, view.top);
  const auto is_seen = [&](const scene::Point& p) {
    return (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
  };
  for (json& load : acting) {
    const scene::Point from = point_of(load["arrow"][0]);
    const scene::Point to = point_of(load["arrow"][1]);
    load["in_view"] = is_seen(to);
    if (!is_seen(to) || is_seen(from)) continue;
    double share = 1;  // of the way from `to`
    for (const int axis : {0, 1}) {
      const double way = from[axis] - to[axis];
      if (way != 0) share = std::min(share, ((way > 0 ? high : low)[axis] - to[axis]) / way);
    }
    constexpr double inside = 0.9;  // its label stands within the frame
    load["arrow"][0] = pair(to + inside * share * (from - to));
  }
}

json pools_in(const scene::Scene& scene, const json& water, const json& state, const View& view) {
  json frame = {{"upstream_level_m", state["upstream"]}, {"downstream_level_m", state["downstream"]}};
  frame["blocks"] = json::array();
  for (const scene::Block& block : scene.blocks) {
    json outline = json::array();
    for (const scene::Point& p : block.vertices) outline.push_back({p.x(), p.y()});
    frame["blocks"].push_back({{"fixed", block.fixed}, {"outline", outline}});
  }
  frame["panels"] = json::array();
  for (const json& kind : water) {
    const bool in_crack = kind["name"] == "water in joints";
    for (json panel : kind["panels"]) {
      panel[6] = in_crack ? 1 : 0;
      frame["panels"].push_back(std::move(panel));
    }
  }
  json pools = json::array();
  for (const auto& pool : still_pools(frame, view)) {
    json& outline = pools.emplace_back(json::array());
    for (const Eigen::Vector2d& p : pool) outline.push_back({p.x(), p.y()});
  }
  return pools;
}

}  // namespace

json section_state(const scene::Scene& scene, const json& water, double time_s, const json& bolt_forces) {
  const geometry::Bounds structure = pictured_structure(scene);
  json state = {{"time_s", time_s}, {"acting", acting_loads(scene, water, time_s)}, {"bolts", bolts_data(scene)}};
  add_diagrams(state["acting"], structure.size());
  state["waves_left_out"] = scene.fluid == scene::FluidModel::openfoam && scene.openfoam.wave.has_value();
  state["upstream"] = level_at(scene.water.upstream_level_m, time_s);
  state["downstream"] = level_at(scene.water.downstream_level_m, time_s);
  for (std::size_t i = 0; i < state["bolts"].size(); ++i) {
    json& bolt = state["bolts"][i];
    const double force = i < bolt_forces.size() ? bolt_forces[i] : bolt["prestress_n_per_m"];
    bolt["force_n_per_m"] = force;
    bolt["label"] = bolt["name"].get<std::string>() + " " + force_text(force);
  }
  state["legend"] = load_legend(state["acting"]);
  for (const json& bolt : state["bolts"]) {
    state["legend"].push_back({{"label", bolt["label"]}, {"colour", bolt_colour}});
  }
  const View view = view_of(structure, state);
  cut_arrows(state["acting"], view);
  state["pools"] = pools_in(scene, water, state, view);
  state["view"] = {{"left", view.left}, {"right", view.right}, {"bottom", view.bottom}, {"top", view.top}};
  return state;
}

}  // namespace blockweir::picture
