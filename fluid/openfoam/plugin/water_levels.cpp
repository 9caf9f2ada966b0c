// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/plugin/water_levels.hpp"

#include <IOdictionary.H>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace blockweir::openfoam {
namespace {

constexpr double cells_away = 2.5;  // from the structure, where a level that nobody sets is read

}  // namespace

WaterLevels::WaterLevels(const Foam::fvMesh& mesh, const Foam::dictionary& dict, const ImmersedBlocks& blocks)
    : mesh_(mesh), blocks_(blocks) {
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
  upstream_.read_at = upstream_to - cells_away * blocks.cell_m();
  downstream_.read_at = downstream_from + cells_away * blocks.cell_m();
  for (Foam::label c = 0; c < mesh.nCells(); ++c) {
    Cell cell{c, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    for (const Foam::label p : mesh.cellPoints()[c]) {
      left = std::min(left, mesh.points()[p].x());
      right = std::max(right, mesh.points()[p].x());
      cell.bottom = std::min(cell.bottom, mesh.points()[p].y());
      cell.top = std::max(cell.top, mesh.points()[p].y());
    }
    for (Pool* pool : {&upstream_, &downstream_}) {
      if (pool->level && left <= pool->read_at && pool->read_at < right) pool->column.push_back(cell);
    }
    if (!set_levels_) continue;
    if (upstream_.level && mesh.C()[c].x() < upstream_to) upstream_.cells.push_back(cell);
    if (downstream_.level && mesh.C()[c].x() > downstream_from) downstream_.cells.push_back(cell);
  }
}

double WaterLevels::level(const Pool& pool, double time_s) const {
  if (!pool.level) return std::numeric_limits<double>::quiet_NaN();
  if (set_levels_) return pool.level->value(time_s);
  return found_level(pool);
}

/// The ground below counts as water.
double WaterLevels::found_level(const Pool& pool) const {
  const auto& water = mesh_.lookupObject<Foam::volScalarField>("alpha.water");
  double bottom = std::numeric_limits<double>::max();
  double depth = 0;
  for (const Cell& cell : pool.column) {
    bottom = std::min(bottom, cell.bottom);
    const double filled = blocks_.filled()[cell.cell];
    depth += (filled + (1 - filled) * std::clamp(water[cell.cell], 0.0, 1.0)) * (cell.top - cell.bottom);
  }
  Foam::reduce(bottom, Foam::minOp<Foam::scalar>());
  Foam::reduce(depth, Foam::sumOp<Foam::scalar>());
  return depth > 0 ? bottom + depth : std::numeric_limits<double>::quiet_NaN();
}

std::string WaterLevels::unfit_at_start() const {
  const std::string upstream = unfit_at_start(upstream_, "upstream");
  return upstream.empty() ? unfit_at_start(downstream_, "downstream") : upstream;
}

std::string WaterLevels::unfit_at_start(const Pool& pool, const char* name) const {
  if (!pool.level) return "";
  const double found = found_level(pool);
  const double stated = pool.level->value(0);
  if (set_levels_ && !(std::abs(found - stated) <= blocks_.cell_m())) {
    return fmt::format(
        "level: the case's water stands at {:.6g} m at x = {:.6g} m, {}_level_m at time 0 is {:.6g} m; make them the "
        "same, or leave level_control = \"table\" out",
        found, pool.read_at, name, stated);
  }
  // In the lowest cell of the column that is all water.
  constexpr double all = 1 - 1e-6;
  const auto& water = mesh_.lookupObject<Foam::volScalarField>("alpha.water");
  const auto& pressure = mesh_.lookupObject<Foam::volScalarField>("p_rgh");
  const auto& gh = mesh_.lookupObject<Foam::volScalarField>("gh");
  double lowest = std::numeric_limits<double>::max();
  double got = -std::numeric_limits<double>::max();
  for (const Cell& cell : pool.column) {
    const Foam::label c = cell.cell;
    if (water[c] < all || blocks_.filled()[c] > 1 - all || mesh_.C()[c].y() > lowest) continue;
    lowest = mesh_.C()[c].y();
    got = pressure[c] + (water_density_ - air_density_) * gh[c];
  }
  const double everywhere = Foam::returnReduce(lowest, Foam::minOp<Foam::scalar>());
  if (everywhere == std::numeric_limits<double>::max()) return "";  // no water there
  if (lowest > everywhere) got = -std::numeric_limits<double>::max();
  got = Foam::returnReduce(got, Foam::maxOp<Foam::scalar>());
  const double gravity = blocks_.interface().gravity;
  const double rest = (water_density_ - air_density_) * gravity * (found - everywhere);
  if (std::abs(got - rest) <= 0.5 * rest) return "";
  return fmt::format(
      "pressure: near the bed at x = {:.6g} m the case starts with {:.4g} Pa under {:.4g} m of water, {:.4g} Pa would "
      "be "
      "at rest; write the still-water level into constant/hRef and p_rgh = 0 where that is the level",
      pool.read_at, got, found - everywhere, rest);
}

double WaterLevels::upstream_m(double time_s) const {
  return level(upstream_, time_s);
}

double WaterLevels::downstream_m(double time_s) const {
  return level(downstream_, time_s);
}

double WaterLevels::change_m(double from_s, double to_s) const {
  const auto change = [&](const Pool& pool) {
    return pool.level ? std::abs(pool.level->value(to_s) - pool.level->value(from_s)) : 0.0;
  };
  return std::max(change(upstream_), change(downstream_));
}

void WaterLevels::set(double time_s) {
  if (!set_levels_) return;
  set(upstream_, time_s);
  set(downstream_, time_s);
}

void WaterLevels::set(Pool& pool, double time_s) {
  if (!pool.level) return;  // collective calls need the ranks without cells of the pool, too
  const double level = pool.level->value(time_s);
  auto& water = mesh_.lookupObjectRef<Foam::volScalarField>("alpha.water");
  auto& air = mesh_.lookupObjectRef<Foam::volScalarField>("alpha.air");
  auto& density = mesh_.lookupObjectRef<Foam::volScalarField>("rho");
  for (const Cell& cell : pool.cells) {
    const double fraction = std::clamp((level - cell.bottom) / (cell.top - cell.bottom), 0.0, 1.0);
    water[cell.cell] = fraction;
    air[cell.cell] = 1 - fraction;
    density[cell.cell] = fraction * water_density_ + (1 - fraction) * air_density_;
  }
  for (auto* field : {&water, &air, &density}) field->correctBoundaryConditions();
}

}  // namespace blockweir::openfoam
