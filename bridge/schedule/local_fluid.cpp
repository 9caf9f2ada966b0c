// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "bridge/results/stopwatch.hpp"
#include "bridge/schedule/fluid_line.hpp"

namespace blockweir::schedule {

/// A fluid that fails is a partner that fails, wherever it is.
void LocalFluid::send(const wire::Motion& motion) {
  const Stopwatch watch(seconds_);
  try {
    answer_ = fluid_.answer(motion);
    if (answer_ != nullptr) fluid_.record();
  } catch (const std::exception& error) {
    throw channel::PeerError(fmt::format("{} stopped in window {}: {}", name(), motion.window, error.what()));
  }
}

void LocalFluid::receive(wire::Load& load) {
  load = *answer_;
}

}  // namespace blockweir::schedule
