// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the explicit exchange of pressures and apertures stable in transient flow: in a window of dt, pressure p on the
// length L of a joint moves a mass m by p L dt^2/m, which the solid cannot have told yet. Without it a film of water
// that hardly gives throws such a block to and fro. As pressures settle it is of no account.
#pragma once

#include <string>
#include <vector>

#include "fluid/joints/joint_network.hpp"

namespace blockweir::joints {

/// What a step has changed.
struct FlowStep {
  const Filling& before;
  const Filling& after;
  const std::vector<double>& stored_before_m2;
  const std::vector<double>& stored_m2;
};

class TransientGuard {
 public:
  /// By node, the volume more that it takes in as its pressure rises [m2/Pa]: where faces have moved, so that the water
  /// stored would be `as_moved_m2` in place of `stored_m2`, or stand apart. Faces that bear on each other as before do
  /// not yield.
  [[nodiscard]] static std::vector<double> yields(const scene::Scene& scene, const JointNetwork& joints,
                                                  const std::vector<double>& as_moved_m2,
                                                  const std::vector<double>& stored_m2, double step_s);
  /// Weighs what that took in against what the joints really took in, lost or let through (`passed_m2`).
  void add(const FlowStep& step, const std::vector<double>& yields, double passed_m2, double step_s);
  /// Where it was of account: the window that would make it small. Empty: nowhere.
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
