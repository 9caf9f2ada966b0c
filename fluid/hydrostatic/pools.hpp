// SPDX-License-Identifier: GPL-3.0-or-later
// The bodies of still water beside a structure and the faces that each wets. No face belongs to two of them.
#pragma once

#include <array>
#include <optional>

#include "fluid/hydrostatic/crest_water.hpp"
#include "fluid/hydrostatic/wet_faces.hpp"

namespace blockweir::hydrostatic {

/// A body of still water and the faces that it wets.
struct WaterBody {
  Surface surface;
  const WetFaces* wet;
};

/// Of all bodies, by block, edge and place.
[[nodiscard]] std::vector<WetInterval> wet_intervals(const std::vector<WaterBody>& bodies);

/// Two pools with equal levels are one body of water. Pools with different levels are separate. If open water
/// connects them the water would flow, which is a breach: each pool then wets its side of the vertical line
/// through the middle of the crest. If both are above the crest without a breach, the part that only the lower
/// pool would wet across the crest belongs to a third body: over_the_crest(). A crest that has sunk below a level by
/// more than the width of an open crack, though the scene draws it above, is a breach, too: the water flows over it.
/// Each pool then still wets its side up to the crest. Results are kept until blocks_moved().
class Pools {
 public:
  struct State {
    std::vector<WaterBody> bodies;  ///< the reservoir first; valid until blocks_moved() or a change of a level
    bool breached = false;
  };

  /// NaN: no pool on that side.
  State find(const Structure& structure, double upstream_m, double downstream_m, scene::CrestPressure law);
  void blocks_moved() { kept_ = {}; }

  [[nodiscard]] long searches() const { return searches_; }
  [[nodiscard]] long repeats() const { return repeats_; }  ///< searches saved because nothing had changed
  [[nodiscard]] double search_s() const { return search_s_; }

 private:
  enum Kind : std::size_t { upstream, downstream, both, upstream_part, downstream_part, kinds };
  struct Kept {
    double level_m;
    WetFaces faces;
  };

  const WetFaces& over_crest(const Structure& structure, const State& pools, double lower_m);
  const WetFaces& wet(const Structure& structure, Kind kind, double level_m);
  [[nodiscard]] WetFaces search(const Structure& structure, Kind kind, double level_m) const;

  std::array<std::optional<Kept>, kinds> kept_;
  WetFaces over_crest_;
  std::array<bool, 2> behind_{};  ///< whether water of the pools is behind the crest
  long searches_ = 0;
  long repeats_ = 0;
  double search_s_ = 0;
};

}  // namespace blockweir::hydrostatic
