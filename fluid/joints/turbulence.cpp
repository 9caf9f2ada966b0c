// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/turbulence.hpp"

#include <fmt/format.h>

#include <cmath>

namespace blockweir::joints {

void Turbulence::look(const wire::Load& load, double time_s, double reynolds_number, const std::string& joint) {
  breached_ = breached_ || load.breached;
  if (breached_ || reynolds_number <= highest_) return;
  highest_ = reynolds_number;
  joint_ = joint;
  time_s_ = time_s;
  level_m_ = load.upstream_level_m;
}

std::string Turbulence::warning(const scene::Scene& scene) const {
  constexpr double laminar = 1000;  // Louis
  if (highest_ <= laminar) return {};
  const auto& level_m = scene.water.upstream_level_m;
  const std::string when = level_m && std::isfinite(level_m->constant_until(0))
                               ? fmt::format("a level of {:.5g} m", level_m_)
                               : fmt::format("{:.4g} s", time_s_);
  return fmt::format(
      "flow in joint \"{}\" has a Reynolds number of {:.3g} at {}, above {}, where the cubic law ends: it "
      "overestimates the flow",
      joint_, highest_, when, laminar);
}

}  // namespace blockweir::joints
