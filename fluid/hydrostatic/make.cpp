// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "bridge/results/folder.hpp"
#include "bridge/schedule/processes.hpp"
#include "fluid/hydrostatic/reservoir_output.hpp"

namespace blockweir::schedule {

std::unique_ptr<FluidSide> make_hydrostatic(const scene::Scene& scene, const std::filesystem::path& folder) {
  if (scene.fluid != scene::FluidModel::hydrostatic) {
    throw std::invalid_argument(
        fmt::format("the scene's fluid is \"{}\", not \"hydrostatic\"", scene::name(scene.fluid)));
  }
  if (!scene.output.reservoir) return std::make_unique<hydrostatic::HydrostaticModel>(scene);
  if (folder.empty()) {
    throw std::invalid_argument("[output] reservoir = true: say with --out where its files shall go");
  }
  results::make_folder(folder);
  return std::make_unique<hydrostatic::RecordedModel>(scene, folder);
}

}  // namespace blockweir::schedule
