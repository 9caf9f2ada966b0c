// SPDX-License-Identifier: GPL-3.0-or-later
// Warns of reservoir loads that do not act as stated: ice that misses its face, drains with a head that the water does
// not have.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/cracks.hpp"
#include "bridge/scene/read/reading.hpp"
#include "bridge/scene/structure_size.hpp"
#include "bridge/scene/upstream_faces.hpp"
#include "bridge/scene/water_answers.hpp"

namespace blockweir::scene {
namespace {

/// A sheet presses square to a face that leans, and so holds the structure down, which guidelines do not count on.
void warn_of_leaning_ice(const Reading& reading, double downward) {
  constexpr double seen = 0.05;
  if (downward < seen) return;
  reading.problems.warning(
      reading.problems.at(reading.file["ice"].node()->source()),
      fmt::format(
          "[ice] presses square to a face that leans: {:.3g} % of its thrust presses down and holds the structure",
          100 * downward),
      "ice that acts level, as guidelines have it",
      "state its thrust as a [[point_load]] on the block in place of [ice]");
}

/// Faces take the pressure of the sheet beside them; the part of the thrust beside no face is lost.
void check_ice(const Reading& reading) {
  constexpr double round_off = 1e-6;
  const Scene& scene = reading.scene;
  if (!scene.water.ice || !scene.water.upstream_level_m) return;
  const double thickness_m = scene.water.ice->thickness_m;
  const double level_m = scene.water.upstream_level_m->at(scene.analysis.duration_s);
  double held_m = 0;
  double downward = 0;  // over the thrust
  for (const UpstreamFace& face : upstream_faces(scene, level_m)) {
    const double height_m = std::max(0.0, face.top_m.y() - std::max(face.bottom_m.y(), level_m - thickness_m));
    const Point span = face.top_m - face.bottom_m;
    held_m += height_m;
    downward += height_m / thickness_m * span.x() / span.y();
  }
  warn_of_leaning_ice(reading, downward);
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

/// Highest of the level's rows and its value at the end, with the crest of its waves.
double highest_of(const TimeTable& level, double end_s) {
  const double sine = level.sine ? std::abs(level.sine->amplitude) : 0;
  return std::max(level.rows_at(end_s), *std::max_element(level.value.begin(), level.value.end())) + sine;
}

/// Silt above the crest would pass over it, and silt above the water has not settled in it.
void check_silt(const Reading& reading) {
  const Scene& scene = reading.scene;
  const toml::node* level = reading.file["silt"]["level_m"].node();
  const auto level_m = level == nullptr ? std::nullopt : level->value<double>();
  if (!level_m) return;
  double crest_m = -std::numeric_limits<double>::infinity();
  for (const Block& block : scene.blocks) {
    if (!block.fixed) crest_m = std::max(crest_m, geometry::bounds_of(block.vertices).high.y());
  }
  const double round_off_m = 1e-9 * structure_size_m(scene.blocks);
  const auto& water = scene.water.upstream_level_m;
  if (*level_m <= crest_m && water && *level_m > highest_of(*water, scene.analysis.duration_s) + round_off_m) {
    reading.problems.warning(reading.problems.at(level->source()),
                             fmt::format("level_m in [silt] is {:.6g} m, above the highest reservoir, {:.6g} m",
                                         *level_m, highest_of(*water, scene.analysis.duration_s)),
                             "silt up to the water's level, whose weight is that under water",
                             "exchange the two, or lower the silt");
  }
  if (*level_m <= crest_m + round_off_m) return;
  reading.problems.warning(reading.problems.at(level->source()),
                           fmt::format("level_m in [silt] is {:.6g} m, above the crest at {:.6g} m", *level_m, crest_m),
                           "silt up to the highest point of what can move",
                           "state a height on the y axis, not a depth");
}

/// Where the crack is at this way from its mouth.
Point place_at(const Crack& crack, double station_m) {
  for (const CrackPart& part : crack.parts) {
    for (const TracePiece& piece : part.trace.pieces) {
      const double length_m = (piece.to_m - piece.from_m).norm();
      if (station_m <= length_m) return piece.from_m + station_m / length_m * (piece.to_m - piece.from_m);
      station_m -= length_m;
    }
  }
  return crack.end();
}

void check_drains(const Reading& reading) {
  const Scene& scene = reading.scene;
  if (scene.fluid == FluidModel::none) return;
  const double end_s = scene.analysis.duration_s;
  for (const Crack& crack : find_cracks(scene)) {
    if (!crack.known.drain || std::isnan(crack.known.drain->head_m)) continue;
    if (crack.known.drain->efficiency == 0) continue;  // clogged: the head has no effect
    const double head_m = crack.known.drain->head_m;
    const auto warn = [&](const char* where, double other_m, const char* remedy) {
      reading.problems.warning(
          reading.problems.at(crack.known.line),
          fmt::format("drain_head_m of joint \"{}\" is {:.6g} m, {} {:.6g} m", name_of(scene, crack), head_m, where,
                      other_m),
          "a height on the y axis from the joint at the drain, or the tailwater, up to the reservoir", remedy);
    };
    const double joint_m = place_at(crack, crack.known.drain->station_m).y();
    const auto& up = scene.water.upstream_level_m;
    const auto& down = scene.water.downstream_level_m;
    if (head_m < joint_m) {
      warn("below the joint at the drain,", joint_m, "a drain open to the air has the head of its own height");
    } else if (down && head_m < down->at(end_s)) {
      warn("below the tailwater at the end,", down->at(end_s), "raise it, if the gallery is not pumped dry");
    } else if (up && head_m > highest_of(*up, end_s)) {
      warn("above the highest reservoir,", highest_of(*up, end_s),
           "state the gallery's height, not the depth under it");
    }
  }
}

/// Heads are heights from the joint at the piezometer up to the reservoir's level when they were read.
void check_piezometers(const Reading& reading) {
  const Scene& scene = reading.scene;
  if (scene.fluid == FluidModel::none) return;
  for (const Crack& crack : find_cracks(scene)) {
    if (crack.law != Uplift::heads) continue;
    for (const Piezometer& p : crack.known.piezometers) {
      const double joint_m = place_at(crack, p.station_m).y();
      const bool low = p.head_m < joint_m;
      if (!low && p.head_m <= crack.known.level_m) continue;
      reading.problems.warning(
          reading.problems.at(crack.known.line),
          fmt::format("the piezometer at {:.6g} m of joint \"{}\" has a head of {:.6g} m, {} {:.6g} m", p.station_m,
                      name_of(scene, crack), p.head_m,
                      low ? "below the joint there," : "above the reservoir when it was read,",
                      low ? joint_m : crack.known.level_m),
          "a height on the y axis from the joint at the piezometer up to piezometers_level_m",
          "state the height of the water in its pipe, not the depth under the level nor a pressure");
    }
  }
}

/// Largest depth of water above the foot of moving blocks [m]; 0 without a pool, or if nothing moves.
double deepest(const Scene& scene) {
  double bottom_m = std::numeric_limits<double>::infinity();
  for (const Block& block : scene.blocks) {
    if (!block.fixed) bottom_m = std::min(bottom_m, geometry::bounds_of(block.vertices).low.y());
  }
  double depth_m = 0;
  for (const auto* level : {&scene.water.upstream_level_m, &scene.water.downstream_level_m}) {
    if (*level) depth_m = std::max(depth_m, highest_of(**level, scene.analysis.duration_s) - bottom_m);
  }
  return depth_m;
}

/// A window in which sound runs through half of an element or more: waves that the mesh has are lost in time.
void check_sound_windows(const Reading& reading) {
  constexpr double most = 0.5;
  const Scene& scene = reading.scene;
  const Reservoir& r = scene.reservoir;
  const toml::node* stated = reading.file["fluid"]["reservoir"]["compressible"].node();
  if (!r.compressible || stated == nullptr) return;
  const double element_m = r.element_ratio * deepest(scene);
  const double way_m = r.sound_speed_m_per_s * scene.coupling.window_s;
  if (element_m <= 0 || way_m <= most * element_m) return;
  reading.problems.warning(
      reading.problems.at(stated->source()),
      fmt::format("sound runs {:.3g} m in a window, {:.3g} of the longest element's {:.3g} m", way_m, way_m / element_m,
                  element_m),
      fmt::format("at most {:g} of it", most),
      fmt::format("shorten step_s in [analysis] to {:.2g} s", most * element_m / r.sound_speed_m_per_s));
}

/// Warns of reservoirs so long that their mesh would take minutes without a better answer.
void check_far_walls(const Reading& reading) {
  constexpr double most_depths = 1000;
  const Scene& scene = reading.scene;
  const double depth_m = deepest(scene);
  if (scene.fluid != FluidModel::reservoir || depth_m <= 0) return;
  geometry::Bounds model = geometry::bounds_of(scene.blocks.front().vertices);
  for (const Block& block : scene.blocks) {
    const geometry::Bounds own = geometry::bounds_of(block.vertices);
    model.low = model.low.cwiseMin(own.low);
    model.high = model.high.cwiseMax(own.high);
  }
  const auto look = [&](const char* key, const std::optional<double>& wall_m, double end_m) {
    if (!wall_m || std::abs(*wall_m - end_m) <= most_depths * depth_m) return;
    reading.problems.error(reading.problems.at(reading.file["fluid"]["reservoir"][key].node()->source()),
                           fmt::format("{} is {:g} m, {:.3g} depths of the water beyond the model's end at {:g} m", key,
                                       *wall_m, std::abs(*wall_m - end_m) / depth_m, end_m),
                           fmt::format("at most {:g} depths, {:g} m", most_depths, most_depths * depth_m),
                           "leave it out: the reservoir is long then");
  };
  look("upstream_wall_m", scene.reservoir.upstream_wall_m, model.low.x());
  look("downstream_wall_m", scene.reservoir.downstream_wall_m, model.high.x());
}

bool nothing_moves(const Scene& scene) {
  return std::all_of(scene.blocks.begin(), scene.blocks.end(), [](const Block& block) { return block.fixed; });
}

/// Surface waves whose pressures act a window late damp what swings, or drive it.
void check_waves_held(const Reading& reading) {
  const Scene& scene = reading.scene;
  const toml::node* stated = reading.file["fluid"]["reservoir"]["surface"].node();
  const bool held = scene.coupling.load_in_window == LoadInWindow::held && !answers_ahead(scene);
  if (!scene.reservoir.surface_waves || !held || stated == nullptr || nothing_moves(scene)) return;
  reading.problems.warning(reading.problems.at(stated->source()),
                           "waves run in the water, and its pressures are held in each window: what swings loses or "
                           "gains energy by a share that falls only with the window's length",
                           "schedule = \"improved\", or load_in_window = \"linear\", in [coupling]",
                           "state one of both, and halve window_s to see what is left");
}

/// Where the water cannot look a window ahead, its sound makes what swings grow.
void check_sound_answers_ahead(const Reading& reading) {
  const Scene& scene = reading.scene;
  const toml::node* stated = reading.file["fluid"]["reservoir"]["compressible"].node();
  const bool idle = scene.fluid != FluidModel::reservoir || scene.analysis.kind != AnalysisKind::dynamic;
  if (idle || !scene.reservoir.compressible || stated == nullptr || nothing_moves(scene) || answers_ahead(scene))
    return;
  std::string where =
      fmt::format("steps of {:g} s in windows of {:g} s", scene.analysis.step_s, scene.coupling.window_s);
  std::string expected = "window_s as long as step_s, or left out";
  if (scene.coupling.schedule == Schedule::parallel) {
    where = "the parallel schedule";
    expected = "schedule = \"serial\" or \"improved\"";
  } else if (!scene.coupling.added_mass_guard) {
    where = "no added-mass guard";
    expected = "added_mass_guard = true, or left out";
  }
  reading.problems.error(reading.problems.at(stated->source()),
                         fmt::format("sound in the water beside blocks that move, with {}: its pressures would come a "
                                     "window late, and what swings would gain energy without an end",
                                     where),
                         expected + ", in [coupling]", "state it, or compressible = false");
}

/// Windows grow while blocks rest, whatever the water does.
void check_windows_grow(const Reading& reading) {
  const Scene& scene = reading.scene;
  const toml::node* stated = reading.file["coupling"]["longest_window_s"].node();
  const bool grow = scene.coupling.longest_window_s > scene.coupling.window_s;
  if (stated == nullptr || !grow || scene.fluid != FluidModel::reservoir) return;
  const char* what = scene.reservoir.compressible    ? "sound runs in the water"
                     : scene.reservoir.surface_waves ? "waves run in the water"
                     : scene.base_motion             ? "the ground shakes"
                                                     : nullptr;
  if (what == nullptr) return;
  reading.problems.error(
      reading.problems.at(stated->source()),
      fmt::format("longest_window_s is {:g} s, and {}: while blocks rest windows would grow, and miss "
                  "what its pressures do",
                  scene.coupling.longest_window_s, what),
      fmt::format("no more than window_s, {:g} s", scene.coupling.window_s), "leave it out");
}

}  // namespace

void check_reservoir(const Reading& reading) {
  check_ice(reading);
  check_silt(reading);
  check_drains(reading);
  check_piezometers(reading);
  check_waves_held(reading);
  check_sound_answers_ahead(reading);
  check_windows_grow(reading);
  check_sound_windows(reading);
  check_far_walls(reading);
}

}  // namespace blockweir::scene
