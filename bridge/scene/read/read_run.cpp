// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the settings of a run: analysis, contact, coupling, output, and expected results.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/fluid_models.hpp"
#include "bridge/scene/quantity_table.hpp"
#include "bridge/scene/read/unique_file_names.hpp"
#include "bridge/scene/water_answers.hpp"

namespace blockweir::scene {
namespace {

constexpr double patience_with_people_s = 600;  // who start an external fluid by hand

void reject_longer_than_duration(TableReader& table, Reading& reading, const char* key, double value) {
  const double duration = reading.scene.analysis.duration_s;
  if (value <= duration) return;
  reading.problems.error(table.place(key), fmt::format("{} {} is longer than duration_s {}", key, value, duration),
                         "a time within the duration", fmt::format("shorten {} or lengthen duration_s", key));
}

/// at_m; the point is on the block that `of` names.
void read_point(TableReader& table, Reading& reading, Expectation& e) {
  Point point;
  if (!table.point("at_m", point)) return;
  e.at_m = point;
  const auto& blocks = reading.scene.blocks;
  const auto block = std::find_if(blocks.begin(), blocks.end(), [&](const Block& b) { return b.name == e.of; });
  if (block == blocks.end()) {
    reading.problems.error(table.place("at_m"), fmt::format("{} has at_m and no block", table.name()),
                           "of = the block that has the point", "name the block");
  } else if (!block->vertices.empty() &&
             !geometry::holds_point(block->vertices, point, 1e-6 * geometry::bounds_of(block->vertices).size())) {
    reading.problems.error(
        table.place("at_m"),
        fmt::format("at_m ({}, {}) in {} is outside block \"{}\"", point.x(), point.y(), table.name(), block->name),
        "a point in the block or on its outline", "move the point or name the block that it is on");
  }
}

}  // namespace

void read_analysis(Reading& reading) {
  const toml::table* section = reading.section("analysis");
  TableReader table(reading.problems, section, "[analysis]");
  Analysis& a = reading.scene.analysis;
  table.choice<AnalysisKind>("kind", a.kind,
                             {{"dynamic", AnalysisKind::dynamic},
                              {"quasi-static", AnalysisKind::quasi_static},
                              {"static", AnalysisKind::at_rest}});
  table.choice<Integrator>("integrator", a.integrator,
                           {{"shi", Integrator::shi},
                            {"trapezoidal", Integrator::trapezoidal},
                            {"generalized-alpha", Integrator::generalized_alpha}});
  table.number("spectral_radius", a.spectral_radius,
               {[](double rho) { return rho >= 0 && rho <= 1; }, "a number from 0 to 1"});
  table.choice<Plane>("plane", a.plane, {{"strain", Plane::strain}, {"stress", Plane::stress}});
  table.choice<Start>("start", a.start, {{"equilibrium", Start::equilibrium}, {"unstressed", Start::unstressed}});
  const bool duration = table.number("duration_s", a.duration_s, positive(), true);
  table.number("step_s", a.step_s, positive());
  table.number("max_displacement_ratio", a.max_displacement_ratio, positive());
  table.number("gravity_m_per_s2", a.gravity_m_per_s2, not_negative());
  table.number("gravity_tilt_deg", a.gravity_tilt_deg,
               {[](double tilt) { return std::abs(tilt) <= 90; }, "an angle from -90 to 90 degrees"});
  table.number("mass_damping_per_s", a.mass_damping_per_s, not_negative());
  table.number("rest_speed_m_per_s", a.rest_speed_m_per_s, positive());
  table.number("failure_displacement_m", a.failure_displacement_m, positive());
  table.flag("stop_at_failure", a.stop_at_failure);
  table.flag("stop_at_breach", a.stop_at_breach);
  table.number("residual_tolerance", a.residual_tolerance, positive());
  table.flag("islands", a.islands);
  table.flag("sleep", a.sleep);
  table.flag("skip_searches", a.skip_searches);
  table.flag("reuse_factors", a.reuse_factors);
  table.choice<Rigid>(
      "rigid", a.rigid,
      {{"named", Rigid::named}, {"auto", Rigid::automatic}, {"all", Rigid::all}, {"none", Rigid::none}});
  if (duration) reject_longer_than_duration(table, reading, "step_s", a.step_s);
}

void read_contact(Reading& reading) {
  TableReader table(reading.problems, reading.section("contact"), "[contact]");
  Contact& c = reading.scene.contact;
  table.choice<ContactFormulation>("formulation", c.formulation,
                                   {{"augmented-lagrangian", ContactFormulation::augmented_lagrangian},
                                    {"lagrange-multiplier", ContactFormulation::lagrange_multiplier},
                                    {"penalty", ContactFormulation::penalty}});
  const auto only_for = [&](const char* key, ContactFormulation formulation, const char* name) {
    if (!table.has(key) || c.formulation == formulation) return;
    reading.problems.error(table.place(key), fmt::format("{} belongs to another formulation", key),
                           fmt::format("formulation = \"{}\" beside it", name),
                           fmt::format("leave {} out, or change the formulation", key));
  };
  only_for("stiffness_n_per_m2", ContactFormulation::penalty, "penalty");
  only_for("dashpot_ratio", ContactFormulation::penalty, "penalty");
  table.number("stiffness_n_per_m2", c.stiffness_n_per_m2, positive());
  table.number("dashpot_ratio", c.dashpot_ratio, not_negative());
  table.flag("measure_condition", c.measure_condition);
  table.number("initial_penalty_n_per_m2", c.initial_penalty_n_per_m2, positive());
  table.number("penetration_tolerance_m", c.penetration_tolerance_m, positive());
  table.number("force_tolerance", c.force_tolerance, positive());
  table.integer("max_iterations", c.max_iterations, 1);
}

void read_coupling(Reading& reading) {
  TableReader table(reading.problems, reading.section("coupling"), "[coupling]");
  Coupling& c = reading.scene.coupling;
  c.window_s = reading.scene.analysis.step_s;
  if (table.number("window_s", c.window_s, positive())) {
    reject_longer_than_duration(table, reading, "window_s", c.window_s);
  }
  table.choice<Schedule>(
      "schedule", c.schedule,
      {{"serial", Schedule::serial}, {"parallel", Schedule::parallel}, {"improved", Schedule::improved}});
  if (c.schedule == Schedule::improved) c.load_in_window = LoadInWindow::linear;  // its second order hangs on it
  table.choice<LoadInWindow>(
      "load_in_window", c.load_in_window,
      {{"held", LoadInWindow::held}, {"linear", LoadInWindow::linear}, {"quadratic", LoadInWindow::quadratic}});
  if (table.number("longest_window_s", c.longest_window_s, positive())) {
    reject_longer_than_duration(table, reading, "longest_window_s", c.longest_window_s);
    if (c.longest_window_s < c.window_s) {
      reading.problems.error(table.place("longest_window_s"),
                             fmt::format("longest_window_s {} under window_s {}", c.longest_window_s, c.window_s),
                             "the longest window, at least as long as the shortest", "leave it out, or lengthen it");
    }
  }
  if (reading.scene.analysis.kind == AnalysisKind::at_rest && c.schedule != Schedule::serial) {
    reading.problems.error(table.place("schedule"), "a schedule in a static analysis", "schedule = \"serial\"",
                           "leave schedule out: without time the sides take turns");
  }
  c.timeout_s = fluid_entry(reading.scene.fluid).timeout_s;
  const bool by_hand = fluid_entry(reading.scene.fluid).yours && reading.scene.external.command.empty();
  table.number("timeout_s", c.timeout_s, positive());
  c.open_timeout_s = by_hand ? std::max(c.timeout_s, patience_with_people_s) : c.timeout_s;
  table.flag("skip_exchanges", c.skip_exchanges);
  table.flag("added_mass_guard", c.added_mass_guard);
  table.number("added_mass_limit", c.added_mass_limit, positive());
  table.choice<EnergyGain>("on_energy_gain", c.on_energy_gain,
                           {{"stop", EnergyGain::stop}, {"report", EnergyGain::report}});
  if (answers_ahead(reading.scene)) c.load_in_window = LoadInWindow::held;  // it is that of the window's end
}

void read_output(Reading& reading) {
  TableReader table(reading.problems, reading.section("output"), "[output]");
  table.number("frame_every_s", reading.scene.output.frame_every_s, positive());
  table.number("history_every_s", reading.scene.output.history_every_s, positive());
  table.flag("reservoir", reading.scene.output.reservoir);
  table.number("checkpoint_every_s", reading.scene.output.checkpoint_every_s, not_negative());
}

void require_one_answer(TableReader& table, Reading& reading) {
  std::vector<std::string> given;
  for (const char* answer : {"value", "word", "formula"}) {
    if (table.has(answer)) given.emplace_back(answer);
  }
  if (given.size() == 1) return;
  reading.problems.error(table.place(),
                         fmt::format("{} has {}", table.name(),
                                     given.empty() ? "no answer" : fmt::format("both {} and {}", given[0], given[1])),
                         "exactly one of value, word and formula",
                         "give a number or a word, or the name of the formula that yields it");
}

void read_expectations(Reading& reading) {
  Names named("block, joint or bolt");
  for (const Block& block : reading.scene.blocks) named.add(block.name);
  for (const Joint& joint : reading.scene.joints) named.add(joint.name);
  for (const Bolt& bolt : reading.scene.bolts) named.add(bolt.name);
  for (const Arch& arch : reading.scene.arches) named.add(arch.name);
  reading.each("expect", [&](TableReader& table) {
    Expectation e;
    table.word("quantity", e.quantity, quantity_names(), true);
    table.number("value", e.value);
    table.text("word", e.word);
    table.word("formula", e.formula, formula_names());
    table.text("of", e.of);
    read_point(table, reading, e);
    table.number("tolerance", e.tolerance, positive());
    table.text("source", e.source);
    const bool known = e.of.empty() || table.reference("of", named) >= 0;
    require_one_answer(table, reading);
    if (known) check_answer(table, reading, e);
    reading.scene.expectations.push_back(std::move(e));
  });
}

void read_variants(Reading& reading) {
  UniqueFileNames files("variant");
  reading.each("variant", [&](TableReader& table) {
    Variant variant{.line = table.place().line};
    table.text("name", variant.name, true);
    table.texts("set", variant.set);
    check_settings(table, reading, variant.set);
    files.add(reading, table, variant.name);
    reading.scene.variants.push_back(std::move(variant));
  });
}

}  // namespace blockweir::scene
