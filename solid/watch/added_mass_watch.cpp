// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/added_mass_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "bridge/scene/at.hpp"
#include "bridge/scene/water_answers.hpp"
#include "bridge/schedule/load_fault.hpp"
#include "solid/watch/schedule_stability.hpp"

namespace blockweir::solid {
namespace {

constexpr double guarded_limit = 100;  // beyond it round-off and the estimate's error have no room left
constexpr double no_limit = std::numeric_limits<double>::infinity();
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

/// The reservoir's added mass is no estimate; with sound it is that of the window that it looks ahead.
bool is_exact(const scene::Scene& scene) {
  return scene.fluid == scene::FluidModel::reservoir;
}

Eigen::Matrix3d symmetric(const std::array<double, 6>& m) {
  const auto& [xx, xy, xr, yy, yr, rr] = m;
  return (Eigen::Matrix3d() << xx, xy, xr, xy, yy, yr, xr, yr, rr).finished();
}

/// The block of the scene whose motion it is (WaterMotions).
std::size_t block_of(const Solid& solid, std::size_t motion) {
  const std::size_t n = solid.described();
  return motion < 2 * n ? motion % n : at(solid.model().water_motions.corners()[motion - 2 * n].block);
}

/// Factors that give the unknowns of a motion one unit, and its block the mass 1.
Eigen::Vector3d scale_of(const Solid& solid, std::size_t motion) {
  const Vector6 own = solid.blocks()[block_of(solid, motion)].inertia.matrix().diagonal();
  const bool strains = motion >= solid.described() && motion < 2 * solid.described();
  const Eigen::Vector3d of_motion = strains ? own.tail<3>() : own.head<3>();
  return of_motion.cwiseSqrt().cwiseInverse();
}

/// For moving blocks. Two motions cannot displace more common water than the geometric mean of their own:
/// m_ij^2 <= m_ii m_jj, or there would be a motion without inertia.
std::vector<CoupledMass> pairs_of(const wire::Load& load, const Solid& solid, const std::vector<Eigen::Matrix3d>& own) {
  const auto block = [&](std::uint32_t motion) -> const Block& { return solid.blocks()[block_of(solid, motion)]; };
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
    if (block(a).fixed || block(b).fixed) continue;
    using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    const Eigen::Matrix3d mass = Rows::Map(load.added_mass_between[i].data());
    const Eigen::Vector3d of_a = scale_of(solid, a);
    const Eigen::Vector3d of_b = scale_of(solid, b);
    const Eigen::Matrix3d scaled = of_a.asDiagonal() * mass * of_b.asDiagonal();
    const Eigen::Matrix3d most =
        of_a.cwiseAbs2().cwiseProduct(own[a].diagonal()) * of_b.cwiseAbs2().cwiseProduct(own[b].diagonal()).transpose();
    const double unheard = solver_error * std::max(1.0, most.maxCoeff());
    if ((scaled.array().square() > (1 + solver_error) * most.array() + unheard).any()) {
      throw fault(fmt::format("the added mass between blocks \"{}\" and \"{}\" is larger than their own", block(a).name,
                              block(b).name));
    }
    pairs.push_back({static_cast<int>(a), static_cast<int>(b), mass});
  }
  return pairs;
}

/// Of the rigid motion of blocks with a mesh, what their corners push: R^T M R.
void add_corners(const AddedMasses& masses, const Solid& solid, std::vector<Eigen::Matrix3d>& of_blocks) {
  const std::size_t first = 2 * solid.described();
  const auto& corners = solid.model().water_motions.corners();
  const auto by_block = [&](std::size_t motion) {
    const auto& [block, side] = corners[motion - first];
    const Point place = solid.placements()[at(side.part)].position(solid.parts().vertex(side));
    Eigen::Matrix3d R = Eigen::Matrix3d::Zero();
    R.topLeftCorner<2, 2>().setIdentity();
    R.topRightCorner<2, 1>() = perpendicular(place - solid.placements()[at(block)].centre());
    return R;
  };
  for (std::size_t m = first; m < masses.own.size(); ++m) {
    if (masses.own[m].isZero(0)) continue;
    of_blocks[at(corners[m - first].block)] += by_block(m).transpose() * masses.own[m] * by_block(m);
  }
  for (const CoupledMass& pair : masses.pairs) {
    if (at(pair.a) < first) continue;
    const int block = corners[at(pair.a) - first].block;
    if (block != corners[at(pair.b) - first].block) continue;
    const Eigen::Matrix3d half = by_block(at(pair.a)).transpose() * pair.mass * by_block(at(pair.b));
    of_blocks[at(block)] += half + half.transpose();
  }
}

}  // namespace

AddedMasses AddedMassWatch::look(const wire::Load& load, const Solid& solid) {
  const scene::Scene& scene = solid.scene();
  if (load.added_mass.empty() || scene.analysis.kind != scene::AnalysisKind::dynamic) return {};
  const WaterMotions& motions = solid.model().water_motions;
  if (load.added_mass.size() != solid.described() && load.added_mass.size() != motions.count()) {
    throw schedule::LoadFault(
        fmt::format("states added masses of {} blocks; the scene has {}; give both sides one scene",
                    load.added_mass.size(), solid.described()));
  }
  const scene::Coupling& coupling = scene.coupling;
  if (!limit_) {
    const double guarded = is_exact(scene) ? no_limit : guarded_limit;
    limit_ = coupling.added_mass_limit   ? *coupling.added_mass_limit
             : coupling.added_mass_guard ? guarded
                                         : largest_stable_ratio(scene);
  }
  // What lands traps water for a moment. Growth is watched then (InterfaceEnergy); to refuse the run would lose it.
  const bool on_the_way = load.time_s > 0 && coupling.added_mass_guard && !coupling.added_mass_limit;
  AddedMasses masses;
  masses.blocks = solid.described();
  for (const auto& row : load.added_mass) masses.own.push_back(symmetric(row));
  masses.pairs = pairs_of(load, solid, masses.own);
  std::vector<Eigen::Matrix3d> of_blocks(masses.own.begin(),
                                         masses.own.begin() + static_cast<std::ptrdiff_t>(masses.blocks));
  add_corners(masses, solid, of_blocks);
  for (std::size_t b = 0; b < masses.blocks; ++b) {
    const Block& block = solid.blocks()[b];
    if (block.fixed) continue;
    const MassRatio ratio = mass_ratio(block, of_blocks[b]);
    require_inertia(block, ratio);
    if (ratio.largest > ratio_) {
      ratio_ = ratio.largest;
      block_ = block.name;
    }
    if (!on_the_way) require_stable(block, ratio.largest, *limit_, coupling.added_mass_guard);
  }
  return masses;
}

std::string AddedMassWatch::warning(const scene::Scene& scene) const {
  const bool guarded = scene.coupling.added_mass_guard && !scene.coupling.added_mass_limit;
  if (!guarded || is_exact(scene) || ratio_ <= guarded_limit) return {};
  return fmt::format(
      "while it moved, block \"{}\" had to push water {:.3g} times as heavy as itself; the added-mass guard is tested "
      "up to {} times; see \"interface_energy\" for the energy error of the exchange",
      block_, ratio_, guarded_limit);
}

}  // namespace blockweir::solid
