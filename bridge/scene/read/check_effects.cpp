// SPDX-License-Identifier: GPL-3.0-or-later
// Warns of keys without effect in a valid scene: switched off by another key, materials of no block, water that reaches
// nothing, a run in which nothing can happen.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/joint_trace.hpp"
#include "bridge/scene/quantity_table.hpp"
#include "bridge/scene/read/reading.hpp"
#include "bridge/scene/structure_size.hpp"
#include "bridge/scene/water_answers.hpp"

namespace blockweir::scene {
namespace {

/// A key that has an effect only while the scene says something else, too.
struct IdleKey {
  const char* section;
  const char* key;
  bool (*idle)(const Scene&);
  const char* needs;
};

bool dry(const Scene& s) {
  return s.fluid == FluidModel::none;
}
bool not_still_water(const Scene& s) {
  return !still_pools(s.fluid) && !dry(s);
}

constexpr IdleKey idle_keys[] = {
    {"analysis", "spectral_radius",
     [](const Scene& s) { return s.analysis.integrator != Integrator::generalized_alpha; },
     "integrator = \"generalized-alpha\""},
    {"analysis", "residual_tolerance", [](const Scene& s) { return s.analysis.kind != AnalysisKind::at_rest; },
     "kind = \"static\""},
    {"analysis", "mass_damping_per_s",
     [](const Scene& s) { return s.analysis.kind != AnalysisKind::dynamic && s.analysis.mass_damping_per_s > 0; },
     "kind = \"dynamic\""},
    {"analysis", "gravity_tilt_deg",
     [](const Scene& s) { return s.analysis.gravity_m_per_s2 == 0 && s.analysis.gravity_tilt_deg != 0; },
     "gravity_m_per_s2 above 0"},
    {"contact", "initial_penalty_n_per_m2",
     [](const Scene& s) { return s.contact.formulation == ContactFormulation::penalty; },
     "formulation = \"augmented-lagrangian\""},
    {"contact", "penetration_tolerance_m",
     [](const Scene& s) { return s.contact.formulation == ContactFormulation::penalty; },
     "formulation = \"augmented-lagrangian\" or \"lagrange-multiplier\""},
    {"water", "atmospheric_pressure_pa",
     [](const Scene& s) { return !dry(s) && s.water.atmosphere == Atmosphere::none; }, "atmosphere = \"wet-faces\""},
    {"water", "open_crack_width_m", not_still_water, "model = \"hydrostatic\" in [fluid]"},
    {"water", "wets_ends", not_still_water, "model = \"hydrostatic\" in [fluid]"},
    {"water", "skip_unchanged", not_still_water, "model = \"hydrostatic\" in [fluid]"},
    {"water", "crest_pressure",
     [](const Scene& s) {
       return still_pools(s.fluid) && s.water.crest_pressure != CrestPressure::none && !s.water.may_overtop;
     },
     "may_overtop = true in [water]"},
    {"water", "uplift_in_shaking", [](const Scene& s) { return !dry(s) && (!s.base_motion || !still_pools(s.fluid)); },
     "[base_motion], and model = \"hydrostatic\" or \"reservoir\" in [fluid]"},
    {"coupling", "load_in_window", answers_ahead,
     "compressible = false: water with sound looks a window ahead, and has the pressures of the window's end"},
    {"output", "reservoir", [](const Scene& s) { return s.output.reservoir && (dry(s) || !still_pools(s.fluid)); },
     "[water], and model = \"hydrostatic\" or \"reservoir\" in [fluid]"},
};

void check_idle_keys(const Reading& reading) {
  for (const IdleKey& row : idle_keys) {
    const toml::node* node = reading.file[row.section][row.key].node();
    if (node == nullptr || !row.idle(reading.scene)) continue;
    reading.problems.warning(reading.problems.at(node->source()),
                             fmt::format("{} in [{}] has no effect in this scene", row.key, row.section), row.needs,
                             fmt::format("leave {} out, or state what it needs", row.key));
  }
  const toml::node* coupling = reading.file.get("coupling");
  if (coupling != nullptr && dry(reading.scene) && !reading.file.contains("water")) {
    reading.problems.warning(reading.problems.at(coupling->source()),
                             "[coupling] has no effect: the scene has no water", "[water] with a level",
                             "add [water], or leave [coupling] out");
  }
}

void check_materials(const Reading& reading) {
  const toml::table* materials = reading.file["material"].as_table();
  const Scene& scene = reading.scene;
  for (std::size_t m = 0; m < scene.materials.size() && materials != nullptr; ++m) {
    const std::string& name = scene.materials[m].name;
    const auto has_it = [&](const auto& made) { return made.material == static_cast<int>(m); };
    if (std::any_of(scene.blocks.begin(), scene.blocks.end(), has_it)) continue;
    if (std::any_of(scene.viscous_faces.begin(), scene.viscous_faces.end(), has_it)) continue;
    reading.problems.warning(reading.problems.at(materials->get(name)->source()),
                             fmt::format("[material.{}] has no effect: no block is of it", name),
                             "the material of some block", "name it in a block, or leave it out");
  }
}

/// Uplift where the water is a stranger's: what he sends is all that presses.
void check_strange_uplift(const Reading& reading) {
  const Scene& scene = reading.scene;
  const auto stated = [](const JointLaw& law) { return law.uplift != Uplift::none; };
  const auto joint =
      std::find_if(scene.joints.begin(), scene.joints.end(), [&](const Joint& j) { return stated(j.law); });
  if (!fluid_entry(scene.fluid).yours || (!stated(scene.default_joint) && joint == scene.joints.end())) return;
  const std::string whose = stated(scene.default_joint) ? "[joint]" : fmt::format("joint \"{}\"", joint->name);
  reading.problems.warning(reading.problems.at(0),
                           fmt::format("uplift of {} has no effect in a run with model = \"external\": only what the "
                                       "program sends presses, in joints, too",
                                       whose),
                           "uplift = \"none\", or panels of the joint's edges from the program",
                           "leave uplift out, and let the program press in its joints");
}

/// Pools that stay below all that can move, and cracks with uplift that no pool ever reaches.
void check_reach_of_water(const Reading& reading) {
  const Scene& scene = reading.scene;
  const auto about_water = [](const Expectation& e) {
    const QuantityEntry* quantity = find_entry(quantities(), e.quantity);
    return quantity != nullptr && quantity->needs == Need::water;
  };
  const auto& expected = scene.expectations;
  if (!still_pools(scene.fluid) || std::any_of(expected.begin(), expected.end(), about_water)) return;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Block& block : scene.blocks) {
    if (!block.fixed) lowest = std::min(lowest, geometry::bounds_of(block.vertices).low.y());
  }
  double level = -std::numeric_limits<double>::infinity();
  const auto look = [&](const char* key, const std::optional<TimeTable>& pool) {
    if (!pool) return;
    const double high = highest(*pool, scene.analysis.duration_s);
    level = std::max(level, high);
    if (!std::isfinite(lowest) || high >= lowest) return;
    reading.problems.warning(
        reading.problems.at(reading.file["water"][key].node()->source()),
        fmt::format(
            "{} has no effect at the start: the level stays below {} m, and all blocks that can move are above {} m",
            key, high, lowest),
        "a level that reaches a block that can move", fmt::format("raise the level, or leave {} out", key));
  };
  look("upstream_level_m", scene.water.upstream_level_m);
  look("downstream_level_m", scene.water.downstream_level_m);
  const toml::array* stated = reading.file["joints"].as_array();
  if (stated == nullptr) return;
  const double touching_m = 0.5e-6 * structure_size_m(scene.blocks);
  const std::size_t first = scene.joints.size() - std::min(stated->size(), scene.joints.size());
  for (std::size_t j = first; j < scene.joints.size(); ++j) {
    const toml::table* table = (*stated)[j - first].as_table();
    const Joint& joint = scene.joints[j];
    if (table == nullptr || !table->contains("uplift") || joint.law.uplift == Uplift::none) continue;
    const auto trace = trace_joint(scene.blocks[at(joint.between[0])], scene.blocks[at(joint.between[1])], touching_m);
    double foot = std::numeric_limits<double>::infinity();
    for (const TracePiece& piece : trace.pieces) foot = std::min({foot, piece.from_m.y(), piece.to_m.y()});
    if (!std::isfinite(foot) || level > foot) continue;
    reading.problems.warning(
        reading.problems.at(table->get("uplift")->source()),
        fmt::format("uplift in [[joints]] \"{}\" has no effect: the water stays below {} m, the joint is above {} m",
                    joint.name, level, foot),
        "a level above the joint's lowest end", "raise the level, or set uplift = \"none\"");
  }
}

/// Ground that shakes: a record that ends before the run, and still water that does not answer.
void check_base_motion(const Reading& reading) {
  const Scene& scene = reading.scene;
  if (!scene.base_motion) return;
  const toml::table* stated = reading.file["base_motion"].as_table();
  const auto look = [&](const char* key, const TimeTable& a) {
    const toml::node* node = stated == nullptr ? nullptr : stated->get(key);
    if (node == nullptr || a.value.size() < 2 || a.value.back() == 0 || a.time_s.back() >= scene.analysis.duration_s) {
      return;
    }
    reading.problems.warning(
        reading.problems.at(node->source()),
        fmt::format("{} ends at {:.4g} s with {:.4g} m/s2, which then acts to the end of the run, {:.4g} s", key,
                    a.time_s.back(), a.value.back(), scene.analysis.duration_s),
        "a last value of 0, or rows to the end", "add a row of 0, or shorten duration_s");
  };
  look("acceleration_x_m_per_s2", scene.base_motion->acceleration_x_m_per_s2);
  look("acceleration_y_m_per_s2", scene.base_motion->acceleration_y_m_per_s2);
  if (!still_pools(scene.fluid) || stated == nullptr) return;
  if (scene.fluid == FluidModel::hydrostatic) {
    reading.problems.warning(reading.problems.at(stated->source()),
                             "still water has no inertia: the hydrodynamic pressure of the ground's motion is left out",
                             "model = \"reservoir\" in [fluid], whose water answers, or model = \"openfoam\"",
                             "take one of both, or know that the water's part is missing");
  }
  const bool grounded = std::any_of(scene.blocks.begin(), scene.blocks.end(), [](const Block& b) { return b.fixed; });
  const bool lifts = scene.base_motion->form == BaseForm::support && stated->contains("acceleration_y_m_per_s2");
  if (grounded || !lifts) return;
  reading.problems.warning(
      reading.problems.at(stated->source()), "the water does not rise and fall with the ground: no block is fixed",
      "a fixed block, whose motion the levels follow", "state form = \"inertia\", or add the ground");
}

void check_anything_happens(const Reading& reading) {
  const Scene& scene = reading.scene;
  const auto fixed = [](const Block& block) { return block.fixed; };
  const bool asked = !scene.expectations.empty() || !scene.water_expectations.empty();
  if (asked || !std::all_of(scene.blocks.begin(), scene.blocks.end(), fixed)) return;
  if (dry(scene)) {
    reading.problems.warning(reading.problems.at(0), "nothing can happen: all blocks are fixed, and there is no water",
                             "a block that is not fixed, or [water]", "free the structure's blocks");
    return;
  }
  // Such a structure "stands" at any level.
  reading.problems.warning(reading.problems.at(0),
                           "nothing can move: all blocks are fixed, and no [[expect]] asks for the water's loads",
                           "a block that is not fixed, or an [[expect]]", "free the structure's blocks");
}

}  // namespace

double highest(const TimeTable& level, double duration_s) {
  double high = std::max(level.rows_at(0), level.rows_at(duration_s));
  for (std::size_t i = 0; i < level.time_s.size(); ++i) {
    if (level.time_s[i] >= 0 && level.time_s[i] <= duration_s) high = std::max(high, level.value[i]);
  }
  return high + (level.sine ? std::abs(level.sine->amplitude) : 0);
}

void check_effects(const Reading& reading) {
  check_idle_keys(reading);
  check_materials(reading);
  check_reach_of_water(reading);
  check_strange_uplift(reading);
  check_base_motion(reading);
  check_anything_happens(reading);
}

}  // namespace blockweir::scene
