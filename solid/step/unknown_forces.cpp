// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/unknown_forces.hpp"

#include "bridge/scene/at.hpp"
#include "solid/step/island_equations.hpp"
#include "solid/step/island_matrix.hpp"

namespace blockweir::solid {

void UnknownForces::set(const IslandEquations& s, const WaterInertia& water) {
  unknown_.clear();
  if (formulation_->force_constraints() == nullptr) return;
  const std::vector<int>& contacts = s.island.contacts;
  const std::vector<int>& supports = s.island.supports;
  const std::size_t of_bolts = contacts.size() + supports.size();
  saddle_.set_zero();
  for (std::size_t k = 0; k < of_bolts; ++k) {
    const bool support = k >= contacts.size();
    add(s, s.actions[k], support, support ? supports[k - contacts.size()] : contacts[k]);
  }
  if (unknown_.empty()) return;
  const IslandMatrix matrix(model_, trial_, s);
  matrix.add_own(saddle_);
  for (std::size_t i = 0; i < s.bolts.size(); ++i) matrix.add_stiffness(saddle_, s.actions[of_bolts + i]);
  water.add_to_saddle(s, saddle_);
}

/// Columns and equations of what a contact or support has.
void UnknownForces::add(const IslandEquations& s, const Interaction& action, bool support, int index) {
  const ForceConstraints& constraints = *formulation_->force_constraints();
  for (const Constraint& c : support ? constraints.of_support(index) : constraints.of_contact(index)) {
    saddle_.add_force(c.violation, c.compliance);
    unknown_.push_back({support, index, c.force});
    for (const bool second : {false, true}) {
      const int block = action.block(second);
      if (!trial_.moves(block)) continue;
      const Matrix26 shape = (second ? -1 : 1) * action.shape(trial_.placement[at(block)], second);
      saddle_.couple(s.local(block), shape.transpose() * c.force, shape.transpose() * c.row);
    }
  }
}

bool UnknownForces::solve(IslandEquations& s) {
  if (!saddle_.solve(s.residual, s.correction, forces_)) return false;
  correct(s);
  return true;
}

void UnknownForces::correct(const IslandEquations& s) {
  std::size_t next = 0;  // of the unknown forces; those of a contact or support follow each other
  const auto force_of = [&](bool support, int index) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (; next < unknown_.size(); ++next) {
      const UnknownForce& unknown = unknown_[next];
      if (unknown.support != support || unknown.index != index) break;
      sum += forces_[static_cast<Eigen::Index>(next)] * unknown.force;
    }
    return sum;
  };
  const ForceConstraints& constraints = *formulation_->force_constraints();
  for (const int k : s.island.contacts) constraints.correct(state_.contacts[at(k)], force_of(false, k));
  for (const int k : s.island.supports) constraints.correct(state_.supports[at(k)], force_of(true, k));
}

}  // namespace blockweir::solid
