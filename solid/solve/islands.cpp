// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/islands.hpp"

#include <algorithm>
#include <numeric>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {
namespace {

int root(std::vector<int>& parent, int b) {
  while (parent[at(b)] != b) b = parent[at(b)] = parent[at(parent[at(b)])];
  return b;
}

}  // namespace

std::vector<Island> find_islands(const std::vector<bool>& fixed, const std::vector<std::pair<int, int>>& links,
                                 const std::vector<int>& support_blocks,
                                 const std::vector<std::pair<int, int>>& joined) {
  std::vector<int> parent(fixed.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto join = [&](const std::pair<int, int>& pair) {
    if (fixed[at(pair.first)] || fixed[at(pair.second)]) return;
    const int ra = root(parent, pair.first);
    const int rb = root(parent, pair.second);
    parent[at(std::max(ra, rb))] = std::min(ra, rb);
  };
  std::for_each(links.begin(), links.end(), join);
  std::for_each(joined.begin(), joined.end(), join);

  std::vector<Island> islands;
  std::vector<int> island_of(fixed.size(), -1);
  std::vector<int> local(fixed.size(), -1);
  for (int b = 0; b < static_cast<int>(fixed.size()); ++b) {
    if (fixed[at(b)]) continue;
    const int r = root(parent, b);
    if (island_of[at(r)] < 0) {
      island_of[at(r)] = static_cast<int>(islands.size());
      islands.emplace_back();
    }
    island_of[at(b)] = island_of[at(r)];
    local[at(b)] = static_cast<int>(islands[at(island_of[at(b)])].blocks.size());
    islands[at(island_of[at(b)])].blocks.push_back(b);
  }
  for (std::size_t k = 0; k < links.size(); ++k) {
    const auto& [a, b] = links[k];
    if (fixed[at(a)] && fixed[at(b)]) continue;  // beside the ground, waiting while others settle
    Island& island = islands[at(island_of[at(fixed[at(a)] ? b : a)])];
    island.contacts.push_back(static_cast<int>(k));
    if (!fixed[at(a)] && !fixed[at(b)]) island.couples.emplace_back(std::minmax({local[at(a)], local[at(b)]}));
  }
  for (const auto& [a, b] : joined) {
    if (fixed[at(a)] || fixed[at(b)]) continue;
    islands[at(island_of[at(a)])].couples.emplace_back(std::minmax({local[at(a)], local[at(b)]}));
  }
  for (std::size_t k = 0; k < support_blocks.size(); ++k) {
    if (!fixed[at(support_blocks[k])]) {
      islands[at(island_of[at(support_blocks[k])])].supports.push_back(static_cast<int>(k));
    }
  }
  for (Island& island : islands) {
    std::sort(island.couples.begin(), island.couples.end());
    island.couples.erase(std::unique(island.couples.begin(), island.couples.end()), island.couples.end());
  }
  return islands;
}

Island join(const std::vector<Island>& islands) {
  Island all;
  for (const Island& island : islands) {
    const auto first = static_cast<int>(all.blocks.size());
    all.blocks.insert(all.blocks.end(), island.blocks.begin(), island.blocks.end());
    all.contacts.insert(all.contacts.end(), island.contacts.begin(), island.contacts.end());
    all.supports.insert(all.supports.end(), island.supports.begin(), island.supports.end());
    for (const auto& [a, b] : island.couples) all.couples.emplace_back(first + a, first + b);
  }
  const std::vector<int> apart = all.blocks;
  std::sort(all.blocks.begin(), all.blocks.end());
  const auto now = [&](int local) {
    const auto place = std::lower_bound(all.blocks.begin(), all.blocks.end(), apart[at(local)]);
    return static_cast<int>(place - all.blocks.begin());
  };
  for (auto& couple : all.couples) couple = std::minmax({now(couple.first), now(couple.second)});
  std::sort(all.couples.begin(), all.couples.end());
  return all;
}

}  // namespace blockweir::solid
