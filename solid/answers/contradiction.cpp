// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/answers/contradiction.hpp"

#include <fmt/format.h>

namespace blockweir::solid {
namespace {

using limit::Bearing;

std::string of_no_rest(const StaticStrength& blocks) {
  const std::string moving = blocks.moving.empty() ? "" : fmt::format("; block \"{}\" moves most", blocks.moving);
  return fmt::format(
      "the blocks find no rest even with 1e6 times the strength{}; limit analysis, an upper bound, has joints open as "
      "they slip, so that neighbours hold what friction alone does not: whether more strength would hold the "
      "structure is not known; look at that block, and at the uplift below it",
      moving);
}

std::string of_motion(const StaticStrength& blocks) {
  const std::string factor =
      blocks.bearing == Bearing::fails_at_a_factor ? fmt::format(" (factor {:.5g} there)", blocks.factor) : "";
  return fmt::format(
      "by limit analysis nothing holds the structure as it is drawn; the blocks stand only after they have moved{}: "
      "faces do not touch, and no uplift acts between them, or thin tips hold them; let faces touch",
      factor);
}

}  // namespace

bool contradict(const StaticStrength& blocks, const limit::LimitStrength& bound) {
  return (blocks.bearing == Bearing::bears_none) != (bound.bearing == Bearing::bears_none);
}

void add_contradiction(const StaticStrength& blocks, const limit::LimitStrength& bound, nlohmann::json& answer) {
  if (!contradict(blocks, bound)) return;
  const bool both_fail = bound.bearing == Bearing::bears_none
                             ? blocks.bearing == Bearing::fails_at_a_factor && blocks.factor < 1
                             : bound.bearing == Bearing::fails_at_a_factor && bound.factor < 1;
  answer["outcome"] = both_fail ? "fails" : "not found";
  answer["factor"] = nullptr;
  answer["why_no_factor"] = blocks.bearing == Bearing::bears_none ? of_no_rest(blocks) : of_motion(blocks);
  answer["contradiction"] = true;
}

}  // namespace blockweir::solid
