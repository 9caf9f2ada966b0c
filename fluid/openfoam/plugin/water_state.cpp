// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/plugin/water_state.hpp"

#include <IOdictionary.H>

namespace blockweir::openfoam {
namespace {

constexpr double untouched = 1e-6;  // share of a cell that a block may fill where the cell still counts as open
constexpr double all_water = 0.99;

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
      below_(static_cast<std::size_t>(mesh.nCells()), -1) {
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
    below_[static_cast<std::size_t>(c)] = blocks.locator().find({centre.x(), centre.y() - 2 * half});
  }
}

PressureLine WaterState::line_at(const Point& x) const {
  PressureLine line;
  const int cell = blocks_.locator().find(x);
  if (cell < 0 || blocks_.filled()[cell] > untouched) return line;
  line.found = true;
  // Near the surface the water is below: in this cell, or in the next one down.
  int source = cell;
  for (int down = 0; down < 2 && alpha_[source] < all_water; ++down) {
    const int below = below_[static_cast<std::size_t>(source)];
    if (below < 0 || blocks_.filled()[below] > untouched || alpha_[below] <= alpha_[source]) break;
    source = below;
  }
  line.wet = alpha_[source] >= 0.5;
  line.whole = source == cell && alpha_[cell] >= all_water;
  line.centre = {mesh_.C()[source].x(), mesh_.C()[source].y()};
  const double scale = water_density_ / (water_density_ - air_density_);
  line.slope = (rho_[source] - air_density_) * gravity_ * scale;
  line.at_zero = p_rgh_[source] * scale + line.slope * reference_level_;
  return line;
}

}  // namespace blockweir::openfoam
