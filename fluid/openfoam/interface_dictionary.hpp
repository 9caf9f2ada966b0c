// SPDX-License-Identifier: GPL-3.0-or-later
// What the plugin has to know of the scene, as OpenFOAM's constant/blockweir.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fluid/openfoam/site.hpp"
#include "fluid/openfoam/stokes_wave.hpp"

namespace blockweir::openfoam {

/// The mesh that the case has, as far as it is known.
struct Surroundings {
  Site site;
  std::vector<std::vector<scene::Point>> outlines;  ///< of all blocks, the ground's drawn out beyond the mesh
  double depth_m = 0;                               ///< largest, of the water
  std::optional<double> cell_m{};                   ///< side of a cell beside blocks; none: the plugin measures it
  std::optional<StokesWave> wave{};                 ///< that comes in at the upstream end
};

/// `first_window`: the motion that a run is resumed with; 0 from the start.
std::string interface_dictionary(const scene::Scene& scene, const Surroundings& around, const std::string& endpoint,
                                 std::uint64_t first_window);

/// Puts it into the case, and what the flow through joints needs into constant/blockweirJoints.
void write_interface(const std::filesystem::path& folder, const scene::Scene& scene, const Surroundings& around,
                     const std::string& endpoint, std::uint64_t first_window);

}  // namespace blockweir::openfoam
