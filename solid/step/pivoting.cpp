// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/pivoting.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "solid/step/newton.hpp"

namespace blockweir::solid {

/// Contacts that only press and rub, and formulations that take up forces from a step before.
bool Pivoting::fits(const IslandEquations& s, const StepMode& mode) const {
  const FormulationSettings& settings = formulation_->settings();
  return formulation_->lagged_friction() != nullptr && !mode.friction_lags && !settings.joints_held &&
         s.unknowns->total <= large_island && !s.unknowns->shared() &&
         std::none_of(s.island.contacts.begin(), s.island.contacts.end(), [&](int k) {
           const JointProperties& law = model_.laws[state_.contacts[at(k)].law];
           return law.bonds() || law.dilates() || !law.is_straight();
         });
}

/// Gaps and slips at those of an island's contacts that may close in the step, and how forces there change them; the
/// correction is that without them. False where there is none.
bool Pivoting::release_contacts(IslandEquations& s, Released& released) {
  for (const int k : s.island.contacts) {
    state_.contacts[at(k)].multiplier.setZero();
    state_.contacts[at(k)].penalty = 0;
  }
  if (!std::isfinite(s.unbalanced()) || !s.solve_linearized()) return false;
  double near = s.correction.cwiseAbs().maxCoeff();  // m: what is farther off blocks do not reach
  for (const int b : s.island.blocks) near = std::max(near, trial_.increment[at(b)].cwiseAbs().maxCoeff());
  released = {};
  std::vector<Eigen::VectorXd> pulls;
  std::vector<double> apart;
  for (const int k : s.island.contacts) {
    const ContactPoint& c = state_.contacts[at(k)];
    const EdgeFrame edge = edge_frame(trial_.now(), c);
    const Separation separation = separation_of(trial_.now(), c, edge);
    if (separation.value.x() > near) continue;
    const Interaction action = interaction_of(c, edge, separation.value.y());
    for (const Point& axis : {action.axis, perpendicular(action.axis)}) {
      Eigen::VectorXd& pull = pulls.emplace_back(Eigen::VectorXd::Zero(s.unknowns->total));
      for (const bool second : {false, true}) {
        const int block = action.block(second);
        if (!trial_.moves(block)) continue;
        s.unknowns->add(s.local(block),
                        trial_.placement[at(block)].generalized((second ? -1 : 1) * axis, action.at(second)), pull);
      }
    }
    apart.insert(apart.end(), {separation.value.x(), separation.value.y()});
    released.ids.push_back(k);
    released.contacts.friction.push_back(model_.laws.strength(c, c.force.x()).friction);
  }
  const auto n = static_cast<Eigen::Index>(pulls.size());
  Eigen::MatrixXd pull(s.unknowns->total, n);
  released.moves_by.resize(s.unknowns->total, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    pull.col(i) = pulls[at(i)];
    released.moves_by.col(i) = s.system().solve_again(pulls[at(i)]);
  }
  released.contacts.apart = Eigen::VectorXd::Map(apart.data(), n) + pull.transpose() * s.correction;
  released.contacts.flexibility = pull.transpose() * released.moves_by;
  return true;
}

bool Pivoting::find(IslandEquations& s, const StepMode& mode) {
  constexpr int most_rounds = 10;
  if (!fits(s, mode)) return false;
  ++counts_.pivoted_islands;
  const IslandContacts contacts = s.island_contacts();
  formulation_->undo(contacts);
  for (const int b : s.island.blocks) trial_.predict(at(b));
  formulation_->begin(trial_.at_start(), trial_.matrix, trial_.frozen, contacts);
  std::vector<double> penalty;
  for (const int k : s.island.contacts) penalty.push_back(state_.contacts[at(k)].penalty);
  Released released;
  Eigen::VectorXd forces;
  for (int round = 0; round < most_rounds; ++round) {
    if (!release_contacts(s, released)) return false;
    const auto found = coulomb_forces(released.contacts);
    if (!found) return false;
    forces = *found;
    s.correction += released.moves_by * forces;
    s.move(1);
    if (s.correction.cwiseAbs().maxCoeff() <= formulation_->settings().position_round_off_m) break;
  }
  for (std::size_t i = 0; i < penalty.size(); ++i) state_.contacts[at(s.island.contacts[i])].penalty = penalty[i];
  for (std::size_t i = 0; i < released.ids.size(); ++i) {
    ContactPoint& c = state_.contacts[at(released.ids[i])];
    c.multiplier = forces.segment<2>(2 * static_cast<Eigen::Index>(i));
    c.state = c.multiplier.x() > 0 ? ContactState::stick : ContactState::open;
  }
  return Newton(step_).find(s, mode);
}

}  // namespace blockweir::solid
