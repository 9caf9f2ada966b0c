// SPDX-License-Identifier: GPL-3.0-or-later
// Watches the ratio of added mass to block mass, on which the stability of an explicit schedule depends.
#pragma once

#include <optional>
#include <string>

#include "bridge/wire/message.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

class AddedMassWatch {
 public:
  /// The added masses in a load; none if the analysis has no inertia. Throws std::runtime_error if they are malformed,
  /// no inertia matrix, or larger than the scene's added_mass_limit. The default limit is the schedule's stability
  /// limit without the guard, at most a block's own mass; with the guard a hundred times that, checked at time 0 only;
  /// and none with the reservoir, whose mass is exact.
  AddedMasses look(const wire::Load& load, const Solid& solid);

  /// Largest ratio in all loads: eigenvalue of M^-1 M_a over a block's rigid modes; 0 if the fluid sends none.
  [[nodiscard]] double ratio() const { return ratio_; }
  [[nodiscard]] const std::string& block() const { return block_; }
  /// Empty unless the ratio is beyond the range in which the guard has been tested.
  [[nodiscard]] std::string warning(const scene::Scene& scene) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(ratio_, block_);
  }

 private:
  std::optional<double> limit_;  ///< of the scene, once needed
  double ratio_ = 0;
  std::string block_;
};

}  // namespace blockweir::solid
