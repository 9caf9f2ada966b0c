// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/schedule/run.hpp"

#include "bridge/results/peak_memory.hpp"
#include "bridge/schedule/load_fault.hpp"
#include "bridge/schedule/schedules.hpp"

namespace blockweir::schedule {
namespace {

/// Notifies the partner of errors in `work`, including errors in the partner's own messages, but not of a partner that
/// has left.
template <class Work, class Notify>
void guarded(Work work, Notify notify) {
  try {
    work();
  } catch (const channel::PartnerFault& fault) {
    notify(fault.what());
    throw;
  } catch (const channel::PeerError&) {
    throw;
  } catch (const std::exception& error) {
    notify(error.what());
    throw;
  }
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

Exchanges run_solid(FluidLine* fluid, const scene::Scene& scene, checkpoint::Checkpoints& checkpoints,
                    std::uint64_t first, SolidSide& solid) {
  Exchanges counted;
  const auto work = [&] {
    Windows windows(scene);
    Exchange exchange(fluid, checkpoints, windows, solid, scene.coupling.skip_exchanges);
    if (first > 0) exchange.resume(first);
    try {
      function_of(scene.coupling.schedule)(exchange, windows, solid);
    } catch (const LoadFault& fault) {
      throw channel::PartnerFault((fluid != nullptr ? fluid->name() : "the fluid") + " " + fault.what());
    }
    solid.record();
    if (fluid != nullptr) fluid->end("the run is complete");
    counted = {static_cast<long>(exchange.number()), exchange.skipped()};
  };
  guarded(work, [&](const char* text) {
    if (fluid != nullptr) fluid->fail(text);
  });
  return counted;
}

FluidReport run_fluid(channel::Channel& channel, checkpoint::Checkpoints& checkpoints, std::uint64_t first,
                      FluidSide& fluid) {
  const double waited_before_s = channel.waited_s();  // for the partner to come
  FluidReport report;
  const auto work = [&] {
    FluidTurn turn(fluid, checkpoints, first);
    wire::Motion motion;
    try {
      for (;;) {
        channel.receive(motion);
        const wire::Load* load = turn.answer(motion);
        if (load == nullptr) continue;
        channel.send(*load);
        turn.record();
      }
    } catch (const channel::PeerEnded&) {
      report = turn.report();
    }
  };
  guarded(work, [&](const char* text) { channel.send(wire::Failure{text}); });
  report.seconds["wait"] = channel.waited_s() - waited_before_s;
  report.seconds["pack"] = channel.packed_s();
  report.seconds["wire"] = channel.wire_s();
  report.peak_memory_mb = results::peak_memory_mb();
  return report;
}

}  // namespace blockweir::schedule
