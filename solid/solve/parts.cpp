// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/parts.hpp"

#include "bridge/scene/at.hpp"
#include "solid/block/parallel.hpp"

namespace blockweir::solid {
namespace {

/// Neighbours of each body, one after the other.
struct Neighbours {
  std::vector<std::size_t> first;  ///< of each body, and the end of all
  std::vector<int> of;
};

Neighbours neighbours_of(std::span<const std::array<int, 2>> bodies, std::size_t body_numbers) {
  Neighbours all;
  all.first.assign(body_numbers + 1, 0);
  const auto joins = [](const std::array<int, 2>& ends) { return ends[0] >= 0 && ends[1] >= 0; };
  for (const auto& ends : bodies) {
    if (!joins(ends)) continue;
    for (const int b : ends) ++all.first[at(b) + 1];
  }
  for (std::size_t b = 0; b < body_numbers; ++b) all.first[b + 1] += all.first[b];
  all.of.resize(all.first.back());
  std::vector<std::size_t> next(all.first.begin(), all.first.end() - 1);
  for (const auto& ends : bodies) {
    if (!joins(ends)) continue;
    for (const std::size_t e : {0, 1}) all.of[next[at(ends[e])]++] = ends[1 - e];
  }
  return all;
}

/// The bodies of rows, from one to its neighbours, theirs, and so on.
std::vector<int> in_waves(std::span<const std::array<int, 2>> bodies, std::size_t body_numbers) {
  const Neighbours neighbours = neighbours_of(bodies, body_numbers);
  std::vector<char> seen(body_numbers);
  std::vector<int> order;
  const auto see = [&](int b) {
    if (b < 0 || seen[at(b)] != 0) return;
    seen[at(b)] = 1;
    order.push_back(b);
  };
  std::size_t next = 0;
  for (const auto& ends : bodies) {
    for (const int b : ends) {
      see(b);
      for (; next < order.size(); ++next) {
        const auto from = at(order[next]);
        for (std::size_t k = neighbours.first[from]; k < neighbours.first[from + 1]; ++k) see(neighbours.of[k]);
      }
    }
  }
  return order;
}

}  // namespace

std::vector<int> parts_of_rows(std::span<const std::array<int, 2>> bodies, std::size_t body_numbers) {
  if (bodies.size() < many) return {};
  const std::vector<int> order = in_waves(bodies, body_numbers);
  std::vector<int> part_of_body(body_numbers, 0);
  for (std::size_t n = 0; n < order.size(); ++n)
    part_of_body[at(order[n])] = static_cast<int>(sweep_parts * n / order.size());
  std::vector<int> part(bodies.size(), 0);
  for (std::size_t row = 0; row < bodies.size(); ++row) {
    const auto [a, b] = bodies[row];
    if (a < 0 && b < 0) continue;
    const int of_a = part_of_body[at(a < 0 ? b : a)];
    const int of_b = part_of_body[at(b < 0 ? a : b)];
    part[row] = of_a == of_b ? of_a : sweep_parts;
  }
  return part;
}

}  // namespace blockweir::solid
