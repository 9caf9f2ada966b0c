// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/answers/other_orders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bridge/scene/reordered.hpp"
#include "solid/answers/answer_entries.hpp"

namespace blockweir::solid {

using limit::Bearing;

namespace {

struct Order {
  const char* listed;
  scene::Scene scene;
};

std::vector<Order> other_orders(const scene::Scene& scene) {
  const scene::Scene rigid = with_rigid_blocks(scene);
  std::vector<Order> orders;
  for (const bool upwards : {true, false}) {
    std::vector<int> order = scene::from_left_to_right(rigid, upwards);
    orders.push_back({"from left to right", scene::reordered(rigid, order)});
    std::reverse(order.begin(), order.end());
    orders.push_back({"from right to left", scene::reordered(rigid, order)});
  }
  return orders;
}

}  // namespace

StaticStrength strength_if_lower(const scene::Scene& other, Situation& now, const StaticStrength& found,
                                 std::optional<double> jumps_below) {
  if (found.bearing != Bearing::bears_none) {
    const double factor = found.bearing == Bearing::fails_at_a_factor ? found.factor : 1;
    // What stands with less friction may fail with more where equilibrium does not determine it: one share is not
    // enough.
    for (const double share : {0.95, 0.7, 0.5}) {
      const double weaker = share * factor;
      if (!stands(with_reduced_strength(other, weaker), now.water_if_any(), now.level_m)) {
        return static_strength(other, now.water_if_any(), now.level_m, weaker, jumps_below);
      }
    }
  }
  return {.bearing = Bearing::bears_any};
}

void add_strength_in_other_orders(const limit::LimitAnalysis& structure, const process::FluidMaker& make_fluid,
                                  const StaticStrength& found, std::optional<double> jumps_below,
                                  nlohmann::json& answer) {
  if (structure.is_exact()) return;
  StaticStrength lowest = found;
  const char* listed = nullptr;
  for (const Order& other : other_orders(structure.scene())) {
    const auto reordered = attempt([&] {
      Situation now(other.scene, make_fluid);
      return strength_if_lower(other.scene, now, lowest, jumps_below);
    });
    if (!reordered.value || reordered.value->bearing == Bearing::bears_any) continue;
    lowest = *reordered.value;
    listed = other.listed;
  }
  if (listed == nullptr) return;
  const bool bears_none = lowest.bearing == Bearing::bears_none;
  const std::string text = fmt::format(
      "the same blocks{}, listed {}, {}: equilibrium does not determine the friction that holds them beyond, as where "
      "upright faces hold a block; the lower counts",
      strains(structure.scene()) ? " without strain" : "", listed,
      bears_none ? "find no rest with any strength" : fmt::format("have a factor of {:.4g}", lowest.factor));
  answer["with_blocks_reordered"] = {{"factor", bears_none ? 0 : lowest.factor}, {"text", text}};
  answer["warnings"].push_back(text);
}

}  // namespace blockweir::solid
