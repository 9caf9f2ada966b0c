// SPDX-License-Identifier: GPL-3.0-or-later
// The fluid as the solid's schedule talks to it.
#pragma once

#include "bridge/schedule/fluid_line.hpp"
#include "bridge/schedule/windows.hpp"

namespace blockweir::schedule {

/// Before motion k is told, both sides can be put on disk and go on from there: the solid with load k-1, the fluid as
/// it was when it said that.
class Exchange {
 public:
  /// `fluid` is null where the scene has no water.
  /// `skips`: nothing is said where the last answer holds, no block having moved since and the water standing.
  Exchange(FluidLine* fluid, checkpoint::Checkpoints& checkpoints, Windows& windows, SolidSide& solid, bool skips);

  /// Goes on before motion `number`, as the checkpoint has it.
  void resume(std::uint64_t number);

  /// Says the next motion, of `time_s`, and has the solid record what led to it; a checkpoint, too, when one is due or
  /// the run is to be stopped. Then it throws channel::Interrupted. A fluid that fails meanwhile leaves a checkpoint:
  /// one that remembers nothing can go on there.
  void tell(wire::Motion& motion, double time_s);
  /// Waits for the pressures for what was told. In between the solid may step: if the fluid fails then, the solid is
  /// past what a checkpoint could hold.
  void hear();
  /// Both, with nothing in between. A fluid that fails in either leaves a checkpoint.
  void ask(wire::Motion& motion, double time_s);

  /// Number of the next motion.
  [[nodiscard]] std::uint64_t number() const { return number_; }
  /// What was heard last, and the motion that it answers.
  [[nodiscard]] const wire::Load& load() const { return load_; }
  [[nodiscard]] const wire::Motion& answered() const { return answered_; }

  /// Windows in which nothing was said.
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
  wire::Load incoming_;  ///< so that load_ is whole whatever comes
  wire::Motion answered_;
  wire::Motion told_;
  bool silent_ = false;  ///< nothing was said of told_
  long skipped_ = 0;
};

}  // namespace blockweir::schedule
