// SPDX-License-Identifier: GPL-3.0-or-later
// Stabilizes the explicit exchange of pressures and apertures in transient flow. In a window dt, pressure p on the
// length L of a joint moves a mass m by p L dt^2/m, a motion that the solid cannot have sent yet. Without the guard, a
// nearly incompressible film of water throws such a block to and fro. In steady pressures the guard has no effect.
#pragma once

#include <string>
#include <vector>

#include "fluid/joints/joint_network.hpp"

namespace blockweir::joints {

/// Changes in a step.
struct FlowStep {
  const Filling& before;
  const Filling& after;
  const std::vector<double>& stored_before_m2;
  const std::vector<double>& stored_m2;
};

class TransientGuard {
 public:
  /// Additional storage of each node as its pressure rises [m2/Pa]. It applies where faces have moved, so that the
  /// storage would be `as_moved_m2` in place of `stored_m2`, or where they are apart. Faces in contact as before do not
  /// yield.
  [[nodiscard]] static std::vector<double> yields(const scene::Scene& scene, const JointNetwork& joints,
                                                  const std::vector<double>& as_moved_m2,
                                                  const std::vector<double>& stored_m2, double step_s);
  /// Compares this additional storage with what the joints really stored, lost or conducted (`passed_m2`).
  void add(const FlowStep& step, const std::vector<double>& yields, double passed_m2, double step_s);
  /// Where it was significant: the window that would make it small. Empty: nowhere.
  [[nodiscard]] std::string warning() const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(held_back_m2_, exchanged_m2_, longest_step_s_);
  }

 private:
  double held_back_m2_ = 0;
  double exchanged_m2_ = 0;
  double longest_step_s_ = 0;
};

}  // namespace blockweir::joints
