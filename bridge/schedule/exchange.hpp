// SPDX-License-Identifier: GPL-3.0-or-later
// The exchange with the fluid, as the solid's schedule uses it.
#pragma once

#include "bridge/schedule/fluid_line.hpp"
#include "bridge/schedule/windows.hpp"

namespace blockweir::schedule {

/// Before motion k is sent both sides can save a consistent checkpoint: the solid with load k-1, and the fluid in the
/// state that produced this load.
class Exchange {
 public:
  /// `fluid` is null if the scene has no water. `skips`: no message is sent while the last load still holds, because no
  /// block has moved since and the water is at rest.
  Exchange(FluidLine* fluid, checkpoint::Checkpoints& checkpoints, Windows& windows, SolidSide& solid, bool skips);

  /// Continues from a checkpoint, with motion `number` as the next.
  void resume(std::uint64_t number);

  /// Sends the next motion, for `time_s`, and lets the solid record the step before. Saves a checkpoint if one is due
  /// or if a stop was requested; in the latter case throws channel::Interrupted afterwards. If the fluid fails here, a
  /// checkpoint is left, from which a fluid without memory can continue.
  void send(wire::Motion& motion, double time_s);
  /// Receives the pressures for the motion sent last. The solid may step in between; if the fluid fails then, no
  /// checkpoint is possible.
  void receive();
  /// send() and receive() without a step in between. If the fluid fails, a checkpoint is left.
  void send_and_receive(wire::Motion& motion, double time_s);

  /// Number of the next motion.
  [[nodiscard]] std::uint64_t number() const { return number_; }
  /// The load received last, and the motion that it belongs to.
  [[nodiscard]] const wire::Load& load() const { return load_; }
  [[nodiscard]] const wire::Motion& answered() const { return answered_; }

  /// Number of windows without messages.
  [[nodiscard]] long skipped() const { return skipped_; }

 private:
  void save();
  void save_without_fluid();
  [[nodiscard]] bool answer_holds(const wire::Motion& motion, double time_s) const;

  FluidLine* fluid_;
  checkpoint::Checkpoints& checkpoints_;
  Windows& windows_;
  SolidSide& solid_;
  bool skips_;
  std::uint64_t number_ = 0;
  wire::Load load_;
  wire::Load incoming_;  ///< separate, so that load_ stays complete if receiving fails
  wire::Motion answered_;
  wire::Motion sent_;
  bool silent_ = false;  ///< the last motion was not sent
  long skipped_ = 0;
};

}  // namespace blockweir::schedule
