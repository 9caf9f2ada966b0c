// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/capacity/static_blocks.hpp"

#include <algorithm>

#include "bridge/checkpoint/archive.hpp"
#include "solid/solve/islands.hpp"
#include "solid/watch/edge_tension.hpp"
#include "solid/watch/make_frame.hpp"
#include "solid/watch/uplift_in_tension.hpp"

namespace blockweir::solid {
namespace {

/// What the static analysis calls balanced, over the weight: the answer is as exact as that.
constexpr double balanced = 1e-11;

scene::Scene at_rest(scene::Scene scene) {
  scene.analysis.kind = scene::AnalysisKind::at_rest;
  scene.analysis.residual_tolerance = std::min(scene.analysis.residual_tolerance, balanced);
  return scene;
}

}  // namespace

std::string moving_most(const Solid& solid) {
  std::size_t most = 0;
  double largest = 0;
  for (std::size_t b = 0; b < solid.described(); ++b) {
    if (solid.blocks()[b].fixed) continue;
    const double moved = solid.blocks()[b].mass_per_m() * solid.states()[b].displacement.head<2>().norm();
    if (moved > largest) largest = moved, most = b;
  }
  return solid.scene().blocks[most].name;
}

bool supports_move(const Solid& solid) {
  const double end_s = solid.scene().analysis.duration_s;
  const auto& supports = solid.state().supports;
  return std::any_of(supports.begin(), supports.end(), [end_s](Support support) {
    support.share = 1;
    return !support.target(end_s).isZero(0);
  });
}

long most_systems(const Solid& solid) {
  constexpr long of_all = 800'000;  // blocks solved for, in the largest group of them that touch
  std::vector<bool> fixed;
  for (const Block& block : solid.blocks()) fixed.push_back(block.fixed);
  std::vector<std::pair<int, int>> links;
  for (const ContactPoint& c : solid.contacts()) links.emplace_back(c.vertex_part, c.edge_part);
  std::size_t largest = 1;
  for (const Island& group : find_islands(fixed, links, {})) largest = std::max(largest, group.blocks.size());
  return of_all / static_cast<long>(largest);
}

StaticBlocks::StaticBlocks(const scene::Scene& scene, StillWater* water, SearchBudget& effort)
    : scene_(at_rest(scene)), far_m_(scene_.analysis.failure_displacement_m), solid_(scene_), water_(water) {
  solid_.call_meanwhile([&effort] { effort.solved_one(); });
}

bool StaticBlocks::begin(double level_m) {
  const std::vector<Panel> water = panels_of(pressures(level_m), solid_);
  if (scene_.analysis.start == scene::Start::equilibrium) solid_.settle(water);
  if (supports_move(solid_)) {  // slips on that way are none of the loads
    solid_.advance(scene_.analysis.duration_s, scene_.analysis.duration_s, water);
    if (!solid_.state().rest.found) return false;
  }
  if (!rests_at(level_m, 1)) return false;
  most_slip_m_ = far_m_ + solid_.largest_displacement_m();
  return true;
}

bool StaticBlocks::rests_at(double level_m, double share) {
  constexpr int most_rounds = 20;
  scene_.analysis.failure_displacement_m = share * far_m_;
  const double end_s = scene_.analysis.duration_s;
  slipped_before_m_ = solid_.state().largest_slip_m();
  moved_before_m_ = solid_.largest_displacement_m();
  for (int round = 0; round < most_rounds; ++round) {
    solid_.advance(end_s, end_s, panels_of(pressures(level_m), solid_));
    if (!solid_.state().rest.found) return false;
    // An anchor that leans more and more as its dam slides stops it at last; the dam has failed by then.
    if (solid_.state().largest_slip_m() - slipped_before_m_ > share * far_m_ || slipped_away()) return false;
    if (solid_.state().rest.steps == 1) break;
  }
  return true;
}

bool StaticBlocks::must_move(double level_m) {
  return solid_.must_move(scene_.analysis.duration_s, panels_of(pressures(level_m), solid_));
}

bool StaticBlocks::slipped_away() const {
  return solid_.state().largest_slip_m() > most_slip_m_;
}

bool StaticBlocks::went_far() const {
  return slipped_away() || std::max(solid_.state().largest_slip_m() - slipped_before_m_,
                                    solid_.largest_displacement_m() - moved_before_m_) > far_m_;
}

std::string StaticBlocks::state() const {
  return checkpoint::pack(solid_);
}

void StaticBlocks::restore(const std::string& state) {
  checkpoint::unpack(state, solid_);
}

const wire::Load& StaticBlocks::pressures(double level_m) {
  static const wire::Load none;
  if (water_ == nullptr) return none;
  motion_.displacement.own().resize(solid_.described());
  motion_.velocity.own().resize(solid_.described());
  for (std::size_t b = 0; b < solid_.described(); ++b) {
    Vector6::Map(motion_.displacement.own()[b].data()) = solid_.states()[b].displacement;
  }
  return water_->at(level_m, motion_);
}

Levels StaticBlocks::levels(double level_m) {
  if (water_ == nullptr) return {};
  const wire::Load& load = pressures(level_m);
  return {load.upstream_level_m, load.downstream_level_m};
}

std::vector<std::string> StaticBlocks::warnings(double level_m) {
  EdgeTension edge;
  edge.look(solid_, std::numeric_limits<double>::quiet_NaN(), level_m);
  OpenedJoints opened;
  const Surfaces surfaces(solid_);
  opened.look(surfaces, surface_sums(solid_, surfaces), levels(level_m));
  std::vector<std::string> warnings{edge.warning(), opened.warning(scene_)};
  std::erase(warnings, "");
  return warnings;
}

}  // namespace blockweir::solid
