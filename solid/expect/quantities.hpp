// SPDX-License-Identifier: GPL-3.0-or-later
// Quantities of a finished run for [[expect]].
#pragma once

#include <algorithm>
#include <stdexcept>

#include "solid/expect/time_series.hpp"
#include "solid/watch/acceleration_fit.hpp"
#include "solid/watch/added_mass_watch.hpp"
#include "solid/watch/breach.hpp"
#include "solid/watch/edge_tension.hpp"
#include "solid/watch/energy.hpp"
#include "solid/watch/failure_watch.hpp"
#include "solid/watch/frame.hpp"
#include "solid/watch/interface_energy.hpp"
#include "solid/watch/largest_strain.hpp"
#include "solid/watch/margins.hpp"
#include "solid/watch/skips.hpp"

namespace blockweir::solid::expect {

/// The results of a run from which quantities are computed.
struct Outcome {
  const Solid& solid;
  const Frame& first;  ///< at time 0
  const Frame& last;
  const FailureWatch& failure;
  const Margins& margins;
  const EdgeTension& edge_tension;
  const LargestStrain& strain;
  const AccelerationFit& acceleration;
  const TimeSeries& series;
  const EnergyWatch& energy;
  const AddedMassWatch& added_mass;
  const InterfaceEnergy& interface_energy;
  const Frames& frames;
  double largest_penetration_m = 0;  ///< over the whole run
  std::optional<Breach> breach{};

  /// Into each other by more, blocks are somewhere else than they could be.
  [[nodiscard]] double most_penetration_m() const { return 1e-4 * solid.model().size_m; }
  /// Of closed contacts, or of blocks as a step ended [m].
  [[nodiscard]] double deepest_m() const { return std::max(largest_penetration_m, solid.counts().overlap_m); }
};

std::vector<std::string> quantity_names();

/// The run does not contain the requested quantity; what() says why, e.g. "no impact: the run ends before it".
struct NoFigure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// NaN (failure level of a dam that stands) or NoFigure if the run has no such quantity.
double quantity(const Outcome& outcome, const scene::Expectation& expectation);

}  // namespace blockweir::solid::expect
