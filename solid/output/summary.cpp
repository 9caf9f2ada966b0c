// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/summary.hpp"

#include <fmt/format.h>

#include "bridge/scene/two_earthquakes.hpp"
#include "solid/output/checks.hpp"
#include "solid/output/held_level.hpp"
#include "solid/output/new_contacts.hpp"
#include "solid/output/pressing_corners.hpp"
#include "solid/output/verdict.hpp"
#include "solid/output/water_on_crest.hpp"

namespace blockweir::solid::output {
namespace {

using nlohmann::json;

/// Steps of many moving contacts end after a number of sweeps: empty where what these left is little against a failure.
std::string residual_warning(const scene::Scene& scene, const Counts& counts) {
  constexpr double most = 0.1;
  if (counts.residual_m <= most * scene.analysis.failure_displacement_m) return {};
  return fmt::format(
      "in a step with many moving contacts, gaps and slips are off by {:.3g} m; expected at most {:.3g} m, {:g} of "
      "[analysis] failure_displacement_m; the positions of moving blocks are no more accurate than that; try another "
      "[analysis] step_s (now {:.3g}): a shorter one is often better, but not always",
      counts.residual_m, most * scene.analysis.failure_displacement_m, most, scene.analysis.step_s);
}

/// What brings blocks that were in each other apart, and why.
std::string overlap_remedy(const expect::Outcome& outcome) {
  const scene::Scene& scene = outcome.solid.scene();
  const double give_m = outcome.solid.model().give_under_weight_m;
  const std::string other = ", or take formulation = \"augmented-lagrangian\" in [contact]";
  if (scene.contact.formulation == scene::ContactFormulation::penalty) {
    const auto& stated = scene.contact.stiffness_n_per_m2;
    const std::string chosen = stated ? fmt::format("the scene has chosen {:.3g} N/m2", *stated)
                                      : "the scene states none, and the default is 40 times the largest modulus";
    return "raise [contact] stiffness_n_per_m2, of the springs at contacts (" + chosen + ")" + other;
  }
  const bool solves_for_forces = scene.contact.formulation == scene::ContactFormulation::lagrange_multiplier;
  const std::string remedy =
      fmt::format("shorten [analysis] step_s (now {:.3g})", scene.analysis.step_s) + (solves_for_forces ? other : "");
  if (give_m == 0) return remedy;
  const std::string stiffer = fmt::format(
      "blocks strain, and their corners may be in each other by up to {:.3g} m, less with a stiffer material; state "
      "rigid = \"all\" in [analysis] where strains do not matter",
      give_m);
  return outcome.deepest_m() <= give_m ? stiffer : remedy + "; " + stiffer;
}

/// Overlaps beyond what counts as one.
std::string penetration_warning(const expect::Outcome& outcome) {
  if (outcome.deepest_m() <= outcome.most_penetration_m()) return {};
  return fmt::format(
      "blocks were in each other by up to {:.3g} m; expected at most {:.3g} m, 1e-4 of the model's size; {}",
      outcome.deepest_m(), outcome.most_penetration_m(), overlap_remedy(outcome));
}

json counts_of(const Solid& solid) {
  const Counts counts = solid.counts();
  return {{"steps", counts.steps},
          {"undone_steps", counts.undone_steps},
          {"substituted_steps", counts.substituted_steps},
          {"lagged_steps", counts.lagged_steps},
          {"impact_steps", counts.impact_steps},
          {"swept_islands", counts.swept_islands},
          {"iterations", counts.iterations},
          {"factorizations", counts.factorizations},
          {"reused_factorizations", counts.reused_factorizations},
          {"multiplier_sweeps", counts.sweeps},
          {"state_changes", counts.state_changes},
          {"searches", counts.searches},
          {"broad_searches", counts.broad_searches},
          {"skipped_searches", counts.skipped_searches},
          {"settling_steps", counts.settling_steps},
          {"solved_islands", counts.solved_islands},
          {"slept_islands", counts.slept_islands},
          {"blocks", solid.described()},
          {"triangles", solid.blocks().size() - solid.described()},
          {"contacts", solid.contacts().size()}};
}

void add_added_mass(const expect::Outcome& outcome, json& text) {
  const AddedMassWatch& added = outcome.added_mass;
  if (added.ratio() <= 0) return;
  const bool guarded = outcome.solid.scene().coupling.added_mass_guard;
  text["added_mass"] = {{"ratio", added.ratio()},
                        {"block", added.block()},
                        {"guarded", guarded},
                        {"text", fmt::format("added mass {:.3g} of block \"{}\"'s own ({})", added.ratio(),
                                             added.block(), guarded ? "guarded" : "no guard")}};
}

void add_warnings(const expect::Outcome& outcome, json& warnings) {
  const scene::Scene& scene = outcome.solid.scene();
  if (const auto twice = scene::two_earthquakes(scene)) warnings.push_back(twice->message());
  for (const std::string& warning :
       {outcome.energy.warning(outcome.solid), residual_warning(scene, outcome.solid.counts()),
        penetration_warning(outcome), outcome.edge_tension.warning(), outcome.strain.warning(outcome.solid),
        new_contacts_warning(outcome), pressing_corners_warning(outcome), water_on_crest_warning(outcome),
        held_level_warning(outcome), outcome.margins.opened().warning(scene), outcome.added_mass.warning(scene),
        outcome.interface_energy.warning()}) {
    if (!warning.empty()) warnings.push_back(warning);
  }
}

void add_interface_energy(const expect::Outcome& outcome, json& text) {
  const InterfaceEnergy& exchanged = outcome.interface_energy;
  if (!exchanged.looked()) return;
  text["interface_energy"] = {{"made_j_per_m", exchanged.made_j_per_m()},
                              {"water_work_j_per_m", outcome.solid.state().water_work.sum_j_per_m()},
                              {"grows", exchanged.growth().has_value()}};
  if (const auto& growth = exchanged.growth()) {
    text["interface_energy"]["window"] = growth->window;
    text["interface_energy"]["time_s"] = growth->time_s;
    text["interface_energy"]["text"] = exchanged.trouble(outcome.added_mass.ratio());
  }
}

}  // namespace

json summary(const expect::Outcome& outcome) {
  const scene::Scene& scene = outcome.solid.scene();
  const Counts counts = outcome.solid.counts();
  json text = {{"title", scene.title},
               {"version", BLOCKWEIR_VERSION},
               {"scene_digest", scene.digest},
               {"simulated_s", outcome.last.time_s},
               {"largest_displacement_m", outcome.last.largest_displacement_m},
               {"largest_penetration_m", outcome.largest_penetration_m},
               {"largest_overlap_m", counts.overlap_m},
               {"largest_residual_m", counts.residual_m},
               {"warnings", scene.warnings},
               {"checks", checks(outcome)},
               {"skips", skips(outcome.solid, outcome.frames)},
               {"counts", counts_of(outcome.solid)}};
  if (scene.base_motion && !scene.base_motion->correction.empty()) {
    text["base_motion"] = {{"text", scene.base_motion->correction}};
  }
  if (scene.contact.measure_condition) text["largest_condition_number"] = counts.condition_number;
  add_added_mass(outcome, text);
  text["energy_gain"] = outcome.energy.gain();
  add_warnings(outcome, text["warnings"]);
  add_interface_energy(outcome, text);
  add_verdict(outcome, text);
  return text;
}

}  // namespace blockweir::solid::output
