// SPDX-License-Identifier: GPL-3.0-or-later
// Mechanical energy of all that can move. Nothing but given loads and a moving base may make it grow.
#pragma once

#include "solid/step/solid.hpp"

namespace blockweir::solid::output {

/// J per metre of thickness.
struct Energy {
  double kinetic = 0;
  double strain = 0;
  double potential = 0;  ///< of weight, from where the scene draws the blocks

  [[nodiscard]] double total() const { return kinetic + strain + potential; }
};

Energy energy_of(const Solid& solid);

/// The largest rise of the total above what it had been before.
class EnergyWatch {
 public:
  void look(const Solid& solid);
  [[nodiscard]] const Energy& now() const { return now_; }
  /// Over the largest sum of the three energies' sizes; 0 where nothing has moved.
  [[nodiscard]] double gain() const { return scale_ > 0 ? rise_ / scale_ : 0; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(begun_, now_.kinetic, now_.strain, now_.potential, lowest_, rise_, scale_);
  }

 private:
  bool begun_ = false;
  Energy now_;
  double lowest_ = 0;
  double rise_ = 0;
  double scale_ = 0;
};

}  // namespace blockweir::solid::output
