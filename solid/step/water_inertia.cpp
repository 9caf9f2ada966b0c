// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/water_inertia.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "bridge/scene/at.hpp"
#include "solid/block/corners.hpp"
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
  std::vector<bool> shares(state_.guard.blocks());
  for (const CoupledMass& pair : state_.guard.masses().pairs) shares[at(pair.a)] = shares[at(pair.b)] = true;
  for (std::size_t b = 0; b < state_.guard.blocks(); ++b) {
    if (model_.blocks[b].fixed) continue;
    if (!model_.blocks[b].meshed) {
      trial_.external[b].head<3>() += state_.guard.force(b);
      if (shares[b]) motions_.push_back({b, {}});
    } else if (shares[b] || !state_.guard.mass(b).isZero(0)) {
      motions_.push_back(motion_of_mesh(b));
    }
  }
  if (motions_.empty()) return;
  find_masses();
  const Eigen::VectorXd velocity = velocities_now();
  const Eigen::VectorXd acceleration =
      gather([this](std::size_t t) -> Vector6 { return state_.blocks[t].acceleration; },
             [this](std::size_t b) -> Eigen::Vector3d { return state_.blocks[b].acceleration.head<3>(); });
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
WaterInertia::Motion WaterInertia::motion_of_mesh(std::size_t b) {
  Motion motion{b, {}};
  const double stretch = 2 + state_.placements[b].strain()[0] + state_.placements[b].strain()[1];
  for (const int t : model_.parts.triangles[b]) {
    const Block& triangle = model_.blocks[at(t)];
    const auto& X = triangle.vertices;
    const double share = triangle.area / model_.blocks[b].area;
    auto& P = motion.of_corners.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Point gradient = perpendicular(X[(i + 2) % 3] - X[(i + 1) % 3]) / (2 * triangle.area);
      const auto column = static_cast<Eigen::Index>(2 * i);
      P.block<2, 2>(0, column) = share / 3 * Eigen::Matrix2d::Identity();
      P.block<1, 2>(2, column) = share / stretch * state_.placements[b].turn(perpendicular(gradient)).transpose();
    }
    trial_.external[at(t)] +=
        corner_shape(triangle, state_.placements[at(t)]).transpose() * (P.transpose() * state_.guard.force(b));
  }
  return motion;
}

void WaterInertia::find_masses() {
  const auto count = static_cast<Eigen::Index>(3 * motions_.size());
  masses_.setZero(count, count);
  std::vector<Eigen::Index> place(state_.guard.blocks(), -1);
  for (std::size_t m = 0; m < motions_.size(); ++m) {
    const auto first = static_cast<Eigen::Index>(3 * m);
    place[motions_[m].block] = first;
    if (!motions_[m].of_corners.empty()) masses_.block<3, 3>(first, first) = state_.guard.mass(motions_[m].block);
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
  return std::any_of(motions_.begin(), motions_.end(), [](const Motion& m) { return !m.of_corners.empty(); });
}

WaterInertia::Numbers WaterInertia::motions_of(const IslandEquations& s) const {
  Numbers here;
  for (std::size_t m = 0; m < motions_.size(); ++m) {
    const auto block = static_cast<int>(motions_[m].block);
    if (s.has(motions_[m].of_corners.empty() ? block : model_.parts.triangles[at(block)].front())) {
      here.push_back(static_cast<Eigen::Index>(m));
    }
  }
  return here;
}

template <class OfCorners, class OfBlock>
Eigen::VectorXd WaterInertia::gather(const OfCorners& of_corners, const OfBlock& of_block) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(3 * motions_.size()));
  for (std::size_t m = 0; m < motions_.size(); ++m) {
    const Motion& motion = motions_[m];
    auto own = all.segment<3>(static_cast<Eigen::Index>(3 * m));
    if (motion.of_corners.empty()) own = of_block(motion.block);
    for (std::size_t k = 0; k < motion.of_corners.size(); ++k) {
      own += motion.of_corners[k] * of_corners(at(model_.parts.triangles[motion.block][k]));
    }
  }
  return all;
}

Eigen::VectorXd WaterInertia::velocities_before() const {
  return gather([this](std::size_t t) -> Vector6 { return trial_.began_with[t]; },
                [this](std::size_t b) -> Eigen::Vector3d { return trial_.began_with[b].head<3>(); });
}

Eigen::VectorXd WaterInertia::velocities_now() const {
  return gather([this](std::size_t t) -> Vector6 { return state_.blocks[t].velocity; },
                [this](std::size_t b) -> Eigen::Vector3d { return state_.blocks[b].velocity.head<3>(); });
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
    const Motion& motion = motions_[static_cast<std::size_t>(m)];
    if (!motion.of_corners.empty()) continue;
    trial_.for_motion[motion.block] -= trial_.increment[motion.block].head<3>().dot(push.segment<3>(3 * m));
  }
}

void WaterInertia::add_to_residual(IslandEquations& s) const {
  s.pulls.clear();
  const Numbers here = motions_of(s);
  if (here.empty()) return;
  s.pulls.assign(s.island.blocks.size(), Eigen::Vector3d::Zero());
  const Eigen::VectorXd moved =
      gather([this](std::size_t t) { return trial_.corner_increment(t); },
             [this](std::size_t b) -> Eigen::Vector3d { return trial_.increment[b].head<3>(); });
  const Eigen::VectorXd pull = trial_.scheme.mass_factor(trial_.dt) * (masses_ * moved);
  for (const Eigen::Index m : here) {
    const Motion& motion = motions_[static_cast<std::size_t>(m)];
    const Eigen::Vector3d left = (history_ - pull).segment<3>(3 * m);
    if (motion.of_corners.empty()) s.pulls[at(s.local(static_cast<int>(motion.block)))] = left;
    const Eigen::Vector3d noise =
        sum_round_off * (pull.segment<3>(3 * m).cwiseAbs() + history_.segment<3>(3 * m).cwiseAbs());
    for (std::size_t k = 0; k < motion.of_corners.size(); ++k) {
      const auto nodes = s.unknowns->of(s.local(model_.parts.triangles[motion.block][k]));
      s.residual(nodes) += motion.of_corners[k].transpose() * left;
      s.uncertain(nodes) += motion.of_corners[k].cwiseAbs().transpose() * noise;
    }
  }
}

/// U: what the motions are by an island's unknowns, transposed.
Eigen::MatrixXd WaterInertia::columns(const IslandEquations& s, const Numbers& here) const {
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(s.unknowns->total, static_cast<Eigen::Index>(3 * here.size()));
  Eigen::Index first = 0;
  for (const Eigen::Index m : here) {
    const Motion& motion = motions_[static_cast<std::size_t>(m)];
    if (motion.of_corners.empty()) {
      const auto own = s.unknowns->of(s.local(static_cast<int>(motion.block)));
      for (std::size_t axis = 0; axis < 3; ++axis) columns(own[axis], first + static_cast<Eigen::Index>(axis)) = 1;
    }
    for (std::size_t k = 0; k < motion.of_corners.size(); ++k) {
      const auto nodes = s.unknowns->of(s.local(model_.parts.triangles[motion.block][k]));
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        columns.block<1, 3>(nodes[i], first) += motion.of_corners[k].col(static_cast<Eigen::Index>(i)).transpose();
      }
    }
    first += 3;
  }
  return columns;
}

/// S: in the step's matrix.
Eigen::MatrixXd WaterInertia::inertia(const Numbers& here) const {
  const auto count = static_cast<Eigen::Index>(3 * here.size());
  Eigen::MatrixXd S(count, count);
  for (std::size_t i = 0; i < here.size(); ++i) {
    for (std::size_t j = 0; j < here.size(); ++j) {
      S.block<3, 3>(static_cast<Eigen::Index>(3 * i), static_cast<Eigen::Index>(3 * j)) =
          trial_.scheme.mass_factor(trial_.dt) * masses_.block<3, 3>(3 * here[i], 3 * here[j]);
    }
  }
  return S;
}

WaterFactors WaterInertia::factors(const IslandEquations& s) const {
  WaterFactors factors;
  const Numbers here = motions_of(s);
  if (here.empty()) return factors;
  factors.U = columns(s, here);
  factors.S = inertia(here);
  factors.X.resize(factors.U.rows(), factors.U.cols());
  for (Eigen::Index i = 0; i < factors.U.cols(); ++i) factors.X.col(i) = s.system().solve_again(factors.U.col(i));
  factors.core.compute(Eigen::MatrixXd::Identity(factors.U.cols(), factors.U.cols()) +
                       factors.S * (factors.U.transpose() * factors.X));
  return factors;
}

void WaterInertia::correct(const WaterFactors& f, Eigen::VectorXd& x) {
  if (f.U.cols() == 0) return;
  x -= f.X * f.core.solve(f.S * (f.U.transpose() * x));
}

void WaterInertia::add_to_saddle(const IslandEquations& s, SaddlePoint& saddle) const {
  constexpr double nothing = 1e-12;  // of the heaviest mode
  const Numbers here = motions_of(s);
  if (here.empty()) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(inertia(here));
  const double heaviest = modes.eigenvalues().cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < modes.eigenvalues().size(); ++i) {
    const double inertia = modes.eigenvalues()[i];
    if (std::abs(inertia) <= nothing * heaviest) continue;
    saddle.add_force(0, -1 / inertia);
    Eigen::Index first = 0;
    for (const Eigen::Index m : here) {
      const Motion& motion = motions_[static_cast<std::size_t>(m)];
      const Eigen::Vector3d e = modes.eigenvectors().col(i).segment<3>(first);
      first += 3;
      if (motion.of_corners.empty()) {
        Vector6 along = Vector6::Zero();
        along.head<3>() = e;
        saddle.couple(s.local(static_cast<int>(motion.block)), -along, along);
      }
      for (std::size_t k = 0; k < motion.of_corners.size(); ++k) {
        const auto t = at(model_.parts.triangles[motion.block][k]);
        const Vector6 along =
            corner_shape(model_.blocks[t], trial_.placement[t]).transpose() * (motion.of_corners[k].transpose() * e);
        saddle.couple(s.local(static_cast<int>(t)), -along, along);
      }
    }
  }
}

}  // namespace blockweir::solid
