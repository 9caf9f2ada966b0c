// SPDX-License-Identifier: GPL-3.0-or-later
// How heavy is the water that blocks push, against the blocks themselves? An explicit schedule hangs on that ratio.
#pragma once

#include <string>

#include "bridge/wire/message.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid::output {

class AddedMassWatch {
 public:
  /// The added masses of a load, none where the analysis has no inertia. Throws std::runtime_error where they are not
  /// one a block or no inertia, or so large that the schedule is unstable: beyond a block's own mass without the guard,
  /// beyond a hundred times with it.
  AddedMasses look(const wire::Load& load, const Solid& solid);

  /// Largest ratio of all loads: eigenvalue of M^-1 M_a over a block's rigid modes; 0 where no fluid has said any.
  [[nodiscard]] double ratio() const { return ratio_; }
  [[nodiscard]] const std::string& block() const { return block_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(ratio_, block_);
  }

 private:
  double ratio_ = 0;
  std::string block_;
};

}  // namespace blockweir::solid::output
