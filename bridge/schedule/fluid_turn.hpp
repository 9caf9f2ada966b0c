// SPDX-License-Identifier: GPL-3.0-or-later
// What a fluid does for each motion it receives: a checkpoint if requested, a step, its results.
#pragma once

#include <cstdint>

#include "bridge/checkpoint/checkpoints.hpp"
#include "bridge/schedule/sides.hpp"

namespace blockweir::schedule {

class FluidTurn {
 public:
  /// Starts at time 0, or from checkpoint `first`. Without that checkpoint, a fluid without memory simply starts there.
  FluidTurn(FluidSide& fluid, checkpoint::Checkpoints& checkpoints, std::uint64_t first);

  /// The pressures for `motion`, valid until the next call; null if the message only requests a checkpoint. Throws
  /// channel::PeerError if the motion is out of order or goes back in time.
  const wire::Load* answer(const wire::Motion& motion);
  /// Call after the answer was sent: writes results.
  void record();

  /// Report on the time so far; the caller adds the cost of communication.
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
