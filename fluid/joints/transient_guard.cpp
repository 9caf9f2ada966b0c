// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/transient_guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/at.hpp"

namespace blockweir::joints {
namespace {

/// One over the mass of a block [m/kg]; 0 where it is held.
double ease(const scene::Scene& scene, int block) {
  const scene::Block& b = scene.blocks[at(block)];
  if (b.fixed) return 0;
  return 1 / (scene.materials[at(b.material)].density_kg_per_m3 * std::abs(geometry::signed_area(b.vertices)));
}

}  // namespace

std::vector<double> TransientGuard::yields(const scene::Scene& scene, const JointNetwork& joints,
                                           const std::vector<double>& as_moved_m2, const std::vector<double>& stored_m2,
                                           double step_s) {
  const Network& network = joints.network();
  constexpr double tiny = 1e-9;
  std::vector<double> yields(network.nodes.size(), 0.0);
  for (std::size_t c = 0; c < joints.parts().size(); ++c) {
    const Stretch& s = joints.stretches()[joints.parts()[c].stretch];
    const Channel& channel = network.channels[c];
    const bool apart = std::max(s.gap_m[0], s.gap_m[1]) > 1e-3 * s.law->hydraulic_aperture_m;
    const double moves = ease(scene, s.sides[0].block) + ease(scene, s.sides[1].block);
    constexpr double safety = 2;
    const double volume = safety * channel.length_m / 2 * s.length_m() * step_s * step_s * moves;
    for (const int node : {channel.from, channel.to}) {
      const bool moved = std::abs(as_moved_m2[at(node)] - stored_m2[at(node)]) > tiny * stored_m2[at(node)];
      if ((apart || moved) && network.nodes[at(node)].kind != NodeKind::held) yields[at(node)] += volume;
    }
  }
  return yields;
}

void TransientGuard::add(const FlowStep& step, const std::vector<double>& yields, double passed_m2, double step_s) {
  for (std::size_t i = 0; i < yields.size(); ++i) {
    held_back_m2_ += yields[i] * std::abs(step.after.pressure_pa[i] - step.before.pressure_pa[i]);
    exchanged_m2_ += std::abs(step.stored_m2[i] - step.stored_before_m2[i]);
  }
  exchanged_m2_ += passed_m2;
  longest_step_s_ = std::max(longest_step_s_, step_s);
}

/// The share falls at least with the window.
std::string TransientGuard::warning() const {
  constexpr double little = 0.1;
  if (held_back_m2_ <= little * exchanged_m2_) return "";
  const double share = held_back_m2_ / exchanged_m2_;
  return fmt::format(
      "transient flow: what keeps its exchange with the blocks stable took in {:.2g} % as much water as the joints "
      "did, "
      "at windows of {:.3g} s; expected at most {:.2g} %; set window_s of [coupling] to {:.1g} s or less",
      100 * share, longest_step_s_, 100 * little, longest_step_s_ * little / share);
}

}  // namespace blockweir::joints
