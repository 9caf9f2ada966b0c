// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/added_mass_watch.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/schedule/load_fault.hpp"
#include "solid/watch/schedule_stability.hpp"

namespace blockweir::solid {
namespace {

constexpr double guarded_limit = 100;  // beyond it round-off and the estimate's error have no room left
constexpr double solver_error = 1e-3;  // a fluid's own, by which a mode without inertia may fall below zero

void require_inertia(const Block& block, const MassRatio& ratio) {
  if (ratio.smallest >= -solver_error * std::max(1.0, ratio.largest)) return;
  throw schedule::LoadFault(
      fmt::format("states an added mass on block \"{}\" that is {:.3g} of its own in one mode; expected none below 0; "
                  "correct its added_mass",
                  block.name, ratio.smallest));
}

void require_stable(const Block& block, double ratio, double largest, bool guarded) {
  if (ratio <= largest) return;
  const std::string found =
      fmt::format("block \"{}\" has to push water {:.3g} times as heavy as itself", block.name, ratio);
  if (!guarded) {
    throw SolveError(found +
                     fmt::format("; without the added-mass guard the exchange is unstable above {:.3g}, whatever "
                                 "the step; set [coupling] added_mass_guard = true",
                                 largest));
  }
  throw SolveError(
      fmt::format("{}; the added-mass guard holds up to {}; make the block thicker or heavier, or join it with another",
                  found, largest));
}

Eigen::Matrix3d symmetric(const std::array<double, 6>& m) {
  const auto& [xx, xy, xr, yy, yr, rr] = m;
  return (Eigen::Matrix3d() << xx, xy, xr, xy, yy, yr, xr, yr, rr).finished();
}

/// What makes unknowns (u, v, r) of a block's rigid motion of one unit, and its own mass 1.
Eigen::Vector3d scale_of(const Block& block) {
  return block.inertia.matrix().diagonal().head<3>().cwiseSqrt().cwiseInverse();
}

/// For moving blocks. Two blocks cannot displace more common water than the geometric mean of their own: m_ij^2 <= m_ii
/// m_jj, or there would be a motion without inertia.
std::vector<CoupledMass> pairs_of(const wire::Load& load, const Solid& solid, const std::vector<Eigen::Matrix3d>& own) {
  const auto fault = [](const std::string& found) {
    return std::runtime_error(found + ": the fluid process is at fault");
  };
  std::vector<CoupledMass> pairs;
  for (std::size_t i = 0; i < load.coupled.size(); ++i) {
    const auto [a, b] = load.coupled[i];
    if (a >= b || b >= own.size()) {
      throw fault(fmt::format("an added mass between blocks {} and {} of {}; expected the lower number first", a, b,
                              own.size()));
    }
    if (solid.blocks()[a].fixed || solid.blocks()[b].fixed) continue;
    using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    const Eigen::Matrix3d mass = Rows::Map(load.added_mass_between[i].data());
    const Eigen::Vector3d of_a = scale_of(solid.blocks()[a]);
    const Eigen::Vector3d of_b = scale_of(solid.blocks()[b]);
    const Eigen::Matrix3d scaled = of_a.asDiagonal() * mass * of_b.asDiagonal();
    const Eigen::Matrix3d most =
        of_a.cwiseAbs2().cwiseProduct(own[a].diagonal()) * of_b.cwiseAbs2().cwiseProduct(own[b].diagonal()).transpose();
    const double unheard = solver_error * std::max(1.0, most.maxCoeff());
    if ((scaled.array().square() > (1 + solver_error) * most.array() + unheard).any()) {
      throw fault(fmt::format("the added mass between blocks \"{}\" and \"{}\" is larger than their own",
                              solid.blocks()[a].name, solid.blocks()[b].name));
    }
    pairs.push_back({static_cast<int>(a), static_cast<int>(b), mass});
  }
  return pairs;
}

}  // namespace

AddedMasses AddedMassWatch::look(const wire::Load& load, const Solid& solid) {
  const scene::Scene& scene = solid.scene();
  if (load.added_mass.empty() || scene.analysis.kind != scene::AnalysisKind::dynamic) return {};
  if (load.added_mass.size() != solid.described()) {
    throw schedule::LoadFault(
        fmt::format("states added masses of {} blocks; the scene has {}; give both sides one scene",
                    load.added_mass.size(), solid.described()));
  }
  const scene::Coupling& coupling = scene.coupling;
  if (!limit_) {
    limit_ = coupling.added_mass_limit   ? *coupling.added_mass_limit
             : coupling.added_mass_guard ? guarded_limit
                                         : largest_stable_ratio(scene);
  }
  // What lands traps water for a moment. Growth is watched then (InterfaceEnergy); to refuse the run would lose it.
  const bool on_the_way = load.time_s > 0 && coupling.added_mass_guard && !coupling.added_mass_limit;
  AddedMasses masses;
  for (std::size_t b = 0; b < load.added_mass.size(); ++b) {
    masses.own.push_back(symmetric(load.added_mass[b]));
    const Block& block = solid.blocks()[b];
    if (block.fixed) continue;
    const MassRatio ratio = mass_ratio(block, masses.own.back());
    require_inertia(block, ratio);
    if (ratio.largest > ratio_) {
      ratio_ = ratio.largest;
      block_ = block.name;
    }
    if (!on_the_way) require_stable(block, ratio.largest, *limit_, coupling.added_mass_guard);
  }
  masses.pairs = pairs_of(load, solid, masses.own);
  return masses;
}

std::string AddedMassWatch::warning(const scene::Coupling& coupling) const {
  if (!coupling.added_mass_guard || coupling.added_mass_limit || ratio_ <= guarded_limit) return {};
  return fmt::format(
      "while it moved, block \"{}\" had to push water {:.3g} times as heavy as itself; the added-mass guard is tested "
      "up to {} times; see \"interface_energy\" for the energy error of the exchange",
      block_, ratio_, guarded_limit);
}

}  // namespace blockweir::solid
