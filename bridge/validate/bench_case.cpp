// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/validate/bench_case.hpp"

#include <fmt/format.h>

#include "bridge/scene/read/collected_errors.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::study {
namespace {

/// `kind`: [[bench]] or [[order]].
template <class Curve>
void add_curve(BenchCase& bench, const char* kind, const Curve& curve, scene::Sweep sweep, bool brief) {
  if (brief && sweep.values.size() > 2) sweep.values = {sweep.values.front(), sweep.values.back()};
  for (const std::string& value : sweep.values) {
    const std::string key_and_value = sweep.key + "=" + value;
    bench.settings.push_back(
        {curve.name,
         key_and_value,
         {fmt::format("{} \"{}\"", kind, curve.name), curve.line, joined(curve.set, {key_and_value})}});
  }
}

bool is_first(const scene::Scene& scene, const scene::Expectation& expected) {
  if (scene.expectations.empty()) return false;
  const scene::Expectation& first = scene.expectations.front();
  return expected.quantity == first.quantity && expected.of == first.of;
}

void add_orders_of_first_figure(BenchCase& bench, const scene::Scene& scene, bool brief) {
  for (const scene::OrderStudy& order : scene.studies.orders) {
    if (!is_first(scene, order.expected)) continue;
    scene::Sweep sweep{order.key, {}};
    for (const double value : order.values) sweep.values.push_back(fmt::format("{}", value));
    add_curve(bench, "[[order]]", order, sweep, brief);
  }
}

void require_figure(const scene::Scene& scene, scene::CollectedErrors& wrong) {
  if (scene.studies.bench_motion || !scene.expectations.empty() || !scene.water_expectations.empty()) return;
  const scene::Bench& first = scene.studies.benches.front();
  wrong.add({scene::Diagnostic::Severity::error, scene.file.string(), first.line,
             fmt::format("[[bench]] \"{}\" finds no figure whose error could be measured", first.name),
             "a scene with an [[expect]]", "add one"});
}

}  // namespace

BenchCase bench_case(const std::filesystem::path& path, const Settings& overrides, bool brief) {
  const scene::Scene scene = scene::read(path, overrides).scene;
  BenchCase bench{.scene = path, .settings = {{"as it stands", ""}}};
  for (const scene::Bench& b : scene.studies.benches) add_curve(bench, "[[bench]]", b, b.sweep, brief);
  if (bench.settings.size() == 1) return bench;
  const auto& motion = scene.studies.bench_motion;
  if (!motion) add_orders_of_first_figure(bench, scene, brief);
  if (scene.fluid == scene::FluidModel::hydrostatic)
    bench.settings.push_back({"compute still water in the solid's process", one_process, {}, {}, true});
  scene::CollectedErrors wrong;
  require_figure(scene, wrong);
  const Settings end = motion ? Settings{setting("analysis.duration_s", motion->until_s)} : Settings{};
  for (BenchSetting& one : bench.settings) {
    one.all = joined(joined(overrides, one.entry.settings), end);
    wrong.from([&] { scene::read_entry(path, one.entry, one.all); });
  }
  if (motion) {
    bench.finer_steps = BenchSetting{fmt::format("steps {} times smaller", motion->finer), ""};
    bench.finer_steps->all =
        joined(joined(overrides, end), {setting("analysis.step_s", scene.analysis.step_s / motion->finer)});
    wrong.from([&] { scene::read(path, bench.finer_steps->all); });
  }
  wrong.report();
  return bench;
}

}  // namespace blockweir::study
