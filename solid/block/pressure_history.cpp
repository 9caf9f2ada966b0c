// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/block/pressure_history.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace blockweir::solid {
namespace {

std::set<std::pair<int, int>> edges(const std::vector<Panel>& panels) {
  std::set<std::pair<int, int>> all;
  for (const Panel& p : panels) all.emplace(p.block, p.edge);
  return all;
}

/// Are the edges divided as before? One end of a panel may have moved, as at a surface that rises.
bool same_panels(const std::vector<Panel>& a, const std::vector<Panel>& b) {
  constexpr double same = 1e-9;  // of an edge
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Panel& p, const Panel& q) {
    return p.block == q.block && p.edge == q.edge &&
           (std::abs(p.s_from - q.s_from) < same || std::abs(p.s_to - q.s_to) < same);
  });
}

using Exchanges = std::array<std::vector<Panel>, 3>;

/// Of panels that correspond.
void interpolate(const Exchanges& exchanges, const PressureHistory::Weights& weights, std::vector<Panel>& blend) {
  blend = exchanges[0];
  for (std::size_t p = 0; p < blend.size(); ++p) {
    const auto mix = [&](double Panel::*value) {
      double sum = 0;
      for (std::size_t i = 0; i < weights.size(); ++i) {
        if (weights[i] != 0) sum += weights[i] * (exchanges[i][p].*value);
      }
      return sum;
    };
    blend[p].s_from = std::clamp(mix(&Panel::s_from), 0.0, 1.0);
    blend[p].s_to = std::clamp(mix(&Panel::s_to), blend[p].s_from, 1.0);
    blend[p].pressure_from_pa = mix(&Panel::pressure_from_pa);
    blend[p].pressure_to_pa = mix(&Panel::pressure_to_pa);
  }
}

/// The panels of all exchanges, each with its share of the pressure: forces are linear in that.
void superpose(const Exchanges& exchanges, const PressureHistory::Weights& weights, std::vector<Panel>& blend) {
  blend.clear();
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] == 0) continue;
    for (Panel p : exchanges[i]) {
      p.pressure_from_pa *= weights[i];
      p.pressure_to_pa *= weights[i];
      blend.push_back(p);
    }
  }
}

}  // namespace

void PressureHistory::add(double time_s, std::vector<Panel> panels) {
  const bool goes_on = known_ > 0 && time_s > time_s_[0] && edges(panels) == edges(panels_[0]);
  known_ = goes_on ? std::min(known_ + 1, 3) : 1;
  for (const std::size_t i : {2, 1}) {
    time_s_[i] = time_s_[i - 1];
    panels_[i].swap(panels_[i - 1]);
  }
  time_s_[0] = time_s;
  panels_[0] = std::move(panels);
}

/// Lagrange's polynomials.
PressureHistory::Weights PressureHistory::weights(double time_s) const {
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

const std::vector<Panel>& PressureHistory::at(double time_s) {
  if (degree_ == 0 || known_ < 2) return panels_[0];
  const Weights w = weights(time_s);
  const bool divided_anew =
      (w[1] != 0 && !same_panels(panels_[1], panels_[0])) || (w[2] != 0 && !same_panels(panels_[2], panels_[0]));
  divided_anew ? superpose(panels_, w, blend_) : interpolate(panels_, w, blend_);
  return blend_;
}

}  // namespace blockweir::solid
