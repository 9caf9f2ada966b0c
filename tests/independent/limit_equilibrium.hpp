// SPDX-License-Identifier: GPL-3.0-or-later
// Limit equilibrium of what stands on one plane joint, by hand: a rigid trapezoid or a stack of lifts that move as one.
//
//   H = rho g (h^2 - o^2)/2, at the height above the heel where its moment is H's (o: what stands above the crest),
//   N = V cos a - H' sin a - U,  S = V sin a + H' cos a,  slides where S = N tan(phi) + c L,
//   heel reaction R = M_toe/L, overturns where R = -T L/2 (ends of the joint bear half of its tension strength each).
#pragma once

#include <string>
#include <vector>

#include "tests/independent/structure.hpp"

namespace blockweir::independent {

/// All above one joint. Faces are straight from the joint's ends to the crest; the reservoir stands on the left.
struct Stack {
  std::string joint;
  Vec heel_m;
  Vec toe_m;
  Vec face_top_m;  ///< upstream end of the crest
  Vec back_top_m;  ///< downstream end of the crest
  double weight_n_per_m = 0;
  Vec centroid_m;
  Law law;
  std::vector<Bolt> bolts;  ///< that cross the joint, at their yield
  double tail_level_m = none_m;
};

/// A crest and what lies between it and a joint, as a trapezoid.
Stack stack_of(const std::string& joint, const Vec& heel, const Vec& toe, const Vec& face_top, const Vec& back_top,
               const Law& law, double density_kg_per_m3, double tail_level_m);

struct Failing {
  double level_m = 0;
  std::string mode;  ///< "sliding" or "overturning"
  std::string joint;
  double head_m = 0;        ///< of the level above the joint's heel
  double next_level_m = 0;  ///< at which the next way to fail begins
  /// At which the other way begins on the same joint, once the first has broken its bond: a slip breaks it all, a heel
  /// that opens that of its end.
  double broken_level_m = std::numeric_limits<double>::infinity();
};

/// (c L + N tan(phi))/S of all above a joint.
double sliding_factor(const Stack& stack, double level_m);

/// The level, up to `high_m`, at which all above a joint turns over its toe.
double overturning_level(const Stack& stack, double high_m);

/// The lowest level, up to `high_m`, at which one of the stacks fails on its joint.
Failing first_failure(const std::vector<Stack>& stacks, double high_m);

}  // namespace blockweir::independent
