// SPDX-License-Identifier: GPL-3.0-or-later
// How heavy is the water that blocks push, against the blocks themselves? An explicit schedule hangs on that ratio.
#pragma once

#include <optional>
#include <string>

#include "bridge/wire/message.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

class AddedMassWatch {
 public:
  /// The added masses of a load, none where the analysis has no inertia. Throws std::runtime_error where they are not
  /// one a block or no inertia, or larger than the scene's added_mass_limit. By default that is what the schedule is
  /// stable with without the guard, a block's own mass at most; with it a hundred times that, at time 0 only, and
  /// beside the reservoir, whose mass is exact, any.
  AddedMasses look(const wire::Load& load, const Solid& solid);

  /// Largest ratio of all loads: eigenvalue of M^-1 M_a over a block's rigid modes; 0 where no fluid has said any.
  [[nodiscard]] double ratio() const { return ratio_; }
  [[nodiscard]] const std::string& block() const { return block_; }
  /// Empty where the guard has been tried with as much.
  [[nodiscard]] std::string warning(const scene::Scene& scene) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(ratio_, block_);
  }

 private:
  std::optional<double> limit_;  ///< of the scene, once it has been asked for
  double ratio_ = 0;
  std::string block_;
};

}  // namespace blockweir::solid
