// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/block/base_motion.hpp"

#include <algorithm>
#include <cmath>

namespace blockweir::solid {

double BaseAxis::Stretch::velocity_at(double time_s) const {
  const double t = time_s - from_s;
  return velocity + t * (acceleration + t * slope / 2);
}

double BaseAxis::Stretch::displacement_at(double time_s) const {
  const double t = time_s - from_s;
  return displacement + t * (velocity + t * (acceleration / 2 + t * slope / 6));
}

BaseAxis::BaseAxis(const scene::TimeTable& acceleration) : acceleration_(acceleration) {
  const auto& rows = acceleration.time_s;
  std::vector<double> nodes{0};
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(nodes), [](double time_s) { return time_s > 0; });
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    Stretch next{.from_s = nodes[i], .acceleration = acceleration.rows_at(nodes[i])};
    if (i + 1 < nodes.size() && !acceleration.stepwise) {
      next.slope = (acceleration.rows_at(nodes[i + 1]) - next.acceleration) / (nodes[i + 1] - nodes[i]);
    }
    if (i > 0) {
      next.velocity = stretches_.back().velocity_at(nodes[i]);
      next.displacement = stretches_.back().displacement_at(nodes[i]);
    }
    stretches_.push_back(next);
  }
}

const BaseAxis::Stretch& BaseAxis::stretch(double time_s) const {
  const auto after = std::upper_bound(stretches_.begin() + 1, stretches_.end(), time_s,
                                      [](double t, const Stretch& s) { return t < s.from_s; });
  return *(after - 1);
}

double BaseAxis::velocity(double time_s) const {
  const double rows = stretch(time_s).velocity_at(time_s);
  if (!acceleration_.sine) return rows;
  const auto& [amplitude, omega, phase] = *acceleration_.sine;
  return rows + amplitude / omega * (std::cos(phase) - std::cos(omega * time_s + phase));
}

double BaseAxis::displacement(double time_s) const {
  const double rows = stretch(time_s).displacement_at(time_s);
  if (!acceleration_.sine) return rows;
  const auto& [amplitude, omega, phase] = *acceleration_.sine;
  return rows +
         amplitude / omega * (time_s * std::cos(phase) - (std::sin(omega * time_s + phase) - std::sin(phase)) / omega);
}

BaseMotion::BaseMotion(const scene::Scene& scene) : shakes_(scene.base_motion.has_value()) {
  if (!shakes_) return;
  // Statics has no time to move the ground in: its acceleration at the end is an inertia force in both forms.
  moves_supports_ =
      scene.base_motion->form == scene::BaseForm::support && scene.analysis.kind != scene::AnalysisKind::at_rest;
  axes_ = {BaseAxis(scene.base_motion->acceleration_x_m_per_s2), BaseAxis(scene.base_motion->acceleration_y_m_per_s2)};
}

Point BaseMotion::acceleration(const scene::TimeSpan& step) const {
  return {axes_[0].acceleration(step), axes_[1].acceleration(step)};
}

Point BaseMotion::inertia(const scene::TimeSpan& step) const {
  return shakes_ && !moves_supports_ ? acceleration(step) : Point::Zero();
}

Point BaseMotion::displacement(double time_s) const {
  if (!moves_supports_) return Point::Zero();
  return {axes_[0].displacement(time_s), axes_[1].displacement(time_s)};
}

Point BaseMotion::ground_velocity(const scene::TimeSpan& step, bool mean) const {
  const double from_s = std::max(0.0, step.from_s);
  const double to_s = std::max(0.0, step.to_s);
  if (!mean || !(step.to_s > step.from_s)) return {axes_[0].velocity(to_s), axes_[1].velocity(to_s)};
  const Point moved(axes_[0].displacement(to_s) - axes_[0].displacement(from_s),
                    axes_[1].displacement(to_s) - axes_[1].displacement(from_s));
  return moved / (step.to_s - step.from_s);
}

Point BaseMotion::velocity(double time_s) const {
  if (!moves_supports_) return Point::Zero();
  return {axes_[0].velocity(time_s), axes_[1].velocity(time_s)};
}

}  // namespace blockweir::solid
