// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/plugin/water_levels.hpp"

#include <IOdictionary.H>

#include <algorithm>
#include <limits>

namespace blockweir::openfoam {

WaterLevels::WaterLevels(const Foam::fvMesh& mesh, const Foam::dictionary& dict) : mesh_(mesh) {
  const auto read = [&](Pool& pool, const char* key) {
    if (dict.found(key)) pool.level = Foam::Function1<Foam::scalar>::New(key, dict);
  };
  read(upstream_, "upstreamLevel");
  read(downstream_, "downstreamLevel");
  set_levels_ = dict.get<Foam::Switch>("setLevels");
  const auto upstream_to = dict.get<Foam::scalar>("upstreamTo");
  const auto downstream_from = dict.get<Foam::scalar>("downstreamFrom");
  const double round_off = 1e-9 * mesh.bounds().mag();
  const double left = mesh.bounds().min().x() + round_off;
  const double right = mesh.bounds().max().x() - round_off;
  for (Foam::label c = 0; c < mesh.nCells(); ++c) {
    Cell cell{c, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    bool first = false;
    bool last = false;
    for (const Foam::label p : mesh.cellPoints()[c]) {
      const Foam::point& corner = mesh.points()[p];
      cell.bottom = std::min(cell.bottom, corner.y());
      cell.top = std::max(cell.top, corner.y());
      first = first || corner.x() <= left;
      last = last || corner.x() >= right;
    }
    if (upstream_.level && first) upstream_.end.push_back(cell);
    if (downstream_.level && last) downstream_.end.push_back(cell);
    if (!set_levels_) continue;
    if (upstream_.level && mesh.C()[c].x() < upstream_to) upstream_.cells.push_back(cell);
    if (downstream_.level && mesh.C()[c].x() > downstream_from) downstream_.cells.push_back(cell);
  }
}

double WaterLevels::level(const Pool& pool, double time_s) const {
  if (!pool.level) return std::numeric_limits<double>::quiet_NaN();
  if (set_levels_) return pool.level->value(time_s);
  const auto& water = mesh_.lookupObject<Foam::volScalarField>("alpha.water");
  constexpr double some = 0.01;
  double surface = mesh_.bounds().min().y();
  for (const Cell& cell : pool.end) {
    const double fraction = std::min(1.0, water[cell.cell]);
    if (fraction > some) surface = std::max(surface, cell.bottom + fraction * (cell.top - cell.bottom));
  }
  return Foam::returnReduce(surface, Foam::maxOp<Foam::scalar>());
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
  auto& water = mesh_.lookupObjectRef<Foam::volScalarField>("alpha.water");
  auto& air = mesh_.lookupObjectRef<Foam::volScalarField>("alpha.air");
  auto& rho = mesh_.lookupObjectRef<Foam::volScalarField>("rho");
  const auto& transport = mesh_.lookupObject<Foam::IOdictionary>("transportProperties");
  const double rho_water = Foam::dimensionedScalar("rho", Foam::dimDensity, transport.subDict("water")).value();
  const double rho_air = Foam::dimensionedScalar("rho", Foam::dimDensity, transport.subDict("air")).value();
  for (const Cell& cell : pool.cells) {
    const double fraction = std::clamp((level - cell.bottom) / (cell.top - cell.bottom), 0.0, 1.0);
    water[cell.cell] = fraction;
    air[cell.cell] = 1 - fraction;
    rho[cell.cell] = fraction * rho_water + (1 - fraction) * rho_air;
  }
  water.correctBoundaryConditions();
  air.correctBoundaryConditions();
  rho.correctBoundaryConditions();
}

}  // namespace blockweir::openfoam
