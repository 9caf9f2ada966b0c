// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that divide the structure, along which a part could slide or lift off: single joints, or joints in one line.
//
// A joint within a network of joints or a brick bond cannot slide by itself, so the reserve of its forces says
// nothing. A surface runs through the structure if some block has no connection to the ground without its contacts.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

class Surfaces {
 public:
  /// From the joints that touch in the scene as drawn. Fixed blocks and blocks with a support are the ground.
  explicit Surfaces(const Solid& solid);
  Surfaces() = default;
  /// Planes of the joints, cuts and joint sets with these names that are no surface by themselves, such as one of two
  /// joints along which a wedge slides. Joints that bend have none.
  static Surfaces parts(const Solid& solid, const std::vector<std::string>& names);

  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// Weight of everything that each surface separates from the ground [N/m], by index.
  [[nodiscard]] const std::vector<double>& weights() const { return weights_; }
  /// Pairs of blocks of each surface, by its index.
  [[nodiscard]] std::vector<std::set<std::pair<int, int>>> joints() const;
  /// Indices of the surfaces that contain the joint of two blocks (lower index first); may be empty.
  [[nodiscard]] const std::vector<int>& of(const std::pair<int, int>& pair) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(names_, weights_, of_pair_);
  }

 private:
  void add(const std::set<std::pair<int, int>>& joints, const std::string& name, double weight_n_per_m);

  std::vector<std::string> names_;
  std::vector<double> weights_;
  std::map<std::pair<int, int>, std::vector<int>> of_pair_;
};

/// Names of the joints that divide the structure and are no surface, because they bend: one sliding factor, or one
/// resultant, does not belong to several planes.
std::vector<std::string> bent_joints(const Solid& solid);

}  // namespace blockweir::solid
