// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/launch/scene_file_check.hpp"
#include "bridge/results/counted.hpp"
#include "bridge/results/wrapped.hpp"
#include "bridge/scene/read/check.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/scene/structure_size.hpp"
#include "bridge/scene/touching_pairs.hpp"
#include "bridge/scene/two_earthquakes.hpp"

namespace blockweir::launch {
namespace {

using results::counted;

struct CheckOptions {
  std::filesystem::path scene;
  std::vector<std::string> overrides;
  bool strict = false;
};

int check(const CheckOptions& options) {
  const std::filesystem::path& path = options.scene;
  const auto& overrides = options.overrides;
  const scene::ReadScene read = scene::read(path, overrides);
  SceneFileCheck found = check_scene_file(read, path, overrides);
  std::vector<scene::Diagnostic> warnings = read.warnings;
  std::move(found.warnings.begin(), found.warnings.end(), std::back_inserter(warnings));
  if (auto twice = scene::two_earthquakes(read.scene)) warnings.push_back(std::move(*twice));
  for (const auto& note : read.notes) fmt::print(stderr, "{}", results::for_stderr(note.text() + "\n"));
  if (!options.strict) {
    for (const auto& warning : warnings) fmt::print(stderr, "{}", results::for_stderr(warning.text() + "\n"));
  }
  found.wrong.report();
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
      counted(found.studies, "study", "studies"), s.analysis.duration_s, s.analysis.step_s);
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
