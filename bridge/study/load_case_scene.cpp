// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/load_case_scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bridge/scene/read/entry.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {

scene::ReadScene load_case_scene(const scene::LoadCase& load_case, const std::filesystem::path& scene,
                                 const Settings& overrides) {
  return scene::read_entry(scene, {fmt::format("[[load_case]] \"{}\"", load_case.name), load_case.line, load_case.set},
                           joined(overrides, load_case.set));
}

std::optional<scene::Diagnostic> idle_load_case(const scene::LoadCase& load_case, scene::Scene without,
                                                scene::Scene with) {
  for (scene::Scene* one : {&without, &with}) {
    one->text.clear();
    one->digest.clear();
    one->warnings.clear();
  }
  if (!(without == with)) return std::nullopt;
  return scene::Diagnostic{scene::Diagnostic::Severity::warning,
                           with.file.string(),
                           load_case.line,
                           fmt::format("[[load_case]] \"{}\" changes nothing: the scene has {} anyway", load_case.name,
                                       fmt::join(load_case.set, " and ")),
                           "a set that makes another scene of it",
                           "correct it, or leave the load case out"};
}

}  // namespace blockweir::study
