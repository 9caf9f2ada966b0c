// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/interior_point.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {
namespace {

// What a contact gives to a change of its force, over the flexibility of its blocks. Redundant contacts, whose forces
// equilibrium leaves open, would else make the matrix singular; no change is left at the end, and no error with it.
constexpr double compliance_ratio = 1e-5;

// Of its force or its motion, what a pair may lose at once.
constexpr double most_lost = 0.99;

}  // namespace

double InteriorPoint::shear_bound(const ContactPoint& c, const Point& p) const {
  const double normal = p.normal.force - tension(c);
  return laws_.strength(c, normal).shear_bound(normal);
}

void InteriorPoint::begin(const Trial& trial, const std::vector<Matrix6>& matrix, const std::vector<bool>& frozen,
                          const IslandContacts& island) {
  Formulation::begin(trial, matrix, frozen, island);
  points_.assign(progress_.contacts(), {});
  lagged_.bounds.begin(progress_.contacts());
  scale_n_ = settings_.force_tolerance_n;
  for (const int k : island.contact_ids)
    scale_n_ = std::max(scale_n_, island.contacts[at(k)].force.cwiseAbs().maxCoeff());
  const bool forces_known = change_n_ < scale_n_;
  const double change = std::min(change_n_, scale_n_);
  for (const int k : island.contact_ids) {
    const ContactPoint& c = island.contacts[at(k)];
    Point& p = points_[at(k)];
    const double motion = change / progress_.contact(k).stiffness;
    const double product = change * motion;
    const auto balanced = [product](double force) { return Pair{.force = force, .motion = product / force}; };
    const double gap = progress_.follow(trial, k, c, edge_frame(trial, c)).separation.x();
    p.normal = balanced(gap > motion ? product / gap : std::max(change, c.force.x() + tension(c)));
    const double most = shear_bound(c, p);
    lagged_.bounds.set(k, most);
    p.has_friction = most > 0;
    if (!p.has_friction) continue;
    const double least = std::min(most, change);
    p.shear = forces_known ? std::clamp(c.force.y(), -most, most) : 0;
    p.forward = balanced(std::max(least, most + p.shear));
    p.backward = balanced(std::max(least, most - p.shear));
  }
  product_ = 0;
  fraction_ = 1;
}

Interaction InteriorPoint::contact(const Trial& trial, int index, ContactPoint& c) {
  const EdgeFrame edge = edge_frame(trial, c);
  Point& p = points_[at(index)];
  p.separation = progress_.follow(trial, index, c, edge).separation;
  const double compliance = compliance_ratio / progress_.contact(index).stiffness;
  const Pair& n = p.normal;
  p.stiffness.x() = 1 / (1 / n.stiffness() + compliance);
  p.force.x() = n.force + p.stiffness.x() * (n.lacks(product_) - (p.separation.x() - n.motion));
  if (p.has_friction) {
    const Pair& f = p.forward;
    const Pair& b = p.backward;
    const double most = lagged_.bounds[index];
    const double slip = f.lacks(product_) - (most + p.shear - f.force) / f.stiffness() -
                        (b.lacks(product_) - (most - p.shear - b.force) / b.stiffness());
    p.stiffness.y() = 1 / (1 / f.stiffness() + 1 / b.stiffness() + compliance);
    p.force.y() = p.shear + p.stiffness.y() * (slip - (p.separation.y() - (f.motion - b.motion)));
  }
  Interaction action = interaction_of(c, edge, p.separation.y());
  action.force = p.force - Eigen::Vector2d(tension(c), 0);
  action.stiffness = p.stiffness.asDiagonal().toDenseMatrix();
  return action;
}

Interaction InteriorPoint::support(const Trial& trial, int index, Support& s) {
  const Separation separation = separation_of(trial, s);
  const double penalty = progress_.support(index).stiffness / compliance_ratio;
  Interaction action = interaction_of(s);
  action.force = s.multiplier - penalty * separation.value;
  action.stiffness = (penalty * s.held()).asDiagonal().toDenseMatrix();
  return action;
}

void InteriorPoint::follow(Pair& pair, double change) const {
  pair.force_change = change;
  pair.motion_change = pair.lacks(product_) - change / pair.stiffness();
}

double InteriorPoint::find_changes(const Trial& trial, const IslandContacts& island) {
  double fraction = 1;
  for (const int k : island.contact_ids) {
    const ContactPoint& c = island.contacts[at(k)];
    Point& p = points_[at(k)];
    const Eigen::Vector2d moved = progress_.follow(trial, k, c, edge_frame(trial, c)).separation - p.separation;
    const Eigen::Vector2d force = p.force - p.stiffness.cwiseProduct(moved);
    follow(p.normal, force.x() - p.normal.force);
    if (!p.has_friction) continue;
    const double most = lagged_.bounds[k];
    p.shear_change = force.y() - p.shear;
    follow(p.forward, most + force.y() - p.forward.force);
    follow(p.backward, most - force.y() - p.backward.force);
  }
  for_pairs(island, [&](const Pair& pair) { fraction = std::min(fraction, pair.positive_fraction(most_lost)); });
  return fraction;
}

double InteriorPoint::mean_product(const IslandContacts& island, double fraction) {
  double sum = 0;
  double count = 0;
  for_pairs(island, [&](const Pair& pair) {
    sum += pair.product_after(fraction);
    ++count;
  });
  return sum / std::max(1.0, count);
}

void InteriorPoint::predict(const Trial& trial, const IslandContacts& island) {
  const double fraction = find_changes(trial, island);
  const double now = mean_product(island, 0);
  const double share = std::max(0.0, mean_product(island, fraction)) / now;
  product_ = std::max(share * share * share, fraction_ > 0.5 ? 0 : 0.3) * now;
  for_pairs(island, [fraction](Pair& pair) {
    pair.product_change = fraction * fraction * pair.force_change * pair.motion_change;
  });
}

double InteriorPoint::follow_correction(const Trial& trial, const IslandContacts& island) {
  constexpr double least = 0.5;
  const double fraction = std::max(least, find_changes(trial, island));
  for (const int k : island.contact_ids) points_[at(k)].shear += fraction * points_[at(k)].shear_change;
  for_pairs(island, [fraction](Pair& pair) {
    const double own = std::min(fraction, pair.positive_fraction(most_lost));
    pair.force += own * pair.force_change;
    pair.motion += own * pair.motion_change;
    pair.product_change = 0;
  });
  const auto allowed = [&](int k) { return shear_bound(island.contacts[at(k)], points_[at(k)]); };
  lagged_.bounds.follow(island.contact_ids, allowed, [](int /*k*/) { return 0.0; });
  product_ = 0;
  return fraction_ = fraction;
}

void InteriorPoint::hand_over(const IslandContacts& island) const {
  for (const int k : island.contact_ids) {
    ContactPoint& c = island.contacts[at(k)];
    const Point& p = points_[at(k)];
    const double stiffness = progress_.contact(k).stiffness;
    c.multiplier.setZero();
    c.state = ContactState::open;
    if (p.normal.stiffness() > stiffness) {
      const double most = p.has_friction ? shear_bound(c, p) : 0;
      const bool slips = !p.has_friction || std::min(p.forward.stiffness(), p.backward.stiffness()) < stiffness;
      c.multiplier = {p.normal.force - tension(c), std::clamp(p.shear, -most, most)};
      c.state = slips ? ContactState::slip : ContactState::stick;
    }
    c.force = c.multiplier;
  }
}

}  // namespace blockweir::solid
