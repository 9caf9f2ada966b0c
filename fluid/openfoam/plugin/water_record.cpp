// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/plugin/water_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/results/csv.hpp"

namespace blockweir::openfoam {
namespace {

constexpr double front_share = 0.1;  // of the first depth: thinner sheets run ahead of what one would call the front

struct Resultant {
  Point force = Point::Zero();
  double moment = 0;
};

/// Of pressures linear from one end of a straight panel to the other, about `pivot`.
void add_panel(const Point& from, const Point& to, double p_from, double p_to, const Point& pivot, Resultant& into) {
  const Point span = to - from;
  const Point inwards(-span.y(), span.x());  // times the length
  const double p = (p_from + p_to) / 2;
  const Point force = p * inwards;
  const double centre = p != 0 ? 0.5 + (p_to - p_from) / (12 * p) : 0.5;
  const Point arm = from + centre * span - pivot;
  into.force += force;
  into.moment += arm.x() * force.y() - arm.y() * force.x();
}

/// fmt does arithmetic on the value, and OpenFOAM traps that for a NaN.
std::string level(double level_m) {
  return std::isnan(level_m) ? "nan" : fmt::format("{:.9g}", level_m);
}

}  // namespace

WaterRecord::WaterRecord(const Foam::fvMesh& mesh, const ImmersedBlocks& blocks, bool goes_on)
    : mesh_(mesh), blocks_(blocks) {
  const double round_off = 1e-9 * mesh.bounds().mag();
  for (Foam::label c = 0; c < mesh.nCells(); ++c) {
    const double x = mesh.C()[c].x();
    const auto near = columns_.lower_bound(x - round_off);
    const bool known = near != columns_.end() && near->first < x + round_off;
    (known ? near->second : columns_[x]).push_back(c);
  }
  if (!Foam::Pstream::master()) return;
  file_.emplace(std::string(mesh.time().globalPath()) + "/water.csv",
                goes_on ? results::Begin::where_it_stopped : results::Begin::anew);
  if (goes_on) return;
  std::string heading =
      "time_s,upstream_level_m,downstream_level_m,water_area_m2,front_m,fastest_m_per_s,ground_acceleration_x_m_per_s2";
  for (std::size_t b = 0; b < blocks.outlines().size(); ++b) {
    if (!blocks.interface().blocks[b].loaded) continue;
    for (const char* what : {"force_x_n_per_m", "force_y_n_per_m", "moment_n", "velocity_x_m_per_s"}) {
      heading += "," + results::csv_cell(fmt::format("{}.{}", blocks.interface().hello.block_names[b], what));
    }
  }
  file_->line(heading);
}

/// Where the depth of water outside of blocks falls below `depth_m`, seen from the left, linear between columns.
double WaterRecord::front(double depth_m) const {
  double front = mesh_.bounds().min().x();
  double x_before = front;
  double before = 0;
  for (const auto& [x, cells] : columns_) {
    const double depth = depth_of(cells);
    if (depth >= depth_m) front = std::max(front, x);
    if (before >= depth_m && depth < depth_m) {
      front = std::max(front, x_before + (before - depth_m) / (before - depth) * (x - x_before));
    }
    x_before = x;
    before = depth;
  }
  return Foam::returnReduce(front, Foam::maxOp<Foam::scalar>());
}

double WaterRecord::depth_of(const std::vector<Foam::label>& column) const {
  const auto& water = mesh_.lookupObject<Foam::volScalarField>("alpha.water");
  double volume = 0;
  double total = 0;
  for (const Foam::label c : column) {
    volume += water[c] * (1 - blocks_.filled()[c]) * mesh_.V()[c];
    total += mesh_.V()[c];
  }
  return volume / total * mesh_.bounds().span().y();
}

void WaterRecord::add(double time_s, const wire::Load& load, const std::vector<Pose>& velocity_of_blocks,
                      double ground_x) {
  const auto& water = mesh_.lookupObject<Foam::volScalarField>("alpha.water");
  const auto& velocity = mesh_.lookupObject<Foam::volVectorField>("U");
  double volume = 0;
  double fastest = 0;
  for (Foam::label c = 0; c < mesh_.nCells(); ++c) {
    volume += water[c] * mesh_.V()[c];
    if (water[c] > 0.5) fastest = std::max(fastest, Foam::magSqr(velocity[c]));
  }
  Foam::reduce(volume, Foam::sumOp<Foam::scalar>());
  Foam::reduce(fastest, Foam::maxOp<Foam::scalar>());
  if (deepest_ == 0) {
    for (const auto& [x, cells] : columns_) deepest_ = std::max(deepest_, depth_of(cells));
    Foam::reduce(deepest_, Foam::maxOp<Foam::scalar>());
  }
  const double front_m = front(front_share * deepest_);
  if (!Foam::Pstream::master()) return;

  std::vector<Resultant> forces(blocks_.outlines().size());
  for (std::size_t i = 0; i < load.block.size(); ++i) {
    const std::size_t b = load.block[i];
    const Polygon& outline = blocks_.outlines()[b];
    const Point& from = outline[load.edge[i]];
    const Point span = outline[(load.edge[i] + 1) % outline.size()] - from;
    const Point& home = blocks_.interface().blocks[b].centroid;
    const Point centroid = home + Point(blocks_.poses()[b][0], blocks_.poses()[b][1]);
    add_panel(from + load.s_from[i] * span, from + load.s_to[i] * span, load.pressure_from_pa[i],
              load.pressure_to_pa[i], centroid, forces[b]);
  }
  std::string row = fmt::format("{:.12g},{},{},{:.15g},{:.9g},{:.6g},{:.9g}", time_s, level(load.upstream_level_m),
                                level(load.downstream_level_m), volume / mesh_.bounds().span().z(), front_m,
                                std::sqrt(fastest), ground_x);
  for (std::size_t b = 0; b < forces.size(); ++b) {
    if (!blocks_.interface().blocks[b].loaded) continue;
    row += fmt::format(",{:.12g},{:.12g},{:.12g},{:.12g}", forces[b].force.x(), forces[b].force.y(), forces[b].moment,
                       velocity_of_blocks[b][0]);
  }
  file_->line(row);
}

}  // namespace blockweir::openfoam
