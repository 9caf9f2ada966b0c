// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/mesh_before_sound.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/scene/at.hpp"
#include "bridge/scene/water_answers.hpp"

namespace blockweir::solid::output {

std::string mesh_before_sound_warning(const expect::Outcome& o) {
  const scene::Scene& scene = o.solid.scene();
  if (scene.fluid != scene::FluidModel::reservoir || scene.analysis.kind != scene::AnalysisKind::dynamic) return {};
  if (scene::answers_bending(scene)) return {};
  const auto& panels = o.last.panels;
  const auto wet = std::find_if(panels.begin(), panels.end(), [&](const PanelRow& panel) {
    return !panel.in_crack && !scene.blocks[at(panel.block)].fixed &&
           !o.solid.parts().triangles[at(panel.block)].empty();
  });
  if (wet == panels.end()) return {};
  return fmt::format(
      "block \"{}\" has a mesh, and compressible water feels its mean motion, not its bending: measured on walls and "
      "dams "
      "of one block, the first natural frequency is 0.3 to 1.1 % low (\"blockweir modes\" has the bending), and "
      "higher modes that nothing damps grow, by the trapezoidal rule and in very short steps; expected integrator = "
      "\"shi\" with a "
      "step_s of some milliseconds (now {:.3g} s); compare with a run of twice the step_s and window_s",
      scene.blocks[at(wet->block)].name, scene.analysis.step_s);
}

}  // namespace blockweir::solid::output
