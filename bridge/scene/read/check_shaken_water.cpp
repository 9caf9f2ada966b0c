// SPDX-License-Identifier: GPL-3.0-or-later
// Windows that are long against a record: the water sees its means over windows, and loses what goes to and fro in one.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {
namespace {

/// Share of the squared record that means over windows do not have.
double lost_share(const BaseMotion& motion, double window_s, double duration_s) {
  constexpr int looks = 16;         // in a window
  constexpr double windows = 2000;  // looked at, of long runs not all
  const double from_window = std::max(1.0, std::floor(duration_s / window_s / windows));
  double all = 0;
  double seen = 0;
  for (const TimeTable* axis : {&motion.acceleration_x_m_per_s2, &motion.acceleration_y_m_per_s2}) {
    for (double from_s = 0; from_s < duration_s; from_s += from_window * window_s) {
      double sum = 0;
      for (int i = 0; i < looks; ++i) {
        const double value = axis->at(from_s + (i + 0.5) / looks * window_s);
        sum += value;
        all += value * value;
      }
      seen += sum * sum / looks;
    }
  }
  return all > 0 ? 1 - seen / all : 0;
}

}  // namespace

void check_shaken_water(const Reading& reading) {
  constexpr double most = 0.05;
  const Scene& scene = reading.scene;
  const bool answers = scene.fluid == FluidModel::reservoir && scene.analysis.kind == AnalysisKind::dynamic;
  if (!scene.base_motion || !answers) return;
  const double lost = lost_share(*scene.base_motion, scene.coupling.window_s, scene.analysis.duration_s);
  if (lost <= most) return;
  const toml::node* stated = reading.file["coupling"]["window_s"].node();
  reading.problems.warning(
      reading.problems.at((stated != nullptr ? stated : reading.file["base_motion"].node())->source()),
      fmt::format(
          "windows of {:.4g} s are long against the record of [base_motion]: the reservoir answers to its means "
          "over windows, which lack {:.3g} % of its power",
          scene.coupling.window_s, 100 * lost),
      fmt::format("at most {:g} %", 100 * most),
      "shorten window_s in [coupling], as to a tenth of the record's shortest period");
}

}  // namespace blockweir::scene
