// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/inflow_limits.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace blockweir::openfoam {
namespace {

constexpr double highest_ursell = 26;
constexpr double fewest_cells = 4;  // of water at an end that lets in more

void check_wave(const StokesWave& wave) {
  if (wave.height_m > wave.highest_m()) {
    throw std::invalid_argument(fmt::format(
        "OpenFOAM: a regular wave of {:.4g} m breaks: in {:.4g} m of water, {:.4g} s and {:.4g} m long, none "
        "is higher than {:.4g} m; lower [fluid] wave.height_m",
        wave.height_m, wave.depth_m, wave.period_s, wave.length_m(), wave.highest_m()));
  }
  if (wave.ursell_number() > highest_ursell) {
    throw std::invalid_argument(
        fmt::format("OpenFOAM: a regular wave of {:.4g} m and {:.4g} s in {:.4g} m of water has an Ursell number of "
                    "{:.3g}; Stokes's "
                    "second order holds up to {}; lower [fluid] wave.height_m or period_s, or use kind = \"solitary\"",
                    wave.height_m, wave.period_s, wave.depth_m, wave.ursell_number(), highest_ursell));
  }
}

void check_pool(const char* key, const std::optional<scene::TimeTable>& level, double ground_m, double cell_m) {
  const double least = ground_m + fewest_cells * cell_m;
  if (!level || level->at(0) >= least) return;
  throw std::invalid_argument(
      fmt::format("OpenFOAM: level_control = \"inflow\" raises water that is there, and {} is {:.4g} m at time 0, over "
                  "ground at {:.4g} m in cells of {:.3g} m; expected at least {:.4g} m",
                  key, level->at(0), ground_m, cell_m, least));
}

}  // namespace

StokesWave stokes_wave(const scene::Scene& scene, const Grid& grid) {
  const scene::Wave& wave = *scene.openfoam.wave;
  return {wave.height_m, wave.period_s, scene.water.upstream_level_m->at(0) - grid.ground_m,
          scene.analysis.gravity_m_per_s2};
}

void check_inflow(const scene::Scene& scene, const Grid& grid) {
  if (scene.openfoam.level_control != scene::LevelControl::inflow) return;
  check_pool("upstream_level_m", scene.water.upstream_level_m, grid.ground_m, grid.cell_m);
  check_pool("downstream_level_m", scene.water.downstream_level_m, grid.downstream_ground_m, grid.cell_m);
  if (comes_in(scene.openfoam)) check_wave(stokes_wave(scene, grid));
}

}  // namespace blockweir::openfoam
