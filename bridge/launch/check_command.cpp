// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/reliability/refused_draws.hpp"
#include "bridge/results/counted.hpp"
#include "bridge/results/wrapped.hpp"
#include "bridge/scene/read/check.hpp"
#include "bridge/scene/read/collected_errors.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/scene/structure_size.hpp"
#include "bridge/scene/touching_pairs.hpp"
#include "bridge/study/load_case_scene.hpp"
#include "bridge/study/open_study.hpp"
#include "bridge/study/study.hpp"
#include "bridge/validate/bench.hpp"

namespace blockweir::launch {
namespace {

using results::counted;

struct CheckOptions {
  std::filesystem::path scene;
  std::vector<std::string> overrides;
  bool strict = false;
};

/// Adds the warnings of a variant or load case that the scene itself does not have; the entry is at `line`.
void add_warnings(const scene::ReadScene& read, const std::string& whose, int line,
                  std::vector<scene::Diagnostic> warnings, std::vector<scene::Diagnostic>& all) {
  for (scene::Diagnostic& warning : warnings) {
    const auto same = [&](const scene::Diagnostic& other) { return other.message() == warning.message(); };
    if (std::any_of(read.warnings.begin(), read.warnings.end(), same)) continue;
    if (warning.line != line) warning.found = fmt::format("{}: {}", whose, warning.found);
    all.push_back(std::move(warning));
  }
}

int check(const CheckOptions& options) {
  const std::filesystem::path& path = options.scene;
  const auto& overrides = options.overrides;
  const scene::ReadScene read = scene::read(path, overrides);
  std::vector<scene::Diagnostic> warnings = read.warnings;
  std::size_t studies = 0;
  scene::CollectedErrors wrong;  // of variants, load cases and studies: each is a scene of its own
  for (const scene::Variant& variant : read.scene.variants) {
    wrong.from([&] {
      add_warnings(read, fmt::format("variant \"{}\"", variant.name), variant.line,
                   scene::read_variant(path, variant.name, overrides).warnings, warnings);
    });
  }
  for (const scene::LoadCase& load_case : read.load_cases) {
    wrong.from([&] {
      const scene::ReadScene set = study::load_case_scene(load_case, path, overrides);
      add_warnings(read, fmt::format("load case \"{}\"", load_case.name), load_case.line, set.warnings, warnings);
      if (auto idle = study::idle_load_case(load_case, read.scene, set.scene)) warnings.push_back(std::move(*idle));
      for (auto& missed : study::missed_joints(load_case, set.scene)) warnings.push_back(std::move(missed));
    });
  }
  wrong.from([&] { studies += study::study_tasks(path, overrides).size(); });
  wrong.from([&] { studies += study::open_study_tasks(path, overrides, /*jobs=*/1).size(); });
  wrong.from([&] { study::bench_settings(path, overrides); });
  wrong.from([&] {
    for (auto& warning : study::refused_draws(path, read, overrides)) warnings.push_back(std::move(warning));
  });
  for (const auto& note : read.notes) fmt::print(stderr, "{}", results::for_stderr(note.text() + "\n"));
  if (!options.strict) {
    for (const auto& warning : warnings) fmt::print(stderr, "{}", results::for_stderr(warning.text() + "\n"));
  }
  wrong.report();
  if (options.strict) scene::refuse_warnings(warnings);
  const scene::Scene& s = read.scene;
  const auto touching = scene::touching_pairs(s, scene::rounding_ratio * scene::structure_size_m(s.blocks));
  const auto named = std::count_if(s.joints.begin(), s.joints.end(), [&](const scene::Joint& joint) {
    return touching.contains(std::minmax(joint.between[0], joint.between[1]));
  });
  const std::string sound = fmt::format(
      "{}: sound{}; {}, {} ({} with a name), {}, {}, {}, {} s in steps of {} s\n", s.file.string(),
      warnings.empty() ? "" : fmt::format(", with {} warning{}", warnings.size(), warnings.size() == 1 ? "" : "s"),
      counted(s.blocks.size(), "block"), counted(touching.size(), "joint"), named,
      counted(s.variants.size(), "variant"), counted(read.load_cases.size(), "load case"),
      counted(studies, "study", "studies"), s.analysis.duration_s, s.analysis.step_s);
  const std::string figures = fmt::format(
      "structure of {:.4g} m: failure_displacement_m = {:.3g}, rest_speed_m_per_s = {:.3g}, penetration_tolerance_m = "
      "{:.3g}{}\n",
      scene::structure_size_m(s.blocks), s.analysis.failure_displacement_m, s.analysis.rest_speed_m_per_s,
      s.contact.penetration_tolerance_m,
      s.fluid == scene::FluidModel::hydrostatic
          ? fmt::format(", open_crack_width_m = {:.3g}", s.water.open_crack_width_m)
          : "");
  fmt::print("{}", results::for_stdout(sound + figures));
  return 0;
}

}  // namespace

Work check_command(CLI::App& app) {
  const auto options = std::make_shared<CheckOptions>();
  app.add_option("scene", options->scene, "scene file or case folder")->required();
  app.add_option("--set", options->overrides, "set a key of the scene, as key=value");
  app.add_flag("--strict", options->strict, "treat warnings as errors");
  return [options] { return check(*options); };
}

}  // namespace blockweir::launch
