// SPDX-License-Identifier: GPL-3.0-or-later
// Where the bond of blocks without a mesh bears more than an elastic joint would, whose edge cracks.
//
// Their bond acts at the joint's two ends, half of it at each. A stress that is linear along the joint reaches the
// tension strength at the edge before, in bending alone at a third of the load: a brittle bond would crack there, and
// its cohesion would hold on the part that is left alone. With no tension strength that is three times the way of the
// resultant from the nearer end.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// A joint part of which would crack, so that its cohesion holds on less.
struct CrackedJoint {
  std::pair<int, int> blocks;
  std::string name;
  double cracked = 0;  ///< share of the joint
};

class EdgeTension {
 public:
  /// Looks at the state at `time_s`, reached under this level of the higher pool. `time_s`: NaN where no time passes.
  void look(const Solid& solid, double time_s, double level_m);

  /// Where the bond bore most so far [Pa, tension positive]; 0 where no bond is in tension.
  [[nodiscard]] double stress_pa() const { return worst_.stress_pa; }
  /// Of that joint, what a crack from the tense end would take, over its length.
  [[nodiscard]] double cracked() const { return worst_.cracked; }
  /// Shear strength over shear force of that joint with cohesion on what is not cracked alone.
  [[nodiscard]] double cracked_factor() const { return worst_.cracked_factor; }
  /// Those that bear more than their strength at an edge, and lose cohesion by more than 1 % of their sliding factor.
  [[nodiscard]] static std::vector<CrackedJoint> cracked_joints(const Solid& solid);
  /// Empty where no bond bears more than its strength at its edge.
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
    double excess = -1;         ///< of the stress beyond the strength, over what tension and cohesion are together
    double cracked = 0;         ///< share of the joint
    double factor = 0;          ///< shear strength over shear force with cohesion on all of the joint; 0: none
    double cracked_factor = 0;  ///< with cohesion on what is not cracked
    std::pair<int, int> blocks;
    std::string joint;
    std::string block;  ///< that can have a mesh
  };
  [[nodiscard]] static std::vector<Bond> bonds_of(const Solid& solid);
  [[nodiscard]] static Bond judged(const Solid& solid, const std::vector<const ContactPoint*>& joint);
  [[nodiscard]] static bool loses_cohesion(const Bond& bond);

  Bond worst_;
  double time_s_ = 0;
  double level_m_ = 0;  ///< NaN without a pool
};

}  // namespace blockweir::solid
