// SPDX-License-Identifier: GPL-3.0-or-later
// Resistance to a mechanism: openings and slips of faces, and the power that they dissipate.
#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "solid/limit/limit_analysis.hpp"

namespace blockweir::solid::limit {
namespace {

/// The bound for a mechanism that opens the face by this much for each unit of slip: that of associated flow between
/// the two adjacent tangents.
Face::Bound bound_of(const Face& face, double opening_per_slip) {
  const std::vector<Face::Bound> bounds = face.bounds();
  const auto next =
      std::find_if(bounds.begin(), bounds.end(), [&](const auto& b) { return b.friction <= opening_per_slip; });
  if (next == bounds.begin()) return bounds.front();
  if (next == bounds.end()) return bounds.back();
  const Face::Bound& steeper = *(next - 1);
  const double share = (opening_per_slip - next->friction) / (steeper.friction - next->friction);
  return {next->cohesion_n_per_m + share * (steeper.cohesion_n_per_m - next->cohesion_n_per_m), opening_per_slip};
}

}  // namespace

/// Sup of -(N_1 w_1 + N_2 w_2 + S g) over admissible forces, w the openings of the ends and g the slip.
double LimitAnalysis::resistance(const Twists& mechanism, double reduction) const {
  double sum = 0;
  for (const Face& face : faces_) {
    const double slip = std::abs(face.along().dot(jump(face, mechanism, face.from_m)));
    std::vector<double> openings;
    for (const Point& end : face.ends()) openings.push_back(face.normal.dot(jump(face, mechanism, end)));
    const double least = *std::min_element(openings.begin(), openings.end());
    const Face::Bound bound = bound_of(face, slip > 0 ? least / slip * reduction : 0);
    sum += bound.cohesion_n_per_m / reduction * slip;
    for (const double opening : openings) {
      sum += face.tension_n_per_m / 2 * std::max(0.0, opening - bound.friction / reduction * slip);
    }
  }
  for (const Tie& tie : ties_) {
    const double stretch =
        tie.direction.dot(velocity(tie.b, mechanism, tie.at_b_m) - velocity(tie.a, mechanism, tie.at_a_m));
    const double force = stretch > 0 ? tie.high_n_per_m : tie.low_n_per_m;
    if (std::isfinite(force)) sum += force * stretch;  // what cannot yield does not stretch
  }
  return sum;
}

Point LimitAnalysis::velocity(int block, const Twists& mechanism, const Point& place) const {
  return block < 0 ? Point::Zero().eval() : velocity_at(mechanism[at(block)], place, centroids_[at(block)]);
}

Point LimitAnalysis::jump(const Face& face, const Twists& mechanism, const Point& place) const {
  return velocity(face.b, mechanism, place) - velocity(face.a, mechanism, place);
}

double LimitAnalysis::normalize(Twists& mechanism) const {
  double fastest = 0;
  for (std::size_t b = 0; b < mechanism.size(); ++b) {
    for (const Point& vertex : scene_.blocks[b].vertices) {
      fastest = std::max(fastest, velocity_at(mechanism[b], vertex, centroids_[b]).norm());
    }
  }
  if (fastest == 0) return 1;
  for (Twist& twist : mechanism) twist /= fastest;
  return fastest;
}

}  // namespace blockweir::solid::limit
