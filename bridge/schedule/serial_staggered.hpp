// SPDX-License-Identifier: GPL-3.0-or-later
// Conventional serial staggered schedule: the fluid holds p_n, the solid steps to t_n+1 under it and says where the
// blocks are, the fluid steps to t_n+1 and says p_n+1. Window 0 is the start: positions, then first pressures.
#pragma once

#include "bridge/channel/channel.hpp"
#include "bridge/scene/scene.hpp"
#include "bridge/schedule/windows.hpp"

namespace blockweir::schedule {

/// A static analysis has no time: all its windows end at the run's end, and the sides take turns until the solid has
/// come to rest.
Windows windows(const scene::Scene& scene);

/// The solid as the schedule sees it. It may take as many steps in a window as it needs.
class SolidSide {
 public:
  virtual ~SolidSide() = default;
  /// The state at time 0, before any water is known.
  virtual void place(wire::Motion& motion) = 0;
  /// First pressures are there: settle, and record time 0.
  virtual void start(const wire::Load& load) = 0;
  /// Steps from from_s to to_s under `load`, which is held.
  virtual void advance(const wire::Load& load, double from_s, double to_s, wire::Motion& motion) = 0;
  /// True when nothing is left to learn from the rest of the run.
  [[nodiscard]] virtual bool finished() const = 0;
};

class FluidSide {
 public:
  virtual ~FluidSide() = default;
  /// Pressures at to_s for blocks that are where `motion` says.
  virtual void advance(const wire::Motion& motion, double to_s, wire::Load& load) = 0;
  /// The load of time_s is on its way and the solid steps: the moment to write results.
  virtual void record(double /*time_s*/) {}
};

/// Seconds that the exchange cost this side.
struct ExchangeTime {
  double wait_s = 0;  ///< for the partner
  double pack_s = 0;  ///< into bytes and back
};

/// Run one side to the end; on an exception of its own the partner is told before it goes on.
ExchangeTime run_solid(channel::Channel& channel, const Windows& windows, SolidSide& solid);
ExchangeTime run_fluid(channel::Channel& channel, const Windows& windows, FluidSide& fluid);

/// The same windows for a scene without water.
void run_dry(const Windows& windows, SolidSide& solid);

}  // namespace blockweir::schedule
