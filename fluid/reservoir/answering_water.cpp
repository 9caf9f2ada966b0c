// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/answering_water.hpp"

#include "bridge/wire/panels.hpp"

namespace blockweir::reservoir {

AnsweringWater::AnsweringWater(WaterMesh mesh, const WaterPhysics& physics, const process::FaceMotion& moves,
                               const std::vector<bool>& fixed, double window_s)
    : mesh_(std::make_unique<WaterMesh>(std::move(mesh))),
      equation_(std::make_unique<PressureEquation>(*mesh_, physics, fixed, window_s)),
      answer_(answer_of(*mesh_, *equation_, moves)),
      remembers_(physics.remembers()) {
  if (remembers_) state_ = equation_->rest();
}

void AnsweringWater::move_to(WaterMesh mesh, const process::FaceMotion& moves, double window_s) {
  const LiftedWater lifted = equation_->lifted(state_);
  *mesh_ = std::move(mesh);
  equation_->update(window_s);
  equation_->keep(lifted, state_);
  answer_ = answer_of(*mesh_, *equation_, moves);
  responses_.resize(0, 0);
}

/// Pressures on the panels by one window of accelerations, from rest. Water that is met a second time is worth a
/// solution for each mode: each window then is one product.
Eigen::VectorXd AnsweringWater::response(const Eigen::VectorXd& accelerations, bool kept) {
  if (accelerations.isZero(0)) return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * answer_.panels.size()));
  if (!kept) return answer_.on_panels(equation_->pressure(answer_.flux * accelerations));
  if (responses_.size() == 0) responses_ = answer_.pressures(*equation_);
  return responses_ * accelerations;
}

bool AnsweringWater::at_rest() const {
  return state_.p.isZero(0) && state_.rate.isZero(0) && state_.loaded.isZero(0);
}

void AnsweringWater::advance(const Eigen::VectorXd& accelerations, bool kept) {
  accelerations_ = accelerations;
  if (remembers_ && !(at_rest() && accelerations.isZero(0))) {
    equation_->step(state_, answer_.flux * accelerations);
    pressure_ = answer_.on_panels(state_.p);
  } else {
    pressure_ = response(accelerations, kept);
  }
}

void AnsweringWater::look_ahead(const Eigen::VectorXd& accelerations, const Eigen::VectorXd& of_ground,
                                const WindowAhead& weights, bool kept) {
  pressure_.setZero(2 * static_cast<Eigen::Index>(answer_.panels.size()));
  if (at_rest() && accelerations.isZero(0) && of_ground.isZero(0)) return;
  PressureState end = state_;
  equation_->step(end, answer_.flux * (weights.start * accelerations + of_ground));
  state_.loaded = end.p + weights.past * (state_.p - state_.loaded);
  pressure_ = answer_.on_panels(state_.loaded) + weights.inertia * response(accelerations, kept);
}

Eigen::VectorXd AnsweringWater::pressure_at_nodes() const {
  return remembers_ ? state_.p : equation_->pressure(answer_.flux * accelerations_);
}

void AnsweringWater::add_panels(wire::Load& load) const {
  if (pressure_.isZero(0)) return;
  for (std::size_t i = 0; i < answer_.panels.size(); ++i) {
    const hydrostatic::WetInterval& panel = answer_.panels[i];
    const auto row = static_cast<Eigen::Index>(2 * i);
    wire::add_panel(load, panel.block, panel.edge, panel.s_from, panel.s_to, pressure_[row], pressure_[row + 1]);
  }
}

}  // namespace blockweir::reservoir
