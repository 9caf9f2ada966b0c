// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/require_fluid.hpp"
#include "bridge/results/folder.hpp"
#include "fluid/hydrostatic/reservoir_output.hpp"
#include "fluid/reservoir/reservoir_model.hpp"

namespace blockweir::reservoir {

std::unique_ptr<schedule::FluidSide> make(const scene::Scene& scene, const std::filesystem::path& folder) {
  process::require_fluid(scene, scene::FluidModel::reservoir);
  hydrostatic::require_folder_of_pictures(scene, folder);
  if ((scene::flows_in_joints(scene) || scene.output.reservoir) && !folder.empty()) results::make_folder(folder);
  return std::make_unique<ReservoirModel>(scene, folder);
}

}  // namespace blockweir::reservoir
