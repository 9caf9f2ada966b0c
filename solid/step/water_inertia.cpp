// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/water_inertia.hpp"

#include <algorithm>

#include "bridge/scene/at.hpp"
#include "solid/block/corners.hpp"
#include "solid/solve/symmetric_modes.hpp"
#include "solid/step/island_equations.hpp"

namespace blockweir::solid {

void WaterInertia::begin_window(const Answered& answered) {
  const bool guards = model_.scene.coupling.added_mass_guard && model_.is(scene::AnalysisKind::dynamic);
  if (!state_.guard.acts() && (answered.masses.empty() || !guards)) return;
  state_.guard.begin_window(guards ? answered.masses : AddedMasses{}, answered.velocities, answered.time_s);
  motions_.clear();
  trial_.dt = -1;
}

void WaterInertia::begin_step(double dt) {
  motions_.clear();
  std::vector<bool> shares(state_.guard.motions());
  for (const CoupledMass& pair : state_.guard.masses().pairs) shares[at(pair.a)] = shares[at(pair.b)] = true;
  for (std::size_t m = 0; m < state_.guard.motions(); ++m) {
    const bool of_block = m < state_.guard.blocks();
    if (of_block && model_.blocks[m].fixed) continue;
    const bool of_mesh = of_block && model_.blocks[m].meshed;
    if (of_block && !of_mesh) trial_.external[m].head<3>() += state_.guard.force(m);
    const bool apart = !of_block || of_mesh;  // in no matrix of a block
    if (!shares[m] && (!apart || state_.guard.mass(m).isZero(0))) continue;
    motions_.push_back(of_mesh ? mean_of_mesh(m) : Motion{m, {model_.water_motions.share(m)}});
    if (apart) push(motions_.back());
  }
  if (motions_.empty()) return;
  find_masses();
  const Eigen::VectorXd velocity = velocities_now();
  const Eigen::VectorXd acceleration = gather([this](std::size_t part) { return state_.blocks[part].acceleration; });
  history_.resize(velocity.size());
  for (Eigen::Index i = 0; i < velocity.size(); i += 3) {
    BlockState rates;
    rates.velocity.head<3>() = velocity.segment<3>(i);
    rates.acceleration.head<3>() = acceleration.segment<3>(i);
    history_.segment<3>(i) = trial_.scheme.history(Matrix6(Matrix6::Identity()), rates, dt).head<3>();
  }
  history_ = masses_ * history_;
}

/// P as follow_triangles() has it, at the start of the step: mean velocity of the triangles, and the turn in their mean
/// rate of deformation.
WaterInertia::Motion WaterInertia::mean_of_mesh(std::size_t b) const {
  Motion motion{b, {}};
  const double stretch = 2 + state_.placements[b].strain()[0] + state_.placements[b].strain()[1];
  for (const int t : model_.parts.triangles[b]) {
    const Block& triangle = model_.blocks[at(t)];
    const auto& X = triangle.vertices;
    const double share = triangle.area / model_.blocks[b].area;
    auto& P = motion.shares.emplace_back(MotionShare{t, {}}).by_rates;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point gradient = perpendicular(X[(i + 2) % 3] - X[(i + 1) % 3]) / (2 * triangle.area);
      const auto column = static_cast<Eigen::Index>(2 * i);
      P.block<2, 2>(0, column) = share / 3 * Eigen::Matrix2d::Identity();
      P.block<1, 2>(2, column) = share / stretch * state_.placements[b].turn(perpendicular(gradient)).transpose();
    }
  }
  return motion;
}

void WaterInertia::push(const Motion& motion) {
  for (const auto& [part, by_rates] : motion.shares) {
    const Vector6 force = by_rates.transpose() * state_.guard.force(motion.number);
    const Block& block = model_.blocks[at(part)];
    trial_.external[at(part)] +=
        block.is_part() ? Vector6(corner_shape(block, state_.placements[at(part)]).transpose() * force) : force;
  }
}

void WaterInertia::find_masses() {
  const auto count = static_cast<Eigen::Index>(3 * motions_.size());
  masses_.setZero(count, count);
  std::vector<Eigen::Index> place(state_.guard.motions(), -1);
  for (std::size_t m = 0; m < motions_.size(); ++m) {
    const auto first = static_cast<Eigen::Index>(3 * m);
    const std::size_t number = motions_[m].number;
    place[number] = first;
    const bool in_own_matrix = number < state_.guard.blocks() && !model_.blocks[number].meshed;
    if (!in_own_matrix) masses_.block<3, 3>(first, first) = state_.guard.mass(number);
  }
  for (const CoupledMass& pair : state_.guard.masses().pairs) {
    const Eigen::Index a = place[at(pair.a)];
    const Eigen::Index b = place[at(pair.b)];
    if (a < 0 || b < 0) continue;
    masses_.block<3, 3>(a, b) = pair.mass;
    masses_.block<3, 3>(b, a) = pair.mass.transpose();
  }
}

bool WaterInertia::of_meshes() const {
  return std::any_of(motions_.begin(), motions_.end(),
                     [this](const Motion& m) { return model_.blocks[at(m.shares.front().part)].is_part(); });
}

WaterInertia::Numbers WaterInertia::motions_of(const IslandEquations& s) const {
  Numbers here;
  for (std::size_t m = 0; m < motions_.size(); ++m) {
    if (s.has(motions_[m].shares.front().part)) here.push_back(static_cast<Eigen::Index>(m));
  }
  return here;
}

template <class OfPart>
Eigen::VectorXd WaterInertia::gather(const OfPart& of_part) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(3 * motions_.size()));
  for (std::size_t m = 0; m < motions_.size(); ++m) {
    auto own = all.segment<3>(static_cast<Eigen::Index>(3 * m));
    for (const auto& [part, by_rates] : motions_[m].shares) own += by_rates * of_part(at(part));
  }
  return all;
}

Eigen::VectorXd WaterInertia::velocities_before() const {
  return gather([this](std::size_t part) { return trial_.began_with[part]; });
}

Eigen::VectorXd WaterInertia::velocities_now() const {
  return gather([this](std::size_t part) { return state_.blocks[part].velocity; });
}

double WaterInertia::taken_by_water(const IslandEquations& s) const {
  double rise = 0;
  for (const int b : s.island.blocks) {
    if (at(b) >= state_.guard.blocks()) continue;
    const Eigen::Vector3d began = trial_.began_with[at(b)].head<3>();
    const Eigen::Vector3d ends = state_.blocks[at(b)].velocity.head<3>();
    rise += (ends - began).dot(state_.guard.mass(at(b)) * (ends + began)) / 2;
  }
  const Numbers here = motions_of(s);
  if (here.empty()) return rise;
  const Eigen::VectorXd began = velocities_before();
  const Eigen::VectorXd ends = velocities_now();
  const Eigen::VectorXd momentum = masses_ * (ends + began);
  for (const Eigen::Index m : here) rise += (ends - began).segment<3>(3 * m).dot(momentum.segment<3>(3 * m)) / 2;
  return rise;
}

void WaterInertia::pass_on(const IslandEquations& s, double dt) const {
  const Numbers here = motions_of(s);
  if (here.empty()) return;
  const Eigen::VectorXd push = masses_ * (velocities_now() - velocities_before()) / dt;
  for (const Eigen::Index m : here) {
    for (const auto& [part, by_rates] : motions_[static_cast<std::size_t>(m)].shares) {
      if (model_.blocks[at(part)].is_part()) continue;
      trial_.for_motion[at(part)] -= (by_rates * trial_.increment[at(part)]).dot(push.segment<3>(3 * m));
    }
  }
}

void WaterInertia::add_to_residual(IslandEquations& s) const {
  s.pulls.clear();
  const Numbers here = motions_of(s);
  if (here.empty()) return;
  s.pulls.assign(s.island.blocks.size(), Vector6::Zero());
  const Eigen::VectorXd moved = gather([this](std::size_t part) -> Vector6 {
    return model_.blocks[part].is_part() ? trial_.corner_increment(part) : trial_.increment[part];
  });
  const Eigen::VectorXd pull = trial_.scheme.mass_factor(trial_.dt) * (masses_ * moved);
  for (const Eigen::Index m : here) {
    const Motion& motion = motions_[static_cast<std::size_t>(m)];
    const Eigen::Vector3d left = (history_ - pull).segment<3>(3 * m);
    const Eigen::Vector3d noise =
        sum_round_off * (pull.segment<3>(3 * m).cwiseAbs() + history_.segment<3>(3 * m).cwiseAbs());
    for (const auto& [part, by_rates] : motion.shares) {
      if (!model_.blocks[at(part)].is_part()) {
        s.pulls[at(s.local(part))] += by_rates.transpose() * left;
        continue;
      }
      const auto& nodes = s.unknowns->of(s.local(part));
      s.residual(nodes) += by_rates.transpose() * left;
      s.uncertain(nodes) += by_rates.cwiseAbs().transpose() * noise;
    }
  }
}

/// The rows of masses_ that have inertia, of an island: a straight wall's corners have it along its normal alone.
WaterInertia::Numbers WaterInertia::rows_of(const IslandEquations& s) const {
  Numbers rows;
  for (const Eigen::Index m : motions_of(s)) {
    for (Eigen::Index row = 3 * m; row < 3 * m + 3; ++row) {
      if (!masses_.row(row).isZero(0)) rows.push_back(row);
    }
  }
  return rows;
}

/// S: in the step's matrix.
Eigen::MatrixXd WaterInertia::inertia(const Numbers& rows) const {
  return trial_.scheme.mass_factor(trial_.dt) * masses_(rows, rows);
}

LowRank WaterInertia::beside(const IslandEquations& s) const {
  LowRank beside;
  const Numbers rows = rows_of(s);
  if (rows.empty()) return beside;
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (const auto& [part, by_rates] : motions_[static_cast<std::size_t>(rows[k] / 3)].shares) {
      const auto& own = s.unknowns->of(s.local(part));
      for (std::size_t i = 0; i < own.size(); ++i) {
        const double share = by_rates(rows[k] % 3, static_cast<Eigen::Index>(i));
        if (share != 0) entries.emplace_back(own[i], static_cast<int>(k), share);
      }
    }
  }
  beside.U.resize(s.unknowns->total, static_cast<Eigen::Index>(rows.size()));
  beside.U.setFromTriplets(entries.begin(), entries.end());
  beside.S = inertia(rows);
  return beside;
}

void WaterInertia::add_to_saddle(const IslandEquations& s, SaddlePoint& saddle) const {
  constexpr double nothing = 1e-12;  // of the heaviest mode
  const Numbers rows = rows_of(s);
  if (rows.empty()) return;
  const SymmetricModes modes = symmetric_modes(inertia(rows));
  const double heaviest = modes.values.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < modes.values.size(); ++i) {
    const double inertia = modes.values[i];
    if (std::abs(inertia) <= nothing * heaviest) continue;
    saddle.add_force(0, -1 / inertia);
    Eigen::VectorXd mode = Eigen::VectorXd::Zero(masses_.rows());
    mode(rows) = modes.vectors.col(i);
    for (const Eigen::Index m : motions_of(s)) {
      for (const auto& [part, by_rates] : motions_[static_cast<std::size_t>(m)].shares) {
        const Block& block = model_.blocks[at(part)];
        Vector6 along = by_rates.transpose() * mode.segment<3>(3 * m);
        if (block.is_part()) along = corner_shape(block, trial_.placement[at(part)]).transpose() * along;
        saddle.couple(s.local(part), -along, along);
      }
    }
  }
}

}  // namespace blockweir::solid
