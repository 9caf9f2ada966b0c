// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/section_state.hpp"

#include <algorithm>

#include "bridge/picture/acting_loads.hpp"
#include "bridge/picture/force_text.hpp"
#include "bridge/picture/load_diagrams.hpp"
#include "bridge/picture/still_pools.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::picture {
namespace {

using nlohmann::json;

json level_at(const std::optional<scene::TimeTable>& level_m, double time_s) {
  return level_m ? json(level_m->at(time_s)) : json();
}

View neither_flat_nor_steep(const View& view) {
  constexpr double steepest = 0.85;  // texts beside a tower take their room
  constexpr double flattest = 0.35;
  const double wider = std::max(0.0, (view.top - view.bottom) / steepest - (view.right - view.left)) / 2;
  const double higher = std::max(0.0, (view.right - view.left) * flattest - (view.top - view.bottom)) / 2;
  return {view.left - wider, view.right + wider, view.bottom - higher, view.top + higher};
}

/// The ground reaches far beyond what is of interest: it is shown as far as loads and bolts reach.
View view_of(const scene::Scene& scene, const json& state, double size_m) {
  View view;
  for (const scene::Block& block : scene.blocks) {
    if (block.fixed) continue;
    for (const scene::Point& p : block.vertices) view.include(p.x(), p.y());
  }
  if (view.left > view.right) {
    for (const scene::Block& block : scene.blocks) {
      for (const scene::Point& p : block.vertices) view.include(p.x(), p.y());
    }
  }
  for (const char* pool : {"upstream", "downstream"}) {
    if (state[pool].is_number()) view.include(view.left, state[pool]);
  }
  View around = {view.left - 0.3 * size_m, view.right + 0.2 * size_m, view.bottom - 0.12 * size_m,
                 view.top + 0.1 * size_m};
  constexpr double edge = 0.07;  // for texts
  const auto include = [&](const json& p) {
    for (const double side : {-edge, edge}) {
      around.include(p[0].get<double>() + side * size_m, p[1].get<double>() + side * size_m);
    }
  };
  for (const json& load : state["acting"]) {
    for (const json& p : load["arrow"]) include(p);
    for (const json& outline : load["diagrams"]) std::for_each(outline.begin(), outline.end(), include);
  }
  for (const json& bolt : state["bolts"]) {
    include(bolt["from"]);
    include(bolt["to"]);
  }
  return neither_flat_nor_steep(around);
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
  const double size_m = scene::structure_size_m(scene.blocks);
  json state = {{"time_s", time_s}, {"acting", acting_loads(scene, water, time_s)}, {"bolts", bolts_data(scene)}};
  add_diagrams(state["acting"], size_m);
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
  const View view = view_of(scene, state, size_m);
  state["pools"] = pools_in(scene, water, state, view);
  state["view"] = {{"left", view.left}, {"right", view.right}, {"bottom", view.bottom}, {"top", view.top}};
  return state;
}

}  // namespace blockweir::picture
