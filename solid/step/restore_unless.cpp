// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/restore_unless.hpp"

#include <vector>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {

bool restore_unless(StepWorkspace& step, IslandEquations& s, const StepMode& mode,
                    const std::function<bool()>& search) {
  std::vector<ContactMemory> contacts;
  std::vector<Support> supports;
  std::vector<Vector6> increments;
  std::vector<Point> nodes;
  for (const int k : s.island.contacts) contacts.push_back(step.state.contacts[at(k)]);
  for (const int k : s.island.supports) supports.push_back(step.state.supports[at(k)]);
  for (const int b : s.island.blocks) increments.push_back(step.trial.increment[at(b)]);
  for (const auto& [node, first] : s.unknowns->nodes) nodes.push_back(step.trial.node_increment[at(node)]);
  if (search()) return true;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    static_cast<ContactMemory&>(step.state.contacts[at(s.island.contacts[i])]) = contacts[i];
  }
  for (std::size_t i = 0; i < supports.size(); ++i) step.state.supports[at(s.island.supports[i])] = supports[i];
  for (std::size_t i = 0; i < nodes.size(); ++i) step.trial.node_increment[at(s.unknowns->nodes[i].first)] = nodes[i];
  for (std::size_t i = 0; i < increments.size(); ++i) {
    const auto b = at(s.island.blocks[i]);
    step.trial.go_to(b, increments[i]);
  }
  if (mode.friction_lags) step.formulation->lagged_friction()->begin(s.island_contacts());
  return false;
}

}  // namespace blockweir::solid
