// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/two_earthquakes.hpp"

#include <algorithm>

namespace blockweir::scene {

std::optional<Diagnostic> two_earthquakes(const Scene& scene) {
  const auto stands_in = [](const BodyLoad& load) {
    return load.origin == LoadOrigin::earthquake && (load.value[0].at(0.0) != 0 || load.value[1].at(0.0) != 0);
  };
  const bool constant =
      scene.water.is_shaken() || std::any_of(scene.body_loads.begin(), scene.body_loads.end(), stands_in);
  if (!constant || !scene.base_motion || scene.analysis.kind == AnalysisKind::at_rest) return std::nullopt;
  return Diagnostic{
      .severity = Diagnostic::Severity::warning,
      .file = scene.file.string(),
      .found =
          "a run has the earthquake twice: the constant coefficients of [earthquake] act all along, beside "
          "[base_motion]",
      .expected = "[base_motion] in a run, [earthquake] in a static answer",
      .remedy =
          "leave one of the two out, or state the coefficients in the set of a [[load_case]] for \"blockweir "
          "safety\""};
}

}  // namespace blockweir::scene
