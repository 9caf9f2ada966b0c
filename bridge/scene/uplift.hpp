// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of the water pressure in a joint, and what a scene states beside their name. C++17: the OpenFOAM plugin includes
// this. fluid/joints/uplift.hpp has the pressures.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "bridge/scene/drain.hpp"

namespace blockweir::scene {

enum class Uplift { none, triangular, full, drained, cracked, heads, flow };

/// A law by its name in a scene. `share`: its mean pressure over that at the mouth, where the far end is dry and this
/// is the same at all levels.
struct UpliftName {
  const char* name;
  Uplift law;
  std::optional<double> share;
};

inline constexpr std::array uplift_names = {UpliftName{"none", Uplift::none, 0.0},
                                            UpliftName{"triangular", Uplift::triangular, 0.5},
                                            UpliftName{"full", Uplift::full, 1.0},
                                            UpliftName{"drained", Uplift::drained, std::nullopt},
                                            UpliftName{"cracked", Uplift::cracked, std::nullopt},
                                            UpliftName{"heads", Uplift::heads, std::nullopt},
                                            UpliftName{"flow", Uplift::flow, std::nullopt}};

inline const UpliftName& named(Uplift law) {
  return uplift_names[static_cast<std::size_t>(law)];
}

/// Whether the pressure is a curve between the pressures of the joint's ends, whatever other joints do.
constexpr bool is_profile(Uplift law) {
  return law != Uplift::none && law != Uplift::flow;
}

struct Piezometer {
  double station_m = 0;  ///< from the joint's upstream end
  double head_m = 0;     ///< as a height on the y axis
};

/// What is known of the head in a joint beside that of its ends.
struct KnownHeads {
  std::optional<Drain> drain;
  std::vector<Piezometer> piezometers;  ///< by station
  double level_m = 0;                   ///< of the reservoir when the piezometers were read
  int line = 0;                         ///< where the scene file states the law
};

inline bool operator==(const Piezometer& a, const Piezometer& b) {
  return a.station_m == b.station_m && a.head_m == b.head_m;
}
/// Wherever they are stated.
inline bool operator==(const KnownHeads& a, const KnownHeads& b) {
  return a.drain == b.drain && a.piezometers == b.piezometers && a.level_m == b.level_m;
}

}  // namespace blockweir::scene
