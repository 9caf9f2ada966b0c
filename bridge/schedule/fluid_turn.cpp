// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/schedule/fluid_turn.hpp"

#include "bridge/checkpoint/archive.hpp"
#include "bridge/results/stopwatch.hpp"
#include "bridge/schedule/turn.hpp"

namespace blockweir::schedule {

FluidTurn::FluidTurn(FluidSide& fluid, checkpoint::Checkpoints& checkpoints, std::uint64_t first)
    : fluid_(fluid), checkpoints_(checkpoints), window_(first) {
  if (first == 0 || !(fluid.remembers() || checkpoints.has(first))) return;
  std::string state;
  checkpoint::unpack(checkpoints.read(first), load_, state);
  fluid.restore(state);
}

const wire::Load* FluidTurn::answer(const wire::Motion& motion) {
  require_turn(motion.window, window_, "the solid process");
  if (motion.time_s < load_.time_s) {
    throw channel::PartnerFault(
        fmt::format("the solid process went from {} s back to {} s in window {}; expected times that do not "
                    "decrease; start both sides anew",
                    load_.time_s, motion.time_s, window_));
  }
  if (motion.order != wire::Order::compute) checkpoints_.write(window_, checkpoint::pack(load_, fluid_.state()));
  ++window_;
  if (motion.order == wire::Order::save) return nullptr;  // the solid will say why
  const Stopwatch watch(advance_s_);
  fluid_.advance(motion, motion.time_s, load_);
  load_.window = motion.window;
  load_.time_s = motion.time_s;
  return &load_;
}

void FluidTurn::record() {
  const Stopwatch watch(output_s_);
  fluid_.record(load_.time_s);
}

FluidReport FluidTurn::report() const {
  FluidReport report = fluid_.report();
  report.seconds["step"] = advance_s_ - report.seconds["mapping"];
  report.seconds["output"] = output_s_;
  return report;
}

}  // namespace blockweir::schedule
