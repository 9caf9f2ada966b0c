// SPDX-License-Identifier: GPL-3.0-or-later
// Mechanical energy of all moving blocks. Only loads and prescribed motion may increase it.
#pragma once

#include <string>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// J per metre of thickness.
struct Energy {
  double kinetic = 0;
  double strain = 0;
  double potential = 0;  ///< of weight, from the scene as drawn

  [[nodiscard]] double total() const { return kinetic + strain + potential; }
};

Energy energy_of(const Solid& solid);

/// Spurious energy: the largest rise above any earlier value of the blocks' energy plus that of bolts and springs, less
/// the work of loads, water and prescribed motion.
class EnergyWatch {
 public:
  void look(const Solid& solid);
  [[nodiscard]] const Energy& now() const { return now_; }
  /// Relative to the energy of the run, which is at least the work of weight during the failure displacement: the
  /// largest sum of the absolute energies and the work. 0 if nothing has weight or moves.
  [[nodiscard]] double gain() const { return scale_ > 0 ? made_ / scale_ : 0; }
  /// J per metre.
  [[nodiscard]] double made_j_per_m() const { return made_; }
  /// Empty if the gain is small.
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
