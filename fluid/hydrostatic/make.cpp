// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/require_fluid.hpp"
#include "bridge/results/folder.hpp"
#include "fluid/hydrostatic/reservoir_output.hpp"

namespace blockweir::hydrostatic {

std::unique_ptr<schedule::FluidSide> make(const scene::Scene& scene, const std::filesystem::path& folder) {
  process::require_fluid(scene, scene::FluidModel::hydrostatic);
  const bool recorded = scene.output.reservoir || (scene::flows_in_joints(scene) && !folder.empty());
  if (!recorded) return std::make_unique<HydrostaticModel>(scene);
  require_folder_of_pictures(scene, folder);
  results::make_folder(folder);
  return std::make_unique<RecordedModel>(scene, folder);
}

}  // namespace blockweir::hydrostatic
