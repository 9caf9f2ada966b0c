// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces along which a part of the structure could leave the rest: joints, or joints in one line, that run through.
//
// A joint of a mesh of joints, or of a bond of bricks, cannot slide by itself: what its forces have in reserve says
// nothing. One that runs through parts the structure: without its contacts some block has no connection to the ground.
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
  std::vector<std::string> names_;
  std::vector<double> weights_;
  std::map<std::pair<int, int>, std::vector<int>> of_pair_;
};

}  // namespace blockweir::solid
