// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/load_case_scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "bridge/scene/read/entry.hpp"
#include "bridge/scene/read/own_laws.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {

scene::ReadScene load_case_scene(const scene::LoadCase& load_case, const std::filesystem::path& scene,
                                 const Settings& overrides) {
  return scene::read_entry(scene, {fmt::format("[[load_case]] \"{}\"", load_case.name), load_case.line, load_case.set},
                           joined(overrides, load_case.set));
}

std::optional<scene::Diagnostic> idle_load_case(const scene::LoadCase& load_case, scene::Scene without,
                                                scene::Scene with) {
  if (load_case.set.empty()) return std::nullopt;  // the scene as written, on purpose
  for (scene::Scene* one : {&without, &with}) {
    one->text.clear();
    one->digest.clear();
    one->warnings.clear();
    one->variants.clear();  // which one of the two has, read as the whole file
    one->studies = {};
  }
  if (!(without == with)) return std::nullopt;
  return scene::Diagnostic{scene::Diagnostic::Severity::warning,
                           with.file.string(),
                           load_case.line,
                           fmt::format("[[load_case]] \"{}\" changes nothing: with {} the scene is the same",
                                       load_case.name, fmt::join(load_case.set, " and ")),
                           "a set that makes another scene of it",
                           "correct it, or leave the load case out"};
}

std::vector<scene::Diagnostic> missed_joints(const scene::LoadCase& load_case, const scene::Scene& with) {
  constexpr std::string_view of_all = "joint.";
  std::vector<scene::Diagnostic> warnings;
  const auto& set = load_case.set;
  for (const std::string& setting : set) {
    const std::size_t equals = setting.find('=');
    if (!setting.starts_with(of_all) || equals == std::string::npos) continue;
    const std::string key = setting.substr(of_all.size(), equals - of_all.size());
    const std::string value = setting.substr(equals);
    std::vector<std::string> missed = scene::laws_that_state(with.text, key);
    std::erase_if(missed, [&](const std::string& law) {
      const std::string own = law + "." + key + "=";
      return std::any_of(set.begin(), set.end(), [&](const std::string& s) { return s.starts_with(own); });
    });
    if (missed.empty()) continue;
    warnings.push_back(
        {scene::Diagnostic::Severity::warning, with.file.string(), load_case.line,
         fmt::format("[[load_case]] \"{}\" sets {}, which does not reach {}: {} own {}", load_case.name, setting,
                     fmt::join(missed, ", "), missed.size() > 1 ? "they state their" : "it states its", key),
         "a setting for each joint that it is to reach",
         fmt::format("add \"{}.{}{}\" to set, or leave {} out there", missed.front(), key, value, key)});
  }
  return warnings;
}

}  // namespace blockweir::study
