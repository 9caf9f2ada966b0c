// SPDX-License-Identifier: GPL-3.0-or-later
// Energy that the exchange itself produces: energy that the blocks receive and the water does not give.
#pragma once

#include <optional>
#include <string>

#include "bridge/wire/message.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Made up to T_k: work of the water on the blocks as the solid's steps count it (WaterWork), less the sum of
/// (F_k + F_k-1)/2 (d_k - d_k-1), as the fluid counts it, F_k the pressures' forces on the blocks where the fluid was
/// sent that they are. A stable schedule of order q errs by a part of the work that vanishes with window^q; an
/// unstable one makes all that blocks and water gain.
///
/// That is the mark: five times in a row, each within 40 windows, the exchange has made three times as much as there
/// was before, of kinetic energy of the blocks and of the water that they push, and more than half of what the water
/// has given or taken in the same time. What grows by less than 1.7 % a window in its displacements is not seen.
class InterfaceEnergy {
 public:
  explicit InterfaceEnergy(const Solid& solid);

  struct Window {
    double from_s;
    double to_s;
  };
  /// Call when the blocks have settled: their motion until then is not counted.
  void begin();
  /// Call after a window under the panels that answer `sent`; kinetic energy includes that of the added masses.
  void look(const std::vector<Panel>& panels, const wire::Motion& sent, const Window& window, double kinetic_j_per_m);

  /// The start of an instability.
  struct Growth {
    std::uint64_t window;
    double time_s;
    template <class Archive>
    void serialize(Archive& archive) {
      archive(window, time_s);
    }
  };
  [[nodiscard]] const std::optional<Growth>& growth() const { return growth_; }
  [[nodiscard]] bool looked() const { return windows_ > 0; }
  [[nodiscard]] double made_j_per_m() const { return now_.made; }
  /// Message: the window, the reason, the remedy; `ratio`: added mass over block mass.
  [[nodiscard]] std::string trouble(double ratio) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(forces_, sent_, solid_work_, windows_, now_, mark_, largest_kinetic_, scale_, times_, suspect_, growth_);
  }

 private:
  struct State {
    std::uint64_t window = 0;
    double time_s = 0;
    double made = 0;
    double given = 0;  ///< by the water, summed as the fluid does
    template <class Archive>
    void serialize(Archive& archive) {
      archive(window, time_s, made, given);
    }
  };
  void judge(double kinetic);

  const Solid& solid_;
  double least_;                         ///< kinetic energy of blocks at rest [J per metre]
  std::vector<Eigen::Vector3d> forces_;  ///< F of the last exchange
  std::vector<Eigen::Vector3d> sent_;    ///< d of the last exchange
  double solid_work_ = 0;                ///< at the end of the last window
  std::uint64_t windows_ = 0;
  State now_;
  State mark_;                  ///< start of the present sum
  double largest_kinetic_ = 0;  ///< since mark_
  double scale_ = 0;            ///< largest before mark_
  int times_ = 0;               ///< consecutive detections
  State suspect_;               ///< the first of them
  std::optional<Growth> growth_;
};

}  // namespace blockweir::solid
