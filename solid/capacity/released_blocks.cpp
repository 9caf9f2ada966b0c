// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/capacity/released_blocks.hpp"

#include "solid/capacity/static_blocks.hpp"
#include "solid/watch/failure_watch.hpp"
#include "solid/watch/fill_motion.hpp"
#include "solid/watch/make_frame.hpp"

namespace blockweir::solid {
namespace {

/// Held joints would lock blocks by forces that none of them has once it is let go.
scene::Scene let_go(scene::Scene scene) {
  scene.analysis.kind = scene::AnalysisKind::dynamic;
  scene.analysis.integrator = scene::Integrator::shi;  // damps what strains
  scene.analysis.start = scene::Start::unstressed;
  return scene;
}

}  // namespace

ReleasedBlocks::ReleasedBlocks(const scene::Scene& scene, StillWater* water, SearchBudget& effort)
    : scene_(let_go(scene)), solid_(scene_), water_(water) {
  solid_.call_meanwhile([&effort] { effort.solved_one(); });
}

bool ReleasedBlocks::come_to_rest(double level_m) {
  constexpr int most_steps = 1000;
  constexpr int a_while = 10;  // steps in a row in which all blocks stand
  if (scene_.base_motion) throw Undecided("blocks are not let go in an earthquake");
  const double end_s = scene_.analysis.duration_s;
  if (supports_move(solid_)) throw Undecided("blocks are not let go where a [[support]] has moved");
  FailureWatch watch(solid_);
  watch.look(0, {});
  std::vector<Panel> water;
  for (int step = 0, stood = 0; step < most_steps; ++step) {
    if (step % a_while == 0)
      water = panels_of(pressures(level_m), solid_);               // flow in joints costs far more than a step
    solid_.advance(end_s - scene_.analysis.step_s, end_s, water);  // loads stay
    watch.look((step + 1) * scene_.analysis.step_s, {});
    if (!watch.failures().empty()) return false;
    if (solid_.state().largest_slip_m() > scene_.analysis.failure_displacement_m) return false;
    stood = watch.at_rest() ? stood + 1 : 0;
    if (stood == a_while) return true;
  }
  throw Undecided("let go as drawn, the blocks neither come to rest nor fail");
}

const wire::Load& ReleasedBlocks::pressures(double level_m) {
  static const wire::Load none;
  if (water_ == nullptr) return none;
  fill_motion(solid_, 0, motion_);
  return water_->at(level_m, motion_);
}

}  // namespace blockweir::solid
