// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/plugin/water_at_rest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/wire/placement.hpp"
#include "fluid/openfoam/sample_points.hpp"

namespace blockweir::openfoam {
WaterAtRest::WaterAtRest(const Foam::fvMesh& mesh, const Foam::dictionary& dict, const ImmersedBlocks& blocks,
                         const WaterLevels& levels)
    : mesh_(mesh),
      blocks_(blocks),
      levels_(levels),
      tolerance_(blocks.interface().rest_tolerance),
      depth_m_(blocks.interface().depth_m) {
  const Interface& i = blocks.interface();
  pressure_pa_ = tolerance_ * i.water_density * i.gravity * depth_m_;
  speed_m_per_s_ = tolerance_ * std::sqrt(i.gravity * depth_m_);
  const auto upstream_to = dict.get<Foam::scalar>("upstreamTo");
  const auto downstream_from = dict.get<Foam::scalar>("downstreamFrom");
  for (Foam::label c = 0; c < mesh.nCells(); ++c) {
    if (mesh.C()[c].x() < upstream_to) upstream_.push_back(c);
    if (mesh.C()[c].x() > downstream_from) downstream_.push_back(c);
  }
}

void WaterAtRest::look(double time_s, const std::vector<Pose>& pose) {
  if (tolerance_ == 0) return;
  rests_ = slow() && uniform(upstream_) && uniform(downstream_);
  looked_s_ = time_s;
  looked_at_ = pose;
}

bool WaterAtRest::lasts(const wire::Motion& motion, double from_s, const std::vector<Pose>& before) const {
  const double near_m = tolerance_ * depth_m_;
  return rests_ && levels_.change_m(looked_s_, motion.time_s) <= near_m &&
         farthest(motion.displacement, looked_at_) <= near_m &&
         farthest(motion.displacement, before) <= speed_m_per_s_ * (motion.time_s - from_s);
}

bool WaterAtRest::slow() const {
  const auto& water = mesh_.lookupObject<Foam::volScalarField>("alpha.water");
  const auto& velocity = mesh_.lookupObject<Foam::volVectorField>("U");
  double fastest = 0;
  for (Foam::label c = 0; c < mesh_.nCells(); ++c) {
    if (water[c] > 0.5 && blocks_.filled()[c] < 0.5) fastest = std::max(fastest, Foam::magSqr(velocity[c]));
  }
  Foam::reduce(fastest, Foam::maxOp<Foam::scalar>());
  return std::sqrt(fastest) <= speed_m_per_s_;
}

bool WaterAtRest::uniform(const Cells& pool) const {
  const auto& water = mesh_.lookupObject<Foam::volScalarField>("alpha.water");
  const auto& pressure = mesh_.lookupObject<Foam::volScalarField>("p_rgh");
  double lowest = std::numeric_limits<double>::max();
  double highest = -lowest;
  for (const Foam::label c : pool) {
    if (water[c] < all_water || blocks_.filled()[c] > untouched) continue;
    lowest = std::min(lowest, pressure[c]);
    highest = std::max(highest, pressure[c]);
  }
  Foam::reduce(lowest, Foam::minOp<Foam::scalar>());
  Foam::reduce(highest, Foam::maxOp<Foam::scalar>());
  return highest < lowest || highest - lowest <= 2 * pressure_pa_;  // none there, or near their middle
}

double WaterAtRest::farthest(const wire::Column<Pose>& a, const std::vector<Pose>& b) const {
  double distance = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] == b[k]) continue;
    const InterfaceBlock& block = blocks_.interface().blocks[k];
    for (const Point& p : block.vertices) {
      const Point way = wire::place(block.centroid, a[k], p) - wire::place(block.centroid, b[k], p);
      distance = std::max(distance, way.norm());
    }
  }
  return distance;
}

}  // namespace blockweir::openfoam
