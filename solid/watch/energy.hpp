// SPDX-License-Identifier: GPL-3.0-or-later
// Mechanical energy of all that can move. Nothing but given loads and what leads may make it grow.
#pragma once

#include <string>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// J per metre of thickness.
struct Energy {
  double kinetic = 0;
  double strain = 0;
  double potential = 0;  ///< of weight, from where the scene draws the blocks

  [[nodiscard]] double total() const { return kinetic + strain + potential; }
};

Energy energy_of(const Solid& solid);

/// Energy made of nothing: the largest rise, above what it had been before, of the blocks' energy and what bolts and
/// springs hold, less the work of loads, of water and of what leads.
class EnergyWatch {
 public:
  void look(const Solid& solid);
  [[nodiscard]] const Energy& now() const { return now_; }
  /// Over what the run has had, at least what the weight gives as the structure fails: the largest sum of the three
  /// energies' sizes and the work. 0 where nothing has weight or moves.
  [[nodiscard]] double gain() const { return scale_ > 0 ? made_ / scale_ : 0; }
  /// J per metre.
  [[nodiscard]] double made_j_per_m() const { return made_; }
  /// Empty where that is little.
  [[nodiscard]] std::string warning(const Solid& solid) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(begun_, now_.kinetic, now_.strain, now_.potential, lowest_, made_, scale_);
  }

 private:
  bool begun_ = false;
  Energy now_;
  double lowest_ = 0;
  double made_ = 0;  ///< J per metre
  double scale_ = 0;
};

}  // namespace blockweir::solid
