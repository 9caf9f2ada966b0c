// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/plugin/water_state.hpp"

#include <IOdictionary.H>

#include "fluid/openfoam/sample_points.hpp"

namespace blockweir::openfoam {
namespace {

constexpr double least_film = 0.01;  // of a cell: what is thinner is as good as dry
constexpr double deep_cut = 0.95;    // a cell that blocks fill farther than this follows the water beside it too late

double density_of(const Foam::fvMesh& mesh, const char* phase) {
  const auto& transport = mesh.lookupObject<Foam::IOdictionary>("transportProperties");
  return Foam::dimensionedScalar("rho", Foam::dimDensity, transport.subDict(phase)).value();
}

}  // namespace

WaterState::WaterState(const Foam::fvMesh& mesh, const ImmersedBlocks& blocks)
    : mesh_(mesh),
      blocks_(blocks),
      alpha_(mesh.lookupObject<Foam::volScalarField>("alpha.water")),
      p_rgh_(mesh.lookupObject<Foam::volScalarField>("p_rgh")),
      rho_(mesh.lookupObject<Foam::volScalarField>("rho")),
      water_density_(density_of(mesh, "water")),
      air_density_(density_of(mesh, "air")),
      column_(static_cast<std::size_t>(mesh.nCells())) {
  const auto& g = mesh.time().lookupObject<Foam::uniformDimensionedVectorField>("g");
  gravity_ = -g.value().y();
  reference_level_ = mesh.lookupObject<Foam::uniformDimensionedScalarField>("hRef").value();
  for (Foam::label c = 0; c < mesh.nCells(); ++c) {
    const Foam::vector& centre = mesh.C()[c];
    // The cell is as high as its outline: one step of its height leads into the one below.
    const double height = mesh.bounds().span().y();
    double lowest = centre.y() + height;
    for (const Foam::label p : mesh.cellPoints()[c]) lowest = std::min(lowest, mesh.points()[p].y());
    const double half = centre.y() - lowest;
    const int below = blocks.locator().find({centre.x(), centre.y() - 2 * half});
    column_[static_cast<std::size_t>(c)] = {below, lowest, 2 * half};
  }
}

PressureLine WaterState::line_at(const Point& x, bool cut) const {
  PressureLine line;
  const int cell = blocks_.locator().find(x);
  const auto& filled = blocks_.filled();
  if (cell < 0 || filled[cell] > (cut ? sealed : untouched)) return line;
  // Near the surface the water is below: in this cell, or in the next one down.
  int source = cell;
  bool on_block = false;
  for (int down = 0; down < 2 && alpha_[source] < all_water; ++down) {
    const int below = column_[static_cast<std::size_t>(source)].below;
    if (below < 0) break;
    on_block = filled[below] > std::max(untouched, filled[source]);
    if ((on_block && filled[below] > deep_cut) || alpha_[below] <= alpha_[source]) break;
    source = below;
    if (on_block) break;
  }
  if (on_block && alpha_[source] < all_water) {
    line = film_in(source);
  } else {
    line.wet = alpha_[source] >= 0.5;
    const double scale = water_density_ / (water_density_ - air_density_);
    line.slope = (rho_[source] - air_density_) * gravity_ * scale;
    line.at_zero = p_rgh_[source] * scale + line.slope * reference_level_;
  }
  line.found = true;
  line.whole = source == cell && alpha_[cell] >= all_water && filled[cell] <= untouched;
  line.centre = {mesh_.C()[source].x(), mesh_.C()[source].y()};
  return line;
}

/// Still water up to the cell's water fraction, and the excess over its pressure: interFoam's balance at the faces of a
/// surface cell is that of initial_water.cpp.
PressureLine WaterState::film_in(int cell) const {
  const Column& c = column_[static_cast<std::size_t>(cell)];
  const double share = alpha_[cell];
  const double level = c.bottom + share * c.height;
  const double weight = water_density_ * gravity_;
  const double at_rest = share * weight * (level - reference_level_ + (1 - share) * c.height);
  PressureLine line;
  line.wet = share >= least_film;
  line.slope = weight;
  line.at_zero = weight * level + p_rgh_[cell] * water_density_ / (water_density_ - air_density_) - at_rest;
  return line;
}

}  // namespace blockweir::openfoam
