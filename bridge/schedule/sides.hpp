// SPDX-License-Identifier: GPL-3.0-or-later
// Solid and fluid as the schedules use them. In every schedule the fluid receives the blocks' present or predicted
// positions at a time, steps to that time, and returns the pressures there.
#pragma once

#include <string>

#include "bridge/schedule/fluid_report.hpp"
#include "bridge/wire/message.hpp"

namespace blockweir::schedule {

/// The state that a side saves in a checkpoint, in a format of its own.
class Resumable {
 public:
  virtual ~Resumable() = default;
  [[nodiscard]] virtual std::string state() const { return {}; }
  virtual void restore(const std::string& /*state*/) {}
};

/// The solid side. It may make several steps in a window.
class SolidSide : public Resumable {
 public:
  /// Fills in the present positions of the blocks.
  virtual void place(wire::Motion& motion) = 0;
  /// Fills in predicted positions after `ahead_s`, from the present velocities and accelerations.
  virtual void predict(double ahead_s, wire::Motion& motion) = 0;
  /// Settles under the first pressures and records time 0.
  virtual void start(const wire::Load& load) = 0;
  /// Steps from from_s to to_s under `load`, the answer to the motion `sent`.
  virtual void advance(const wire::Load& load, const wire::Motion& sent, double from_s, double to_s) = 0;
  /// Writes results. Called after each advance(), when the next motion has been sent and the fluid is stepping.
  virtual void record() {}
  /// Does what the next advance() needs no pressures for. Called where the solid would wait for them.
  virtual void prepare() {}
  /// Whether nothing moved in the last window.
  [[nodiscard]] virtual bool at_rest() const { return false; }
  /// Whether the rest of the run can bring nothing new.
  [[nodiscard]] virtual bool finished() const = 0;
};

class FluidSide : public Resumable {
 public:
  /// Replaces the previous `load` by the pressures at to_s for the positions in `motion`.
  virtual void advance(const wire::Motion& motion, double to_s, wire::Load& load) = 0;
  /// Whether the pressures depend on the past. A fluid without memory can be resumed without its checkpoint.
  [[nodiscard]] virtual bool remembers() const { return true; }
  /// Writes results. Called when the load of time_s has been sent and the solid is stepping.
  virtual void record(double /*time_s*/) {}
  /// Counts, and times that the schedule does not measure: "mapping", the part of advance() that follows the blocks.
  [[nodiscard]] virtual FluidReport report() const { return {}; }
};

}  // namespace blockweir::schedule
