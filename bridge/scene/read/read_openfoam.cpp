// SPDX-License-Identifier: GPL-3.0-or-later
// [fluid] model = "openfoam": what interFoam's case is made of, and the figures that its water must give.
#include <fmt/format.h>

#include <toml++/toml.h>

#include <algorithm>
#include <thread>

#include "bridge/scene/read/nearest.hpp"
#include "bridge/scene/read/reading.hpp"
#include "bridge/scene/water_quantities.hpp"

namespace blockweir::scene {
namespace {

/// Of the case that is written from the scene: a case of one's own has its mesh and its water.
constexpr const char* case_keys[] = {"cells_in_depth", "upstream_depths",       "downstream_depths", "freeboard_depths",
                                     "floor_m",        "air_density_kg_per_m3", "initial_water_m",   "wave"};
constexpr const char* run_keys[] = {"case",           "processes",        "reconstruct",
                                    "max_courant",    "steps_per_window", "level_control",
                                    "move_tolerance", "rest_tolerance"};

void read_wave(TableReader& fluid, Reading& reading) {
  const toml::table* section = fluid.table("wave");
  if (section == nullptr) return;
  TableReader table(reading.problems, section, "[fluid] wave");
  Wave wave;
  table.choice<WaveKind>("kind", wave.kind, {{"regular", WaveKind::regular}, {"solitary", WaveKind::solitary}});
  table.number("height_m", wave.height_m, positive(), true);
  table.number("period_s", wave.period_s, positive(), wave.kind == WaveKind::regular);
  reading.scene.openfoam.wave = wave;
}

void read_initial_water(TableReader& table, Reading& reading) {
  auto& outlines = reading.scene.openfoam.initial_water_m;
  if (!table.outlines("initial_water_m", outlines)) return;
  reading.scene.openfoam.initial_water_line = table.place("initial_water_m").line;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    mend_outline(outlines[i], fmt::format("outline {} of initial_water_m", i + 1), reading.problems,
                 [&](std::size_t) { return table.place("initial_water_m", i); });
  }
}

void check_own_case(TableReader& table, Reading& reading) {
  if (!table.has("case")) return;
  if (reading.scene.openfoam.own_case.empty()) {
    reading.problems.error(table.place("case"), "case names no folder", "an OpenFOAM case, relative to this file",
                           "name its folder, or leave case out: one is then written from the scene");
  }
  for (const char* key : case_keys) {
    if (!table.has(key)) continue;
    reading.problems.error(table.place(key), fmt::format("{} beside case", key),
                           "one of them: a case of your own has its mesh, its air and its water",
                           fmt::format("leave {} out, or case", key));
  }
  if (reading.scene.openfoam.level_control == LevelControl::inflow) {
    reading.problems.error(table.place("level_control"), "inflow beside case",
                           "\"free\" or \"table\": the ends of a case of your own are its own",
                           "leave level_control out");
  }
}

/// What interFoam cannot do is said before it starts.
void check(TableReader& table, Reading& reading) {
  const Scene& scene = reading.scene;
  const auto refuse = [&](const char* found, const char* expected, const char* remedy) {
    reading.problems.error(table.place("model"), found, expected, remedy);
  };
  if (scene.analysis.kind == AnalysisKind::at_rest) {
    refuse("OpenFOAM in a static analysis", "kind = \"dynamic\" or \"quasi-static\"",
           "change kind in [analysis], or use model = \"hydrostatic\"");
  }
  if (scene.water.atmosphere == Atmosphere::wet_faces) {
    refuse("OpenFOAM with atmosphere = \"wet-faces\"", "atmosphere = \"none\"",
           "leave atmosphere out of [water], or use model = \"hydrostatic\"");
  }
  if (scene.base_motion && scene.base_motion->form == BaseForm::support) {
    refuse("OpenFOAM with a base motion that moves the supports", "form = \"inertia\" in [base_motion]",
           "change the form: the mesh then moves with the ground");
  }
  if (scene.openfoam.wave && !scene.water.upstream_level_m) {
    refuse("a wave, but no upstream level", "upstream_level_m in [water]", "state the still-water level");
  }
  const LevelControl control = scene.openfoam.level_control;
  if (control == LevelControl::inflow && !scene.openfoam.wave && !scene.water.upstream_level_m &&
      !scene.water.downstream_level_m) {
    reading.problems.error(table.place("level_control"), "inflow without a level to follow",
                           "upstream_level_m or downstream_level_m in [water]",
                           "state a level, or use level_control = \"free\"");
  }
  if (scene.openfoam.wave && control == LevelControl::table) {
    reading.problems.error(table.place("level_control"), "a wave in water whose level is set in every window",
                           "level_control = \"inflow\" or \"free\"", "leave level_control out");
  }
  if (comes_in(scene.openfoam) && control == LevelControl::free) {
    reading.problems.error(table.place("level_control"), "regular waves with a closed end",
                           "level_control = \"inflow\"", "leave level_control out");
  }
  if (scene.openfoam.rest_tolerance > 0 &&
      (scene.base_motion || comes_in(scene.openfoam) || !scene.openfoam.own_case.empty())) {
    reading.problems.error(table.place("rest_tolerance"),
                           "rest_tolerance beside a base motion, regular waves or a case of your own",
                           "water that nothing but its levels and the blocks can move", "leave rest_tolerance out");
  }
  if (scene.openfoam.reconstruct && scene.openfoam.processes == 1) {
    reading.problems.error(table.place("reconstruct"), "reconstruct with one process", "processes = 2 or more",
                           "leave reconstruct out: the results of one process are whole");
  }
  check_own_case(table, reading);
}

/// A figure that cannot be found is said before the run, not after it.
void check_water_quantity(TableReader& table, const Expectation& e, Reading& reading) {
  if (e.quantity.empty()) return;
  const auto known = std::find_if(water_quantities.begin(), water_quantities.end(),
                                  [&](const WaterQuantity& q) { return q.name == e.quantity; });
  if (known == water_quantities.end()) {
    std::vector<std::string> names;
    for (const WaterQuantity& q : water_quantities) names.emplace_back(q.name);
    reading.problems.error(table.place("quantity"),
                           fmt::format("{} names no quantity: \"{}\"", table.name(), e.quantity), one_of(names),
                           did_you_mean(e.quantity, names));
    return;
  }
  const auto refuse = [&](const char* without, const char* expected, const char* remedy) {
    reading.problems.error(table.place("quantity"), fmt::format("{} without {}", e.quantity, without), expected,
                           remedy);
  };
  if (known->of_block && e.of.empty()) refuse("of", "of = the block that the water presses on", "name the block");
  if (known->at_point && !e.at_m) refuse("at_m", "at_m = [x, y], where it arrives", "state the point");
  const auto refuse_idle = [&](const char* key) {
    reading.problems.error(table.place(key), fmt::format("{} has no effect on {}", key, e.quantity),
                           "keys that the quantity has", fmt::format("leave {} out, or use another quantity", key));
  };
  if (!known->of_block && !e.of.empty()) refuse_idle("of");
  if (!known->at_point && e.at_m) refuse_idle("at_m");
  if (known->regular_wave && !comes_in(reading.scene.openfoam)) {
    refuse("regular waves", "wave = { kind = \"regular\", ... } in [fluid]", "use another quantity");
  }
}

}  // namespace

void read_openfoam(TableReader& table, Reading& reading) {
  OpenFoam& o = reading.scene.openfoam;
  const Range ratio{[](double r) { return r > 0 && r <= 1; }, "a number above 0 and up to 1"};
  const Range tolerance{[](double t) { return t >= 0 && t <= 1e-3; }, "a number from 0 to 0.001"};
  table.text("case", o.own_case);
  table.integer("processes", o.processes, 1);
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  constexpr int many = 4;  // for each core: each process has a mesh of its own to begin with
  if (o.processes > many * cores) {
    reading.problems.warning(
        table.place("processes"),
        fmt::format("processes = {} in [fluid] on a machine of {} cores, which is unusual", o.processes, cores),
        fmt::format("up to {}", cores), "write as many as there are cores");
  }
  table.flag("reconstruct", o.reconstruct);
  table.integer("cells_in_depth", o.cells_in_depth, 4);
  table.number("upstream_depths", o.upstream_depths, positive());
  table.number("downstream_depths", o.downstream_depths, positive());
  table.number("freeboard_depths", o.freeboard_depths, positive());
  table.number("floor_m", o.floor_m);
  table.number("air_density_kg_per_m3", o.air_density_kg_per_m3, positive());
  table.number("max_courant", o.max_courant, ratio);
  table.integer("steps_per_window", o.steps_per_window, 1);
  table.number("move_tolerance", o.move_tolerance, tolerance);
  table.number("rest_tolerance", o.rest_tolerance, tolerance);
  read_initial_water(table, reading);
  read_wave(table, reading);
  if (o.wave) o.level_control = comes_in(o) ? LevelControl::inflow : LevelControl::free;
  if (!o.own_case.empty()) o.level_control = LevelControl::free;
  table.choice<LevelControl>(
      "level_control", o.level_control,
      {{"table", LevelControl::table}, {"free", LevelControl::free}, {"inflow", LevelControl::inflow}});
  if (reading.scene.fluid == FluidModel::openfoam) return check(table, reading);
  const auto refuse = [&](const char* key) {
    if (!table.has(key)) return;
    reading.problems.error(table.place(key), fmt::format("{} without OpenFOAM", key), "model = \"openfoam\" beside it",
                           fmt::format("leave {} out, or set model = \"openfoam\"", key));
  };
  for (const char* key : run_keys) refuse(key);
  for (const char* key : case_keys) refuse(key);
}

void read_water_expectations(Reading& reading) {
  Names blocks("block");
  for (const Block& block : reading.scene.blocks) blocks.add(block.name);
  reading.each("expect_water", [&](TableReader& table) {
    Expectation e;
    table.text("quantity", e.quantity, true);
    table.number("value", e.value);
    table.text("of", e.of);
    Point at;
    if (table.point("at_m", at)) e.at_m = at;
    table.number("tolerance", e.tolerance, positive());
    table.text("source", e.source);
    if (table.has("of") && !e.of.empty()) static_cast<void>(table.reference("of", blocks));
    if (!e.value && table.present()) {
      reading.problems.error(table.place(), fmt::format("{} has no answer", table.name()), "value = a number",
                             "state the value that the quantity must have");
    }
    if (reading.scene.fluid != FluidModel::openfoam && table.present()) {
      reading.problems.error(table.place(), fmt::format("{} without OpenFOAM", table.name()),
                             "[fluid] model = \"openfoam\"", "only OpenFOAM's water moves: use [[expect]] for others");
    } else {
      check_water_quantity(table, e, reading);
    }
    reading.scene.water_expectations.push_back(std::move(e));
  });
}

}  // namespace blockweir::scene
