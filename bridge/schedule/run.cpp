// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/schedule/run.hpp"

#include "bridge/checkpoint/archive.hpp"
#include "bridge/schedule/schedules.hpp"
#include "bridge/schedule/turn.hpp"

namespace blockweir::schedule {
namespace {

/// What goes wrong here is told to the partner; what the partner says is not told back.
template <class Loop>
ExchangeTime guarded(channel::Channel* channel, Loop loop) {
  try {
    loop();
  } catch (const channel::PeerError&) {
    throw;
  } catch (const std::exception& error) {
    if (channel != nullptr) channel->send(wire::Failure{error.what()});
    throw;
  }
  return channel != nullptr ? ExchangeTime{channel->waited_s(), channel->packed_s(), channel->wire_s()}
                            : ExchangeTime{};
}

auto function_of(scene::Schedule schedule) {
  switch (schedule) {
    case scene::Schedule::parallel:
      return parallel_staggered;
    case scene::Schedule::improved:
      return improved_staggered;
    case scene::Schedule::serial:
      break;
  }
  return serial_staggered;
}

}  // namespace

ExchangeTime run_solid(channel::Channel* channel, const scene::Scene& scene, checkpoint::Checkpoints& checkpoints,
                       std::uint64_t first, SolidSide& solid) {
  return guarded(channel, [&] {
    Windows windows(scene);
    Exchange exchange(channel, checkpoints, windows, solid);
    if (first > 0) exchange.resume(first);
    function_of(scene.coupling.schedule)(exchange, windows, solid);
    if (channel != nullptr) channel->send(wire::End{"the run is complete"});
  });
}

ExchangeTime run_fluid(channel::Channel& channel, checkpoint::Checkpoints& checkpoints, std::uint64_t first,
                       FluidSide& fluid) {
  return guarded(&channel, [&] {
    wire::Motion motion;
    wire::Load load;
    if (first > 0 && (fluid.remembers() || checkpoints.has(first))) {
      std::string state;
      checkpoint::unpack(checkpoints.read(first), load, state);
      fluid.restore(state);
    }
    try {
      for (std::uint64_t k = first;; ++k) {
        channel.receive(motion);
        require_turn(motion.window, k, "the solid process");
        if (motion.time_s < load.time_s) {
          throw channel::PeerError(
              fmt::format("the solid process went from {} s back to {} s in window {}", load.time_s, motion.time_s, k));
        }
        if (motion.order != wire::Order::compute) checkpoints.write(k, checkpoint::pack(load, fluid.state()));
        if (motion.order == wire::Order::save) continue;  // it will say why
        fluid.advance(motion, motion.time_s, load);
        load.window = k;
        load.time_s = motion.time_s;
        channel.send(load);
        fluid.record(load.time_s);
      }
    } catch (const channel::PeerEnded&) {
      return;
    }
  });
}

}  // namespace blockweir::schedule
