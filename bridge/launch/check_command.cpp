// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/process/run.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/scene/structure_size.hpp"
#include "bridge/study/bench.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::launch {
namespace {

/// What a scene and its variants are warned of, each text once.
std::vector<scene::Diagnostic> all_warnings(const scene::ReadScene& read, const std::filesystem::path& path,
                                            const std::vector<std::string>& overrides) {
  std::vector<scene::Diagnostic> all = read.warnings;
  for (const auto& variant : read.scene.variants) {
    for (scene::Diagnostic warning : scene::read_variant(path, variant.name, overrides).warnings) {
      const auto same = [&](const scene::Diagnostic& other) { return other.message() == warning.message(); };
      if (std::any_of(read.warnings.begin(), read.warnings.end(), same)) continue;
      warning.found = fmt::format("variant \"{}\": {}", variant.name, warning.found);
      all.push_back(std::move(warning));
    }
  }
  return all;
}

int check(const std::filesystem::path& path, const std::vector<std::string>& overrides, bool strict) {
  const scene::ReadScene read = scene::read(path, overrides);
  const std::vector<scene::Diagnostic> warnings = all_warnings(read, path, overrides);
  if (strict) scene::refuse_warnings(warnings);
  const std::size_t studies = study::study_tasks(path, overrides).size();
  study::bench_settings(path, overrides);
  for (const auto& note : read.notes) fmt::print(stderr, "{}\n", note.text());
  for (const auto& warning : warnings) fmt::print(stderr, "{}\n", warning.text());
  const scene::Scene& s = read.scene;
  fmt::print("{}: sound; {} blocks, {} joints, {} variants, {} studies, {} s in steps of {} s{}\n", s.file.string(),
             s.blocks.size(), s.joints.size(), s.variants.size(), studies, s.analysis.duration_s, s.analysis.step_s,
             warnings.empty() ? "" : fmt::format("; {} warning{}", warnings.size(), warnings.size() == 1 ? "" : "s"));
  fmt::print(
      "structure of {:.4g} m: failure_displacement_m = {:.3g}, rest_speed_m_per_s = {:.3g}, penetration_tolerance_m = "
      "{:.3g}{}\n",
      scene::structure_size_m(s.blocks), s.analysis.failure_displacement_m, s.analysis.rest_speed_m_per_s,
      s.contact.penetration_tolerance_m,
      s.fluid == scene::FluidModel::hydrostatic
          ? fmt::format(", open_crack_width_m = {:.3g}", s.water.open_crack_width_m)
          : "");
  return 0;
}

}  // namespace

Work check_command(CLI::App& app) {
  const auto options = std::make_shared<process::RunOptions>();
  app.add_option("scene", options->scene, "scene file or case folder")->required();
  app.add_option("--set", options->overrides, "key=value over the scene's own");
  app.add_flag("--strict", options->strict, "warnings are errors");
  return [options] { return check(options->scene, options->overrides, options->strict); };
}

}  // namespace blockweir::launch
