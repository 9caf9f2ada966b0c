// SPDX-License-Identifier: GPL-3.0-or-later
// Where the reservoir's loads do not act as they are stated: ice beside the face that it is to press on.
#include <fmt/format.h>

#include <algorithm>

#include "bridge/scene/read/reading.hpp"
#include "bridge/scene/upstream_faces.hpp"

namespace blockweir::scene {
namespace {

/// Faces take the pressure of the sheet that lies on them; what lies on none is lost from the thrust.
void check_ice(const Reading& reading) {
  constexpr double round_off = 1e-6;
  const Scene& scene = reading.scene;
  if (!scene.water.ice || !scene.water.upstream_level_m) return;
  const double thickness_m = scene.water.ice->thickness_m;
  const double level_m = scene.water.upstream_level_m->at(scene.analysis.duration_s);
  double held_m = 0;
  for (const UpstreamFace& face : upstream_faces(scene, level_m)) {
    held_m += std::max(0.0, face.top_m.y() - std::max(face.bottom_m.y(), level_m - thickness_m));
  }
  const double lost = 1 - held_m / thickness_m;
  if (lost <= round_off) return;
  reading.problems.warning(
      reading.problems.at(reading.file["ice"].node()->source()),
      fmt::format(
          "[ice] loses {:.3g} % of its thrust: its sheet reaches from {:.4g} to {:.4g} m at the end, and lies on "
          "{:.4g} m of upstream face that can move",
          100 * lost, level_m - thickness_m, level_m, held_m),
      "a sheet that lies on a face over all of its thickness", "correct thickness_m, in metres, or the level");
}

}  // namespace

void check_reservoir(const Reading& reading) {
  check_ice(reading);
}

}  // namespace blockweir::scene
