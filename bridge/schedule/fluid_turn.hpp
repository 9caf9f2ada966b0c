// SPDX-License-Identifier: GPL-3.0-or-later
// What a fluid does when a motion comes, whoever brings it: a checkpoint where one is asked for, a step, its results.
#pragma once

#include <cstdint>

#include "bridge/checkpoint/checkpoints.hpp"
#include "bridge/schedule/sides.hpp"

namespace blockweir::schedule {

class FluidTurn {
 public:
  /// From the start, or from checkpoint `first`; where there is none, a fluid that remembers nothing begins there anew.
  FluidTurn(FluidSide& fluid, checkpoint::Checkpoints& checkpoints, std::uint64_t first);

  /// The pressures for `motion`, good until the next call; null where it only asks for a checkpoint. Throws
  /// channel::PeerError when it is not its turn, or goes back in time.
  const wire::Load* answer(const wire::Motion& motion);
  /// The answer is on its way: the moment to write results.
  void record();

  /// Of the time so far; whoever brings the motions adds what that cost.
  [[nodiscard]] FluidReport report() const;

 private:
  FluidSide& fluid_;
  checkpoint::Checkpoints& checkpoints_;
  std::uint64_t window_;  ///< of the next motion
  wire::Load load_;
  double advance_s_ = 0;
  double output_s_ = 0;
};

}  // namespace blockweir::schedule
