// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/interface_energy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace blockweir::solid {
namespace {

constexpr double gain = 3;           // times the energy before: a fourfold one
constexpr double least_share = 0.5;  // of the water's work
constexpr int in_a_row = 5;          // 3^5 times the energy at first
constexpr std::uint64_t patience = 40;

/// Kinetic energy of blocks at rest, and what would lift them by a hundredth of a failure: on springs, and where blocks
/// strain, what stands takes up energy and gives it back without moving farther.
double resting_energy(const Solid& solid) {
  constexpr double unnoticed = 1e-2;
  double mass = 0;
  for (std::size_t b = 0; b < solid.described(); ++b) {
    if (!solid.blocks()[b].fixed) mass += solid.blocks()[b].mass_per_m();
  }
  const scene::Analysis& analysis = solid.scene().analysis;
  return mass * (std::pow(analysis.rest_speed_m_per_s, 2) / 2 +
                 unnoticed * analysis.gravity_m_per_s2 * analysis.failure_displacement_m);
}

}  // namespace

InterfaceEnergy::InterfaceEnergy(const Solid& solid) : solid_(solid), least_(resting_energy(solid)), scale_(least_) {}

void InterfaceEnergy::begin() {
  sent_.clear();
  for (std::size_t b = 0; b < solid_.described(); ++b) {
    sent_.emplace_back(solid_.states()[b].displacement.head<3>());
  }
}

void InterfaceEnergy::look(const std::vector<Panel>& panels, const wire::Motion& sent, const Window& window,
                           double kinetic_j_per_m) {
  const std::size_t n = solid_.described();
  std::vector<Placement> placements;
  std::vector<Eigen::Vector3d> ways;
  for (std::size_t b = 0; b < n; ++b) {
    const Vector6 d = Vector6::Map(sent.displacement[b].data());
    placements.emplace_back(solid_.blocks()[b].centroid, d);
    ways.emplace_back(d.head<3>());
  }
  auto forces = water_forces(panels, solid_.blocks(), placements, n, solid_.scene().water.nodal_rule);
  const double before = solid_work_;
  solid_work_ = solid_.state().water_work.sum_j_per_m();
  if (windows_++ == 0) {
    ways = sent_;  // the first motion was sent before the blocks settled
  } else {
    for (std::size_t b = 0; b < n; ++b) now_.given += (forces[b] + forces_[b]).dot(ways[b] - sent_[b]) / 2;
  }
  forces_.swap(forces);
  sent_.swap(ways);
  const double part = std::clamp((sent.time_s - window.from_s) / (window.to_s - window.from_s), 0.0, 1.0);
  now_.window = windows_ - 1;
  now_.time_s = window.from_s;
  now_.made = before + part * (solid_work_ - before) - now_.given;
  judge(kinetic_j_per_m);
}

void InterfaceEnergy::judge(double kinetic) {
  most_kinetic_ = std::max(most_kinetic_, kinetic);
  if (growth_) return;
  const double made = now_.made - mark_.made;
  const double given = std::abs(now_.given - mark_.given);
  const bool again = made > gain * scale_ && made > least_share * given;
  largest_kinetic_ = std::max(largest_kinetic_, kinetic);
  if (!again && now_.window - mark_.window < patience) return;
  if (again && times_ == 0) suspect_ = mark_;
  times_ = again ? times_ + 1 : 0;
  if (times_ == in_a_row) growth_ = {suspect_.window, suspect_.time_s};
  mark_ = now_;
  scale_ = std::max({least_, largest_kinetic_, again ? made : 0});
  largest_kinetic_ = 0;
}

std::string InterfaceEnergy::warning() const {
  // Friction may take far more than motion ever holds: a dam that slid in an earthquake by what it should to 0.2 % had
  // got 1.2 % of the water's work by the exchange, a quarter of its largest kinetic energy.
  constexpr double small_beside_motion = 0.25;
  constexpr double small_beside_work = 0.05;
  const double moved_with = std::max(most_kinetic_, least_);
  if (growth_ || now_.made <= small_beside_motion * moved_with) return {};
  if (now_.made <= small_beside_work * std::abs(now_.given)) return {};
  return fmt::format(
      "the exchange between blocks and water added {:.3g} J per metre, {:.3g} times the largest kinetic energy: "
      "pressures that lag behind the blocks push those that swing in the water, such as floating ones, ever farther; "
      "take [coupling] schedule = \"improved\" or load_in_window = \"linear\", or shorten step_s",
      now_.made, now_.made / moved_with);
}

std::string InterfaceEnergy::trouble(double ratio) const {
  const scene::Coupling& coupling = solid_.scene().coupling;
  if (!growth_) return {};
  const std::string found = fmt::format(
      "the exchange between blocks and water adds energy from window {} on ({:.6g} s): {:.3g} J per metre at {:.6g} s, "
      "while the water did a work of {:.3g}; ",
      growth_->window, growth_->time_s, now_.made - suspect_.made, now_.time_s, now_.given - suspect_.given);
  if (!coupling.added_mass_guard) {
    return found + fmt::format(
                       "a block has to push water {} as heavy as itself, without the added-mass guard; set [coupling] "
                       "added_mass_guard = true",
                       ratio > 0 ? fmt::format("{:.3g} times", ratio) : "perhaps");
  }
  return found + fmt::format(
                     "the schedule is unstable in spite of the added-mass guard{}; shorten [coupling] window_s (now "
                     "{:.3g}), or take schedule = \"serial\" with load_in_window = \"held\"",
                     ratio > 0 ? fmt::format(", for water {:.3g} times as heavy as a block", ratio)
                               : ", for which the fluid states no added mass",
                     coupling.window_s);
}

}  // namespace blockweir::solid
