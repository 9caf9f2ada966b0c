// SPDX-License-Identifier: GPL-3.0-or-later
// Uplift laws: the water pressure in a joint, and their parameters in a scene. C++17: the OpenFOAM plugin includes
// this. The pressures are computed in fluid/joints/uplift.hpp.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "bridge/scene/drain.hpp"

namespace blockweir::scene {

enum class Uplift { none, triangular, full, drained, cracked, heads, flow };

/// An uplift law and its name in a scene. `share`: mean pressure over the pressure at the mouth, for laws where it is
/// the same at all levels if the far end is dry.
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

/// Whether the pressure is a curve between the pressures at the joint's ends, independent of other joints.
constexpr bool is_profile(Uplift law) {
  return law != Uplift::none && law != Uplift::flow;
}

struct Piezometer {
  double station_m = 0;  ///< from the joint's upstream end
  double head_m = 0;     ///< an elevation y
};

/// Where a joint bends: how far above the line between its ends it lies there as drawn.
struct Bend {
  double station_m = 0;
  double above_m = 0;
};

/// Known heads in a joint, besides those at its ends.
struct KnownHeads {
  std::optional<Drain> drain;
  std::vector<Piezometer> piezometers;  ///< by station
  double level_m = 0;                   ///< of the reservoir at the reading of the piezometers
  int line = 0;                         ///< where the scene file states the law
};

inline bool operator==(const Piezometer& a, const Piezometer& b) {
  return a.station_m == b.station_m && a.head_m == b.head_m;
}
/// Equal values; the line of the file does not matter.
inline bool operator==(const KnownHeads& a, const KnownHeads& b) {
  return a.drain == b.drain && a.piezometers == b.piezometers && a.level_m == b.level_m;
}

}  // namespace blockweir::scene
