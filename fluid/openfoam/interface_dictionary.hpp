// SPDX-License-Identifier: GPL-3.0-or-later
// The scene data that the plugin needs, as OpenFOAM's constant/blockweir.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fluid/openfoam/site.hpp"
#include "fluid/openfoam/stokes_wave.hpp"

namespace blockweir::openfoam {

/// Properties of the case's mesh, as far as they are known.
struct Surroundings {
  Site site;
  std::vector<std::vector<scene::Point>> outlines;  ///< of all blocks; those of the ground extend beyond the mesh
  double depth_m = 0;                               ///< largest, of the water
  std::optional<double> cell_m{};                   ///< side of a cell beside blocks; none: the plugin measures it
  std::optional<StokesWave> wave{};                 ///< entering at the upstream end
};

/// `first_window`: number of the first motion, above 0 in a resumed run.
std::string interface_dictionary(const scene::Scene& scene, const Surroundings& around, const std::string& endpoint,
                                 std::uint64_t first_window);

/// Writes it into the case, and the data for flow through joints into constant/blockweirJoints.
void write_interface(const std::filesystem::path& folder, const scene::Scene& scene, const Surroundings& around,
                     const std::string& endpoint, std::uint64_t first_window);

}  // namespace blockweir::openfoam
