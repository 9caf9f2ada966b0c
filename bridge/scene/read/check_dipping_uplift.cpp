// SPDX-License-Identifier: GPL-3.0-or-later
// Warns of uplift laws that leave a part of the pressure out where a crack dips: "full" is the mouth's pressure all
// along, the others are linear along the crack's length, as if its elevation were.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "bridge/results/counted.hpp"
#include "bridge/scene/cracks.hpp"
#include "bridge/scene/hydrostatics.hpp"
#include "bridge/scene/read/reading.hpp"
#include "bridge/scene/water_answers.hpp"

namespace blockweir::scene {
namespace {

constexpr double much = 0.1;  // of the head at the ends

/// Where a crack lies lowest below the elevation that its law reckons with.
struct Dip {
  Point at_m = Point::Zero();
  double depth_m = 0;
};

Dip deepest(const Crack& crack) {
  const double from = crack.mouth().y();
  const double to = crack.law == Uplift::full ? from : crack.end().y();
  Dip dip;
  double station_m = 0;
  for (const CrackPart& part : crack.parts) {
    for (const TracePiece& piece : part.trace.pieces) {
      station_m += (piece.to_m - piece.from_m).norm();
      const double along = station_m / crack.length_m;
      const double depth = from + along * (to - from) - piece.to_m.y();
      if (depth > dip.depth_m) dip = {piece.to_m, depth};
    }
  }
  return dip;
}

struct Found {
  const Crack* crack = nullptr;
  Dip dip;
  int count = 0;

  void add(const Crack& another, const Dip& its) {
    ++count;
    if (its.depth_m <= dip.depth_m) return;
    crack = &another;
    dip = its;
  }
  [[nodiscard]] std::string others() const {
    return count > 1 ? ", and " + results::counted(count - 1, "more crack") : "";
  }
};

}  // namespace

void check_dipping_uplift(const Reading& reading) {
  const Scene& scene = reading.scene;
  if (!still_pools(scene.fluid) || !scene.water.upstream_level_m) return;
  const auto head_m = [&](const std::optional<TimeTable>& level, const Point& at) {
    return level ? std::max(0.0, highest(*level, scene.analysis.duration_s) - at.y()) : 0;
  };
  const auto mouth_head_m = [&](const Crack& crack) { return head_m(scene.water.upstream_level_m, crack.mouth()); };
  const auto end_head_m = [&](const Crack& crack) { return head_m(scene.water.downstream_level_m, crack.end()); };
  Found full;
  Found linear;
  const std::vector<Crack> cracks = find_cracks(scene);
  for (const Crack& crack : cracks) {
    const Dip dip = deepest(crack);
    const double head = std::max(mouth_head_m(crack), end_head_m(crack));
    if (head > 0 && dip.depth_m > much * head) (crack.law == Uplift::full ? full : linear).add(crack, dip);
  }
  if (full.crack != nullptr) {
    reading.problems.warning(
        reading.problems.at(full.crack->known.line),
        fmt::format(
            "uplift = \"full\" in joint \"{}\" is the pressure at its mouth all along, a head of {:.4g} m; its lowest "
            "point lies {:.4g} m lower, where water at rest presses by as much more{}",
            name_of(scene, *full.crack), mouth_head_m(*full.crack), full.dip.depth_m, full.others()),
        "a joint that falls by less than a tenth of the head",
        "add the rest as [[face_pressure]], or know that it is missing");
  }
  if (linear.crack == nullptr) return;
  reading.problems.warning(
      reading.problems.at(linear.crack->known.line),
      fmt::format(
          "joint \"{}\" dips: at ({:.4g}, {:.4g}) m it lies {:.4g} m lower than uplift = \"{}\" reckons, which "
          "interpolates the pressure between the joint's ends; {:.4g} kPa of water pressure are left out there{}",
          name_of(scene, *linear.crack), linear.dip.at_m.x(), linear.dip.at_m.y(), linear.dip.depth_m,
          named(linear.crack->law).name, unit_weight_of_water(scene) * linear.dip.depth_m / 1e3, linear.others()),
      "a joint that lies less than a tenth of the head below the line between its ends",
      "state uplift = \"flow\" for it, which follows the bend, or add the rest as [[face_pressure]]");
}

}  // namespace blockweir::scene
