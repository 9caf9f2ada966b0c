// SPDX-License-Identifier: GPL-3.0-or-later
// Which law holds between which two blocks.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "bridge/scene/scene.hpp"
#include "solid/contact/joint_law.hpp"

namespace blockweir::solid {

/// A joint law with angles as tangents.
struct JointProperties {
  double friction = 0;
  double residual_friction = 0;
  double cohesion_pa = 0;
  double tension_pa = 0;
  double bonded_length_m = -1;  ///< of the whole joint; negative: all of it
  bool keeps_cohesion = false;
  int joint = -1;  ///< index into Scene::joints, -1 for the default
};

class JointLaws {
 public:
  explicit JointLaws(const scene::Scene& scene);

  [[nodiscard]] int between(int block_a, int block_b) const {
    const auto found = by_pair_.find(key(block_a, block_b));
    return found == by_pair_.end() ? 0 : found->second;
  }
  [[nodiscard]] const JointProperties& operator[](int law) const { return laws_[static_cast<std::size_t>(law)]; }

 private:
  static std::uint64_t key(int a, int b) {
    const auto low = static_cast<std::uint64_t>(a < b ? a : b);
    const auto high = static_cast<std::uint64_t>(a < b ? b : a);
    return low << 32U | high;
  }
  std::vector<JointProperties> laws_;
  std::unordered_map<std::uint64_t, int> by_pair_;
};

}  // namespace blockweir::solid
