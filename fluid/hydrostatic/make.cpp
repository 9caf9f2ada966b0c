// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/fluid_program.hpp"
#include "bridge/results/folder.hpp"
#include "fluid/hydrostatic/reservoir_output.hpp"

namespace blockweir::process {

std::unique_ptr<schedule::FluidSide> make_hydrostatic(const scene::Scene& scene, const std::filesystem::path& folder) {
  require_fluid(scene, scene::FluidModel::hydrostatic);
  if (!scene.output.reservoir) return std::make_unique<hydrostatic::HydrostaticModel>(scene);
  if (folder.empty()) {
    throw std::invalid_argument("[output] reservoir = true: say with --out where its files shall go");
  }
  results::make_folder(folder);
  return std::make_unique<hydrostatic::RecordedModel>(scene, folder);
}

}  // namespace blockweir::process
