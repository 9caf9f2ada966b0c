// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/limit/limit_analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bridge/scene/structure_size.hpp"
#include "bridge/statics/loads.hpp"
#include "solid/limit/determinacy.hpp"
#include "solid/limit/limit_program.hpp"

namespace blockweir::solid::limit {
namespace {

bool any_moves(const scene::Scene& scene) {
  return std::any_of(scene.blocks.begin(), scene.blocks.end(), [](const auto& block) { return !block.fixed; });
}

std::vector<Face> held_by(const scene::Scene& scene, Kinks kinks) {
  std::vector<Face> faces = faces_of(scene);
  if (kinks == Kinks::give_way) std::erase_if(faces, [](const Face& face) { return face.in_kink; });
  return faces;
}

/// The bound that a mechanism meets which opens the face by so much a slip: that of associated flow between the two
/// tangents beside it.
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

LimitAnalysis::LimitAnalysis(const scene::Scene& scene, Kinks kinks)
    : scene_(scene),
      centroids_(statics::centroids_of(scene)),
      faces_(held_by(scene, kinks)),
      ties_(ties_of(scene)),
      is_exact_(follow_from_equilibrium(scene, faces_, ties_)),
      size_m_(scene::structure_size_m(scene.blocks)) {
  if (!any_moves(scene)) {
    throw std::invalid_argument("limit analysis: all blocks are fixed; expected one that can move, set fixed = false");
  }
  const Wrenches weights = statics::weights_of(scene);
  for (std::size_t b = 0; b < weights.size(); ++b) {
    if (!scene.blocks[b].fixed) weight_n_per_m_ += weights[b].head<2>().norm();
  }
  if (weight_n_per_m_ == 0) weight_n_per_m_ = 1;
}

bool LimitAnalysis::holds_any_force() const {
  return std::any_of(scene_.bolts.begin(), scene_.bolts.end(), [](const auto& bolt) { return !bolt.yield_n_per_m; });
}

LargestFactor LimitAnalysis::largest_factor(const Wrenches& dead, const Wrenches& live) const {
  Program program(*this, dead, /*reduction=*/1);
  const int factor = program.add_factor(live);
  if (!program.solve()) return {};
  if (program.add_tangents(faces_, /*reduction=*/1)) return largest_factor(dead, live);
  LargestFactor found{.bearing = Bearing::fails_at_a_factor, .factor = program.value(factor)};
  if (found.factor >= largest_factor_told) return {.bearing = Bearing::bears_any};
  found.mechanism = program.mechanism();
  normalize(found.mechanism);
  const double of_mechanism =
      (resistance(found.mechanism) - power(dead, found.mechanism)) / power(live, found.mechanism);
  found.gap = std::abs(of_mechanism - found.factor) / std::max(std::abs(of_mechanism), std::abs(found.factor));
  return found;
}

bool LimitAnalysis::bears(const Wrenches& loads) const {
  const Wrenches nothing(loads.size(), Wrench::Zero());
  return largest_factor(loads, nothing).bearing == Bearing::bears_any;
}

std::optional<Shortage> LimitAnalysis::shortage(const Wrenches& loads, double reduction) const {
  Program program(*this, loads, reduction);
  const int ratio = program.add_shortage(/*price=*/1);
  if (!program.solve()) return std::nullopt;
  if (program.add_tangents(faces_, reduction)) return shortage(loads, reduction);
  Shortage found{.ratio = program.value(ratio),
                 .per_reduction = program.priced_strength() / (reduction * reduction),
                 .mechanism = program.mechanism()};
  if (found.ratio > 0) normalize(found.mechanism);
  return found;
}

Twists LimitAnalysis::collapse(const Wrenches& loads, bool however_strong) const {
  Program program(*this, loads, /*reduction=*/1);
  if (however_strong) program.add_shortage(/*price=*/0);
  program.add_imbalance();
  program.solve();
  if (!however_strong && program.add_tangents(faces_, /*reduction=*/1)) return collapse(loads, however_strong);
  Twists mechanism = program.mechanism();
  normalize(mechanism);
  return mechanism;
}

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

void LimitAnalysis::normalize(Twists& mechanism) const {
  double fastest = 0;
  for (std::size_t b = 0; b < mechanism.size(); ++b) {
    for (const Point& vertex : scene_.blocks[b].vertices) {
      fastest = std::max(fastest, velocity_at(mechanism[b], vertex, centroids_[b]).norm());
    }
  }
  if (fastest == 0) return;
  for (Twist& twist : mechanism) twist /= fastest;
}

}  // namespace blockweir::solid::limit
