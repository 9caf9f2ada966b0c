// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/plugin/water_levels.hpp"

#include <IOdictionary.H>

#include <algorithm>
#include <cmath>
#include <limits>

namespace blockweir::openfoam {
namespace {

constexpr double cells_away = 2.5;  // from the structure, where a level that nobody sets is read

}  // namespace

WaterLevels::WaterLevels(const Foam::fvMesh& mesh, const Foam::dictionary& dict) : mesh_(mesh) {
  const auto read = [&](Pool& pool, const char* key) {
    if (dict.found(key)) pool.level = Foam::Function1<Foam::scalar>::New(key, dict);
  };
  read(upstream_, "upstreamLevel");
  read(downstream_, "downstreamLevel");
  const auto& transport = mesh.lookupObject<Foam::IOdictionary>("transportProperties");
  water_density_ = Foam::dimensionedScalar("rho", Foam::dimDensity, transport.subDict("water")).value();
  air_density_ = Foam::dimensionedScalar("rho", Foam::dimDensity, transport.subDict("air")).value();
  set_levels_ = dict.get<Foam::Switch>("setLevels");
  const auto upstream_to = dict.get<Foam::scalar>("upstreamTo");
  const auto downstream_from = dict.get<Foam::scalar>("downstreamFrom");
  const auto h = dict.get<Foam::scalar>("cell");
  const auto near = [&](Foam::label c, double x) { return std::abs(mesh.C()[c].x() - x) <= 0.5 * h; };
  for (Foam::label c = 0; c < mesh.nCells(); ++c) {
    Cell cell{c, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Foam::label p : mesh.cellPoints()[c]) {
      cell.bottom = std::min(cell.bottom, mesh.points()[p].y());
      cell.top = std::max(cell.top, mesh.points()[p].y());
    }
    if (upstream_.level && near(c, upstream_to - cells_away * h)) upstream_.column.push_back(cell);
    if (downstream_.level && near(c, downstream_from + cells_away * h)) downstream_.column.push_back(cell);
    if (!set_levels_) continue;
    if (upstream_.level && mesh.C()[c].x() < upstream_to) upstream_.cells.push_back(cell);
    if (downstream_.level && mesh.C()[c].x() > downstream_from) downstream_.cells.push_back(cell);
  }
}

double WaterLevels::level(const Pool& pool, double time_s) const {
  if (!pool.level) return std::numeric_limits<double>::quiet_NaN();
  if (set_levels_) return pool.level->value(time_s);
  const auto& water = mesh_.lookupObject<Foam::volScalarField>("alpha.water");
  double depth = 0;
  double height = 0;
  for (const Cell& cell : pool.column) {
    depth += std::min(1.0, water[cell.cell]) * (cell.top - cell.bottom);
    height += cell.top - cell.bottom;
  }
  Foam::reduce(depth, Foam::sumOp<Foam::scalar>());
  Foam::reduce(height, Foam::sumOp<Foam::scalar>());
  // Two columns where the place lies on a line between them.
  const double columns = std::max(1.0, std::round(height / mesh_.bounds().span().y()));
  return mesh_.bounds().min().y() + depth / columns;
}

double WaterLevels::upstream_m(double time_s) const {
  return level(upstream_, time_s);
}

double WaterLevels::downstream_m(double time_s) const {
  return level(downstream_, time_s);
}

void WaterLevels::set(double time_s) {
  if (!set_levels_) return;
  set(upstream_, time_s);
  set(downstream_, time_s);
}

void WaterLevels::set(Pool& pool, double time_s) {
  if (!pool.level) return;  // one rank without its cells still takes part in what ranks tell each other
  const double level = pool.level->value(time_s);
  for (const Cell& cell : pool.cells) {
    store(cell.cell, std::clamp((level - cell.bottom) / (cell.top - cell.bottom), 0.0, 1.0));
  }
  correct_boundaries();
}

void WaterLevels::store(Foam::label cell, double fraction) {
  mesh_.lookupObjectRef<Foam::volScalarField>("alpha.water")[cell] = fraction;
  mesh_.lookupObjectRef<Foam::volScalarField>("alpha.air")[cell] = 1 - fraction;
  mesh_.lookupObjectRef<Foam::volScalarField>("rho")[cell] = fraction * water_density_ + (1 - fraction) * air_density_;
}

void WaterLevels::correct_boundaries() {
  for (const char* name : {"alpha.water", "alpha.air", "rho"}) {
    mesh_.lookupObjectRef<Foam::volScalarField>(name).correctBoundaryConditions();
  }
}

}  // namespace blockweir::openfoam
