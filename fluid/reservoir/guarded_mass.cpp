// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/guarded_mass.hpp"

#include <algorithm>
#include <functional>

#include "bridge/scene/at.hpp"

namespace blockweir::reservoir {

void GuardedMass::add(const WaterAnswer& answer, double share) {
  const std::size_t before = between_.size();
  const Eigen::Index count = answer.mass.rows() - 2;  // without the ground's
  const auto motion = [&](Eigen::Index mode) { return answer.modes[static_cast<std::size_t>(mode)].motion; };
  for (Eigen::Index i = 0; i < count; i += 3) {
    const Eigen::Matrix3d m = share * answer.mass.block<3, 3>(i, i);
    const std::array<double, 6> more{m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
    auto& row = own_[at(motion(i))];
    std::transform(row.begin(), row.end(), more.begin(), row.begin(), std::plus<>());
    for (Eigen::Index j = i + 3; j < count; j += 3) {  // modes are in the order of the motions
      const std::array pair{static_cast<std::uint32_t>(motion(i)), static_cast<std::uint32_t>(motion(j))};
      between_.push_back({pair, share * answer.mass.block<3, 3>(i, j)});
    }
  }
  if (before > 0) sum_up_pairs();
}

/// Each pair once.
void GuardedMass::sum_up_pairs() {
  std::stable_sort(between_.begin(), between_.end(), [](const auto& a, const auto& b) { return a.pair < b.pair; });
  std::size_t last = 0;
  for (std::size_t i = 1; i < between_.size(); ++i) {
    if (between_[i].pair == between_[last].pair) {
      between_[last].mass += between_[i].mass;
    } else {
      between_[++last] = between_[i];
    }
  }
  between_.resize(last + 1);
}

void GuardedMass::write(wire::Load& load) const {
  load.added_mass.own() = own_;
  load.coupled.clear();
  load.added_mass_between.clear();
  auto& coupled = load.coupled.own();
  auto& between = load.added_mass_between.own();
  for (const auto& [pair, mass] : between_) {
    coupled.push_back(pair);
    std::copy_n(mass.data(), 9, between.emplace_back().begin());
  }
}

}  // namespace blockweir::reservoir
