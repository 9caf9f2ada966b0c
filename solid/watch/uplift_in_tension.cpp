// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/uplift_in_tension.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/scene/cracks.hpp"

namespace blockweir::solid {
namespace {

using scene::Crack;
using scene::Uplift;

/// Blocks have strained a little where the row was made.
bool is_of(const JointRow& row, const Crack& crack) {
  constexpr double strained = 1e-2;
  const double off_m = strained * row.length_m;
  return std::abs(crack.length_m - row.length_m) < off_m && (crack.end() - row.downstream_end_m).norm() < off_m;
}

}  // namespace

std::vector<std::string> uplift_warnings(const scene::Scene& scene, const std::vector<JointRow>& rows) {
  constexpr double seen = 1e-2;
  std::vector<std::string> warnings;
  const std::vector<Crack> cracks = scene::find_cracks(scene);
  for (const JointRow& row : rows) {
    if (row.uplift_n_per_m <= 0 || row.cracked_length_m <= seen * row.length_m) continue;
    const auto crack = std::find_if(cracks.begin(), cracks.end(), [&](const Crack& c) { return is_of(row, c); });
    if (crack == cracks.end() || (crack->law != Uplift::drained && crack->law != Uplift::triangular)) continue;
    warnings.push_back(
        fmt::format("joint \"{}\" is in tension over {:.3g} % of its length, by the gravity method, and uplift = "
                    "\"{}\" takes it to "
                    "be closed; water in a crack has the full pressure of its mouth: state uplift = \"cracked\"",
                    row.name, 100 * row.cracked_length_m / row.length_m, scene::named(crack->law).name));
  }
  return warnings;
}

}  // namespace blockweir::solid
