// SPDX-License-Identifier: GPL-3.0-or-later
// Structures drawn at random, the same for the same seed, with the level at which each fails: by hand where all that
// stands on a joint moves as one, else by limit analysis.
#pragma once

#include <cstdint>
#include <optional>

#include "tests/independent/limit_equilibrium.hpp"
#include "tests/independent/random.hpp"

namespace blockweir::independent {

struct RandomStructure {
  std::uint64_t seed = 0;
  std::string kind;
  Structure structure;
  double height_m = 0;
  double level_m = 0;              ///< at which it fails
  std::vector<Stack> stacks{};     ///< of those that move as one
  std::optional<Failing> by_hand;  ///< of the same, and of what slides with its rock
};

/// A trapezoid on a level or dipping base, 3 mm to 3 km high: friction, cohesion, tension strength, uplift, tailwater.
RandomStructure monolith(std::uint64_t seed);
/// A gravity dam of 5 to 60 m on a level base, with each law of uplift by turns.
RandomStructure gravity_section(std::uint64_t seed);
/// Two to eight lifts that are bonded but for one joint.
RandomStructure lifts(std::uint64_t seed);
/// An upright wall of lifts without bonds on a base with cohesion.
RandomStructure loose_lifts(std::uint64_t seed);
/// A monolith or bonded lifts, held down by a bolt that yields.
RandomStructure anchored(std::uint64_t seed);
/// A monolith without a bond, tied by a bolt that stretches before it yields.
RandomStructure stretching(std::uint64_t seed);
/// A dam on a bed of rock that can slide with it.
RandomStructure on_rock(std::uint64_t seed);
/// Rows of bricks, without cohesion.
RandomStructure bricks(std::uint64_t seed);
/// A section in Voronoi cells, without cohesion.
RandomStructure voronoi(std::uint64_t seed);

/// Bodies and joints in another order.
Structure reordered(Structure structure, std::uint64_t seed);

}  // namespace blockweir::independent
