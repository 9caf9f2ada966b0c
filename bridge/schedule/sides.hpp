// SPDX-License-Identifier: GPL-3.0-or-later
// Solid and fluid as the schedules see them. Whatever the schedule, the fluid's part is the same: it is told where the
// blocks are, or will be, at a time, steps to that time, and says the pressures there.
#pragma once

#include <string>

#include "bridge/schedule/fluid_report.hpp"
#include "bridge/wire/message.hpp"

namespace blockweir::schedule {

/// What a checkpoint holds of a side, in its own form.
class Resumable {
 public:
  virtual ~Resumable() = default;
  [[nodiscard]] virtual std::string state() const { return {}; }
  virtual void restore(const std::string& /*state*/) {}
};

/// The solid may take as many steps in a window as it needs.
class SolidSide : public Resumable {
 public:
  /// Where the blocks are now.
  virtual void place(wire::Motion& motion) = 0;
  /// Where they would be `ahead_s` later with the velocities and accelerations of now.
  virtual void predict(double ahead_s, wire::Motion& motion) = 0;
  /// First pressures are there: settle, and record time 0.
  virtual void start(const wire::Load& load) = 0;
  /// Steps from from_s to to_s under `load`, which answers the motion `told`.
  virtual void advance(const wire::Load& load, const wire::Motion& told, double from_s, double to_s) = 0;
  /// After each advance(), before the next: write the results, when the next motion is on its way and the fluid steps.
  virtual void record() {}
  /// Nothing has moved in the window just made.
  [[nodiscard]] virtual bool calm() const { return false; }
  /// Nothing is left to learn from the rest of the run.
  [[nodiscard]] virtual bool finished() const = 0;
};

class FluidSide : public Resumable {
 public:
  /// Pressures at to_s for blocks that are where `motion` says. `load` is the one before, to be changed into it.
  virtual void advance(const wire::Motion& motion, double to_s, wire::Load& load) = 0;
  /// Its pressures depend on what has been before; a run of one that does not can be resumed without its checkpoint.
  [[nodiscard]] virtual bool remembers() const { return true; }
  /// The load of time_s is on its way and the solid steps: the moment to write results.
  virtual void record(double /*time_s*/) {}
  /// Beside what the schedule times: "mapping", the part of advance() that follows the blocks, and counts.
  [[nodiscard]] virtual FluidReport report() const { return {}; }
};

}  // namespace blockweir::schedule
