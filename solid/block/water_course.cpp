// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/block/water_course.hpp"

#include <algorithm>

namespace blockweir::solid {
namespace {

bool same_places(const std::vector<Panel>& a, const std::vector<Panel>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Panel& p, const Panel& q) { return p.block == q.block && p.edge == q.edge; });
}

}  // namespace

void WaterCourse::add(double time_s, std::vector<Panel> panels) {
  const bool goes_on = known_ > 0 && time_s > time_s_[0] && same_places(panels, panels_[0]);
  known_ = goes_on ? std::min(known_ + 1, 3) : 1;
  for (const std::size_t i : {2, 1}) {
    time_s_[i] = time_s_[i - 1];
    panels_[i].swap(panels_[i - 1]);
  }
  time_s_[0] = time_s;
  panels_[0] = std::move(panels);
}

/// Lagrange's polynomials.
WaterCourse::Weights WaterCourse::weights(double time_s) const {
  const auto points = static_cast<std::size_t>(std::clamp(known_, 1, degree_ + 1));
  Weights weights{};
  for (std::size_t i = 0; i < points; ++i) {
    weights[i] = 1;
    for (std::size_t j = 0; j < points; ++j) {
      if (j != i) weights[i] *= (time_s - time_s_[j]) / (time_s_[i] - time_s_[j]);
    }
  }
  return weights;
}

const std::vector<Panel>& WaterCourse::at(double time_s) {
  if (degree_ == 0 || known_ < 2) return panels_[0];
  const Weights w = weights(time_s);
  blend_ = panels_[0];
  for (std::size_t p = 0; p < blend_.size(); ++p) {
    const auto mix = [&](double Panel::*value) {
      double sum = 0;
      for (std::size_t i = 0; i < w.size(); ++i) {
        if (w[i] != 0) sum += w[i] * (panels_[i][p].*value);
      }
      return sum;
    };
    blend_[p].s_from = std::clamp(mix(&Panel::s_from), 0.0, 1.0);
    blend_[p].s_to = std::clamp(mix(&Panel::s_to), blend_[p].s_from, 1.0);
    blend_[p].pressure_from_pa = mix(&Panel::pressure_from_pa);
    blend_[p].pressure_to_pa = mix(&Panel::pressure_to_pa);
  }
  return blend_;
}

}  // namespace blockweir::solid
