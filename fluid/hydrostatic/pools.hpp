// SPDX-License-Identifier: GPL-3.0-or-later
// The bodies of still water beside a structure, and what each wets. No face belongs to two of them.
#pragma once

#include <array>
#include <optional>

#include "fluid/hydrostatic/crest_water.hpp"
#include "fluid/hydrostatic/wet_faces.hpp"

namespace blockweir::hydrostatic {

/// Still water, and what it wets.
struct WaterBody {
  Surface surface;
  const WetFaces* wet;
};

/// Two pools of one level are one body of water. Of two levels the pools are apart; where open water connects them it
/// would flow, which is a breach: each then wets what lies on its side of the upright line through the crest's middle.
/// Where both stand above the crest without a breach, what only the lower of them would reach over it is wet by a third
/// body: over_the_crest().
/// What is found is kept until blocks_moved().
class Pools {
 public:
  struct State {
    std::vector<WaterBody>
        bodies;  ///< the reservoir first; good until blocks_moved(), and until the level of one has changed
    bool breached = false;
  };

  /// NaN stands for a side without a pool.
  State find(const Structure& structure, double upstream_m, double downstream_m, scene::CrestPressure law);
  void blocks_moved() { kept_ = {}; }

  [[nodiscard]] long searches() const { return searches_; }
  [[nodiscard]] long repeats() const { return repeats_; }  ///< searches that were not made, as nothing had changed
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
  std::array<bool, 2> behind_{};  ///< is water of the pools behind the crest?
  long searches_ = 0;
  long repeats_ = 0;
  double search_s_ = 0;
};

}  // namespace blockweir::hydrostatic
