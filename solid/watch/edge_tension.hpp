// SPDX-License-Identifier: GPL-3.0-or-later
// Warns where the bond of blocks without a mesh carries more than an elastic joint, whose edge would crack.
//
// The bond of such blocks acts at the joint's two ends, half of it at each. With a linear stress along the joint, the
// edge would reach the tension strength earlier: in pure bending at a third of the load. A brittle bond would crack
// there, and its cohesion would act on the remaining part only. Without tension strength this part is three times as
// long as the distance of the resultant from the nearer end.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// A joint that would crack in part, so that its cohesion acts on less.
struct CrackedJoint {
  std::pair<int, int> blocks;
  std::string name;
  double cracked = 0;  ///< share of the joint
};

class EdgeTension {
 public:
  /// Evaluates the state at `time_s` under this level of the higher pool. `time_s`: NaN in a static analysis.
  void look(const Solid& solid, double time_s, double level_m);

  /// Largest bond stress so far [Pa, tension positive]; 0 if no bond is in tension.
  [[nodiscard]] double stress_pa() const { return worst_.stress_pa; }
  /// Share of that joint that a crack from the edge in tension would take.
  [[nodiscard]] double cracked() const { return worst_.cracked; }
  /// Shear strength over shear force of that joint, with cohesion on the uncracked part only.
  [[nodiscard]] double cracked_factor() const { return worst_.cracked_factor; }
  /// Joints whose edge stress exceeds their strength and whose sliding factor falls by more than 1 % with the crack.
  [[nodiscard]] static std::vector<CrackedJoint> cracked_joints(const Solid& solid);
  /// Empty if no bond exceeds its strength at the edge.
  [[nodiscard]] std::string warning() const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(worst_.stress_pa, worst_.strength_pa, worst_.excess, worst_.cracked, worst_.factor, worst_.cracked_factor,
            worst_.joint, worst_.block, time_s_, level_m_);
  }

 private:
  struct Bond {
    double stress_pa = 0;       ///< at the edge
    double strength_pa = 0;     ///< in tension
    double excess = -1;         ///< stress beyond the strength, over tension strength plus cohesion
    double cracked = 0;         ///< share of the joint
    double factor = 0;          ///< shear strength over shear force with cohesion on the whole joint; 0: none
    double cracked_factor = 0;  ///< with cohesion on the uncracked part
    std::pair<int, int> blocks;
    std::string joint;
    std::string block;  ///< block that can be meshed
  };
  [[nodiscard]] static std::vector<Bond> bonds_of(const Solid& solid);
  [[nodiscard]] static Bond judged(const Solid& solid, const std::vector<const ContactPoint*>& joint);
  [[nodiscard]] static bool loses_cohesion(const Bond& bond);

  Bond worst_;
  double time_s_ = 0;
  double level_m_ = 0;  ///< NaN without a pool
};

}  // namespace blockweir::solid
