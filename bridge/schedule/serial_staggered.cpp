// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/schedule/serial_staggered.hpp"

#include <fmt/format.h>

#include <limits>

namespace blockweir::schedule {
namespace {

/// Runs one side's loop. What goes wrong here is told to the partner; what the partner says is not told back.
template <class Loop>
ExchangeTime guarded(channel::Channel& channel, Loop loop) {
  try {
    loop();
  } catch (const channel::PeerError&) {
    throw;
  } catch (const channel::PeerEnded&) {
    throw;
  } catch (const std::exception& error) {
    channel.send(wire::Failure{error.what()});
    throw;
  }
  return {channel.waited_s(), channel.packed_s()};
}

template <class Message>
void require_window(const Message& message, std::uint64_t window, const char* sender) {
  if (message.window == window) return;
  throw channel::PeerError(fmt::format("{} sent window {} where window {} was due", sender, message.window, window));
}

}  // namespace

Windows windows(const scene::Scene& scene) {
  return Windows(scene.coupling.window_s, scene.analysis.duration_s,
                 scene.analysis.kind == scene::AnalysisKind::at_rest);
}

ExchangeTime run_solid(channel::Channel& channel, const Windows& windows, SolidSide& solid) {
  return guarded(channel, [&] {
    wire::Motion motion;
    wire::Load load;
    const auto exchange = [&](std::uint64_t window) {
      motion.window = window;
      motion.time_s = windows.end_s(window);
      channel.send(motion);
      channel.receive(load);
      require_window(load, window, "the fluid process");
    };
    solid.place(motion);
    exchange(0);
    solid.start(load);
    for (std::uint64_t n = 1; n <= windows.count() && !solid.finished(); ++n) {
      if (channel::stop_requested()) throw channel::Interrupted("asked to stop");
      solid.advance(load, windows.end_s(n - 1), windows.end_s(n), motion);
      if (n < windows.count()) exchange(n);
    }
    channel.send(wire::End{"the run is complete"});
  });
}

ExchangeTime run_fluid(channel::Channel& channel, const Windows& windows, FluidSide& fluid) {
  return guarded(channel, [&] {
    wire::Motion motion;
    wire::Load load;
    try {
      for (std::uint64_t n = 0;; ++n) {
        channel.receive(motion);
        require_window(motion, n, "the solid process");
        fluid.advance(motion, windows.end_s(n), load);
        load.window = n;
        load.time_s = windows.end_s(n);
        channel.send(load);
        fluid.record(load.time_s);
      }
    } catch (const channel::PeerEnded&) {
      return;
    }
  });
}

void run_dry(const Windows& windows, SolidSide& solid) {
  wire::Motion motion;
  wire::Load none;
  none.upstream_level_m = none.downstream_level_m = std::numeric_limits<double>::quiet_NaN();
  solid.place(motion);
  solid.start(none);
  for (std::uint64_t n = 1; n <= windows.count() && !solid.finished(); ++n) {
    if (channel::stop_requested()) throw channel::Interrupted("asked to stop");
    solid.advance(none, windows.end_s(n - 1), windows.end_s(n), motion);
  }
}

}  // namespace blockweir::schedule
