// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/expect/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "solid/expect/point_figures.hpp"
#include "solid/expect/quantity_tables.hpp"

namespace blockweir::solid::expect {
namespace {

const Quantities& quantities() {
  static const Quantities all = [] {
    Quantities sum = state_quantities();
    sum.insert(pile_quantities().begin(), pile_quantities().end());
    sum.insert(series_quantities().begin(), series_quantities().end());
    return sum;
  }();
  return all;
}

}  // namespace

std::size_t block_index(const Solid& solid, const std::string& name) {
  const auto& blocks = solid.blocks();
  for (const scene::Joint& joint : solid.scene().joints) {
    if (joint.name != name) continue;
    const auto a = static_cast<std::size_t>(joint.between[0]);
    const auto b = static_cast<std::size_t>(joint.between[1]);
    return blocks[a].centroid.y() > blocks[b].centroid.y() ? a : b;
  }
  const auto found = std::find_if(blocks.begin(), blocks.end(), [&](const Block& b) { return b.name == name; });
  if (found == blocks.end())
    throw std::runtime_error(fmt::format("[[expect]] of = \"{}\" names no block or joint", name));
  return static_cast<std::size_t>(found - blocks.begin());
}

const Failure* failure_of(const Outcome& o, const std::string& subject) {
  const auto& failures = o.failure.failures();
  const int block = subject.empty() ? -1 : static_cast<int>(block_index(o.solid, subject));
  const auto found = std::find_if(failures.begin(), failures.end(), [&](const Failure& f) {
    return block < 0 || std::count(f.blocks.begin(), f.blocks.end(), block) > 0;
  });
  return found == failures.end() ? nullptr : &*found;
}

std::vector<std::string> quantity_names() {
  std::vector<std::string> names;
  for (const auto& [name, function] : quantities()) names.push_back(name);
  for (const auto& [name, function] : point_quantities()) names.push_back(name);
  return names;
}

double quantity(const Outcome& outcome, const scene::Expectation& expectation) {
  const auto at_point = point_quantities().find(expectation.quantity);
  if ((at_point != point_quantities().end()) != expectation.at_m.has_value()) {
    throw std::runtime_error(
        fmt::format("[[expect]] quantity = \"{}\" {}", expectation.quantity,
                    expectation.at_m ? "is none at a point: leave out at_m" : "needs at_m = [x, y]"));
  }
  if (expectation.at_m)
    return at_point->second(outcome.solid, block_index(outcome.solid, expectation.of), *expectation.at_m);
  const auto found = quantities().find(expectation.quantity);
  if (found == quantities().end()) {
    throw std::runtime_error(fmt::format("[[expect]] names no quantity: \"{}\"", expectation.quantity));
  }
  return found->second(outcome, expectation.of);
}

}  // namespace blockweir::solid::expect
