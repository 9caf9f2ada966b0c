// SPDX-License-Identifier: GPL-3.0-or-later
// Energy that the exchange itself produces: energy that the blocks receive and the water does not give.
#pragma once

#include <optional>
#include <string>

#include "bridge/wire/message.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Energy produced up to T_k: the water's work on the blocks summed over the solid's steps (WaterWork), less the sum
/// of (F_k + F_k-1)/2 (d_k - d_k-1), the work as the fluid sees it; F_k are the pressure forces at the positions that
/// were sent to the fluid. With a stable schedule of order q the difference vanishes relative to the work as window^q;
/// with an unstable one it is the whole energy that blocks and water gain.
///
/// An instability is reported when this happens five times in a row, each within 40 windows: the exchange produces
/// three times the earlier kinetic energy of the blocks and their added mass, and more than half of the work that the
/// water does or takes in that time. A growth of displacements below 1.7 % in a window is not detected.
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
  /// Of a growth too slow to be reported as an instability: what the exchange has produced is small neither beside the
  /// largest kinetic energy nor beside the water's work. Empty if it is.
  [[nodiscard]] std::string warning() const;
  /// Message: the window, the reason, the remedy; `ratio`: added mass over block mass.
  [[nodiscard]] std::string trouble(double ratio) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(forces_, sent_, solid_work_, windows_, now_, mark_, largest_kinetic_, most_kinetic_, scale_, times_,
            suspect_, growth_);
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
  double least_;                         ///< that moves nothing noticeably [J per metre]
  std::vector<Eigen::Vector3d> forces_;  ///< F of the last exchange
  std::vector<Eigen::Vector3d> sent_;    ///< d of the last exchange
  double solid_work_ = 0;                ///< at the end of the last window
  std::uint64_t windows_ = 0;
  State now_;
  State mark_;                  ///< start of the present sum
  double largest_kinetic_ = 0;  ///< since mark_
  double most_kinetic_ = 0;     ///< of the run
  double scale_ = 0;            ///< largest before mark_
  int times_ = 0;               ///< consecutive detections
  State suspect_;               ///< the first of them
  std::optional<Growth> growth_;
};

}  // namespace blockweir::solid
