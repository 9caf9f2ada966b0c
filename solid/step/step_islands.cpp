// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/step_islands.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "bridge/results/stopwatch.hpp"
#include "bridge/scene/at.hpp"

namespace blockweir::solid {

std::vector<std::pair<int, int>> StepIslands::links() const {
  std::vector<std::pair<int, int>> links;
  links.reserve(state_.contacts.size() + state_.bolts.size());
  for (const ContactPoint& c : state_.contacts) links.emplace_back(c.vertex_part, c.edge_part);
  for (const Bolt& bolt : state_.bolts) {
    if (bolt.part[1] >= 0 && trial_.moves(bolt.part[0]) && trial_.moves(bolt.part[1])) {
      links.emplace_back(bolt.part[0], bolt.part[1]);
    }
  }
  for (const auto& [a, b] : state_.guard.masses().links()) links.emplace_back(part_of(a), part_of(b));
  return links;
}

/// Of a block with a mesh its first triangle, to which all others are joined.
int StepIslands::part_of(int motion) const {
  const bool mean_of_mesh = at(motion) < model_.described() && model_.blocks[at(motion)].meshed;
  return mean_of_mesh ? model_.parts.triangles[at(motion)].front() : model_.water_motions.share(at(motion)).part;
}

void StepIslands::prepare() {
  const Stopwatch watch(profile_.islands);
  std::vector<std::pair<int, int>> now = links();
  const bool stand = now == links_;
  if (stand && !all_.empty()) return;
  links_ = std::move(now);
  make();
  if (stand && kept_.size() == all_.size()) {
    for (std::size_t i = 0; i < all_.size(); ++i) all_[i].system().restore(kept_[i]);
  }
  kept_.clear();
}

void StepIslands::make() {
  std::vector<int> support_blocks;
  for (const Support& s : state_.supports) support_blocks.push_back(s.block);
  std::vector<std::pair<int, int>> joined;
  for (const StrainCoupling& c : model_.parts.couplings) joined.emplace_back(c.i, c.j);
  std::vector<IslandEquations> before = std::exchange(all_, {});
  std::vector<IslandEquations*> alone(model_.blocks.size(), nullptr);  // what nothing touched stays as it is
  for (IslandEquations& s : before) {
    if (s.island.is_one_free() && s.bolts.empty()) alone[at(s.island.blocks.front())] = &s;
  }
  std::vector<std::size_t> island_of(model_.blocks.size());
  std::vector<Island> found = find_islands(trial_.frozen, links_, support_blocks, joined);
  if (!model_.scene.analysis.islands) found = {join(found)};
  counts_.most_islands = std::max(counts_.most_islands, static_cast<long>(found.size()));
  all_.reserve(found.size());
  std::vector<int> counts;
  std::vector<std::array<int, 3>> nodes;
  for (Island& island : found) {
    counts.clear();
    nodes.clear();
    if (island.is_one_free() && alone[at(island.blocks.front())] != nullptr) {
      island_of[at(island.blocks.front())] = all_.size();
      all_.push_back(std::move(*alone[at(island.blocks.front())]));
      continue;
    }
    for (const int b : island.blocks) {
      counts.push_back(model_.blocks[at(b)].unknowns());
      nodes.push_back(model_.blocks[at(b)].nodes);
      island_of[at(b)] = all_.size();
    }
    all_.emplace_back(step_, water_, numbers_, std::move(island), std::make_unique<Unknowns>(counts, nodes));
  }
  for (std::size_t c = 0; c < model_.parts.couplings.size(); ++c) {
    const auto part = at(model_.parts.couplings[c].i);
    if (!trial_.frozen[part]) all_[island_of[part]].couplings.push_back(static_cast<int>(c));
  }
  give_bolts_to_islands();
  for (const IslandEquations& s : all_) {
    for (std::size_t k = 0; k < s.island.blocks.size(); ++k) numbers_[at(s.island.blocks[k])] = static_cast<int>(k);
  }
  find_incidences();
}

/// Links beyond those of contacts were those of bolts, and of blocks that push the same water; a bolt belongs to the
/// island of what moves at its ends.
void StepIslands::give_bolts_to_islands() {
  const auto contacts = static_cast<int>(state_.contacts.size());
  std::vector<std::size_t> island_of(model_.blocks.size(), all_.size());
  for (std::size_t i = 0; i < all_.size(); ++i) {
    std::erase_if(all_[i].island.contacts, [&](int k) { return k >= contacts; });
    for (const int b : all_[i].island.blocks) island_of[at(b)] = i;
  }
  for (std::size_t k = 0; k < state_.bolts.size(); ++k) {
    for (const int b : state_.bolts[k].part) {
      if (b < 0 || island_of[at(b)] == all_.size()) continue;
      all_[island_of[at(b)]].bolts.push_back(static_cast<int>(k));
      break;
    }
  }
}

/// Of all that acts in an island, as the residual has it: contacts, supports, bolts.
void StepIslands::find_incidences() {
  const auto number = [this](int b) { return b < 0 || trial_.frozen[at(b)] ? -1 : numbers_[at(b)]; };
  for (IslandEquations& s : all_) {
    std::vector<std::pair<int, int>> ends;
    for (const int k : s.island.contacts)
      ends.emplace_back(state_.contacts[at(k)].vertex_part, state_.contacts[at(k)].edge_part);
    for (const int k : s.island.supports) ends.emplace_back(state_.supports[at(k)].block, -1);
    for (const int k : s.bolts) ends.emplace_back(state_.bolts[at(k)].part[0], state_.bolts[at(k)].part[1]);
    for (auto& [a, b] : ends) a = number(a), b = number(b);
    s.incidence = Incidence(s.island.blocks.size(), ends);
  }
}

std::vector<KeptFactors> StepIslands::kept_factors() const {
  if (!model_.scene.analysis.reuse_factors) return {};
  if (all_.empty()) return kept_;
  std::vector<KeptFactors> kept;
  for (const IslandEquations& s : all_) kept.push_back(s.system().kept_factors());
  return kept;
}

}  // namespace blockweir::solid
