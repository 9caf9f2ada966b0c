// SPDX-License-Identifier: GPL-3.0-or-later
// How the run goes: analysis, contact, coupling, output, and what it is expected to give.
#include <fmt/format.h>

#include <cmath>

#include "bridge/scene/sections.hpp"

namespace blockweir::scene {
namespace {

void reject_longer_than_duration(TableReader& table, Reading& reading, const char* key, double value) {
  const double duration = reading.scene.analysis.duration_s;
  if (value <= duration) return;
  reading.problems.error(table.place(key), fmt::format("{} {} is longer than duration_s {}", key, value, duration),
                         "a time within the duration", fmt::format("shorten {} or lengthen duration_s", key));
}

}  // namespace

void read_analysis(Reading& reading) {
  const toml::table* section = reading.section("analysis");
  TableReader table(reading.problems, section, "[analysis]");
  Analysis& a = reading.scene.analysis;
  table.choice<AnalysisKind>("kind", a.kind,
                             {{"dynamic", AnalysisKind::dynamic}, {"quasi-static", AnalysisKind::quasi_static}});
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
  if (duration) reject_longer_than_duration(table, reading, "step_s", a.step_s);
}

void read_contact(Reading& reading) {
  TableReader table(reading.problems, reading.section("contact"), "[contact]");
  Contact& c = reading.scene.contact;
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
  table.number("timeout_s", c.timeout_s, positive());
}

void read_output(Reading& reading) {
  TableReader table(reading.problems, reading.section("output"), "[output]");
  table.number("frame_every_s", reading.scene.output.frame_every_s, positive());
  table.number("history_every_s", reading.scene.output.history_every_s, positive());
  table.flag("reservoir", reading.scene.output.reservoir);
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
  Names named("block or joint");
  for (const Block& block : reading.scene.blocks) named.add(block.name);
  for (const Joint& joint : reading.scene.joints) named.add(joint.name);
  for (const Arch& arch : reading.scene.arches) named.add(arch.name);
  reading.each("expect", [&](TableReader& table) {
    Expectation e;
    table.text("quantity", e.quantity, true);
    table.number("value", e.value);
    table.text("word", e.word);
    table.text("formula", e.formula);
    table.text("of", e.of);
    table.number("tolerance", e.tolerance, positive());
    table.text("source", e.source);
    if (table.has("of") && !e.of.empty()) static_cast<void>(table.reference("of", named));
    require_one_answer(table, reading);
    reading.scene.expectations.push_back(std::move(e));
  });
}

void read_variants(Reading& reading) {
  Names names("variant");
  reading.each("variant", [&](TableReader& table) {
    Variant variant;
    table.text("name", variant.name, true);
    table.texts("set", variant.set);
    if (!variant.name.empty() && !names.add(variant.name)) {
      reading.problems.error(table.place("name"), fmt::format("a second variant is called \"{}\"", variant.name),
                             "names that differ", "rename one of them");
    }
    reading.scene.variants.push_back(std::move(variant));
  });
}

}  // namespace blockweir::scene
