// SPDX-License-Identifier: GPL-3.0-or-later
// Reads studies: their runs and their expected results.
#include <fmt/format.h>

#include <cmath>

#include "bridge/scene/quantity_table.hpp"
#include "bridge/scene/read/unique_file_names.hpp"

namespace blockweir::scene {
namespace {

/// Studies of all kinds by their names, and what `of` may name.
struct Known {
  UniqueFileNames studies{"study"};
  Names parts{"block, joint or arch"};
};

/// Members common to all kinds; the quantity depends on the kind. False if `of` names nothing.
bool read_study(TableReader& table, Reading& reading, Known& known, Study& study) {
  Expectation& e = study.expected;
  study.line = table.place().line;
  table.text("name", study.name, true);
  table.texts_if_any("set", study.set);
  table.word("formula", e.formula, formula_names());
  table.text("of", e.of);
  table.text("source", e.source);
  known.studies.add(reading, table, study.name);
  return e.of.empty() || table.reference("of", known.parts) >= 0;
}

void read_limit(TableReader& table, Reading& reading, Known& known) {
  LimitStudy study;
  const bool named = read_study(table, reading, known, study);
  table.text("key", study.key, true);
  table.text("outcome", study.outcome);
  table.number("value", study.expected.value);
  require_one_answer(table, reading);
  if (named) check_answer(table, reading, study.expected);
  table.number("tolerance", study.expected.tolerance, positive());
  study.width = study.expected.tolerance / 4;
  table.number("width", study.width, positive());
  const bool begins = table.number("from", study.from, any_number(), true);
  const bool ends = table.number("to", study.to, any_number(), true);
  if (begins && ends && study.from == study.to) {
    reading.problems.error(table.place("to"),
                           fmt::format("{} looks for a limit from {} to {}", table.name(), study.from, study.to),
                           "two values, with the limit between them", "move one of them");
  }
  check_settings(table, reading, study.set, {study.key});
  reading.scene.studies.limits.push_back(std::move(study));
}

void read_order(TableReader& table, Reading& reading, Known& known) {
  OrderStudy study;
  const bool named = read_study(table, reading, known, study);
  table.text("key", study.key, true);
  table.numbers("values", study.values, positive(), 3);
  table.word("quantity", study.expected.quantity, quantity_names(), true);
  table.number("value", study.expected.value);
  require_one_answer(table, reading);
  if (named) check_answer(table, reading, study.expected);
  table.number("order", study.order, any_number(), true);
  table.number("tolerance", study.order_tolerance, positive());
  check_settings(table, reading, study.set, {study.key});
  reading.scene.studies.orders.push_back(std::move(study));
}

void read_map(TableReader& table, Reading& reading, Known& known) {
  MapStudy study;
  const bool named = read_study(table, reading, known, study);
  study.expected.quantity = "mode";
  table.word("quantity", study.expected.quantity, quantity_names());
  table.text("x_key", study.axes[0].key, true);
  table.settings("x_values", study.axes[0].values);
  table.text("y_key", study.axes[1].key, true);
  table.settings("y_values", study.axes[1].values);
  table.number("value", study.expected.value);
  table.text("word", study.expected.word);
  require_one_answer(table, reading);
  if (named) check_answer(table, reading, study.expected);
  table.number("tolerance", study.expected.tolerance, positive());
  table.integer("may_refuse", study.may_refuse, 0);
  table.number("longest_s", study.longest_s, positive());
  check_settings(table, reading, study.set, {study.axes[0].key, study.axes[1].key});
  reading.scene.studies.maps.push_back(std::move(study));
}

void read_bench(TableReader& table, Reading& reading, Known& known) {
  Bench bench{.line = table.place().line};
  table.text("name", bench.name, true);
  table.texts_if_any("set", bench.set);
  table.text("key", bench.sweep.key, true);
  table.settings("values", bench.sweep.values);
  known.studies.add(reading, table, bench.name);
  check_settings(table, reading, bench.set, {bench.sweep.key});
  reading.scene.studies.benches.push_back(std::move(bench));
}

void read_bench_motion(Reading& reading) {
  TableReader table(reading.problems, reading.section("bench_motion"), "[bench_motion]");
  if (!table.present()) return;
  BenchMotion motion;
  table.number("until_s", motion.until_s, positive(), true);
  table.integer("finer", motion.finer, 2);
  if (reading.scene.studies.benches.empty()) {
    reading.problems.error(table.place(), "[bench_motion] has no effect without a curve",
                           "a [[bench]] whose runs are compared", "add one, or leave [bench_motion] out");
  }
  reading.scene.studies.bench_motion = motion;
}

}  // namespace

void read_studies(Reading& reading) {
  Known known;
  known.studies.reserve("orders");
  for (const Block& block : reading.scene.blocks) known.parts.add(block.name);
  for (const Joint& joint : reading.scene.joints) known.parts.add(joint.name);
  for (const Arch& arch : reading.scene.arches) known.parts.add(arch.name);
  reading.each("limit", [&](TableReader& table) { read_limit(table, reading, known); });
  reading.each("order", [&](TableReader& table) { read_order(table, reading, known); });
  reading.each("map", [&](TableReader& table) { read_map(table, reading, known); });
  reading.each("bench", [&](TableReader& table) { read_bench(table, reading, known); });
  read_bench_motion(reading);
}

}  // namespace blockweir::scene
