// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/failure_watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "bridge/scene/at.hpp"
#include "bridge/scene/constant_loads.hpp"
#include "bridge/scene/crumbs.hpp"
#include "bridge/scene/loose_blocks.hpp"
#include "solid/contact/outline.hpp"
#include "solid/watch/energy_debt.hpp"
#include "solid/watch/mobility.hpp"
#include "solid/watch/oscillations.hpp"

namespace blockweir::solid {
namespace {

constexpr int a_spell = 10;  ///< evaluations after which what strains counts as at rest: what slides sticks at times

/// Something pushes the block that nothing balances.
bool sets_out(const Solid& solid, std::size_t b) {
  constexpr double earth = 9.81;  // without gravity loads are held against it, as lengths and speeds are
  const double gravity = solid.scene().analysis.gravity_m_per_s2;
  const double begins = 1e-4 * (gravity > 0 ? gravity : earth);
  return solid.states()[b].acceleration.head<2>().norm() >= begins;
}

/// A way that joints slip by strain alone only where corners give as much under the weight.
double far_by_slip_m(const Solid& solid) {
  return std::max(solid.scene().analysis.failure_displacement_m, solid.model().give_under_weight_m);
}

}  // namespace

FailureWatch::FailureWatch(const Solid& solid)
    : solid_(solid),
      watched_(solid.described()),
      stands_(watched_.size(), true),
      slipped_(watched_.size()),
      slips_(solid),
      unknown_(watched_.size()),
      guided_(watched_.size()),
      crumbs_(scene::crumbs(solid.scene().blocks)),
      loads_stay_(scene::loads_are_constant(solid.scene())),
      loose_(scene::loose_blocks(solid.scene())),
      strains_(anything_strains(solid)),
      rings_(velocities_ring(solid)) {
  for (const int b : loose_) watched_[at(b)].failed = true;
  std::map<std::size_t, int> supports;
  for (const scene::Support& support : solid.scene().supports) {
    if (++supports[at(support.block)] == 2) guided_[at(support.block)] = true;
  }
  for (const scene::ViscousFace& face : solid.scene().viscous_faces) guided_[at(face.block)] = true;
}

/// Of the block's fastest vertex [m/s]. Where directions that contacts hold may ring in the velocity without a motion,
/// no more than the mean since the last look.
double FailureWatch::speed(std::size_t b) const {
  const Placement& now = solid_.placements()[b];
  const Placement before(solid_.blocks()[b].centroid, watched_[b].seen);
  const double passed_s = solid_.time_s() - seen_s_;
  const Point base = solid_.model().base.velocity(solid_.time_s());
  const Point base_moved =
      solid_.model().base.displacement(solid_.time_s()) - solid_.model().base.displacement(seen_s_);
  double fastest = 0;
  for (const Point& X : solid_.blocks()[b].vertices) {
    double v = (now.shape(X) * solid_.states()[b].velocity - base).norm();
    if (rings_ && passed_s > 0) {
      v = std::min(v, (now.displacement(X) - before.displacement(X) - base_moved).norm() / passed_s);
    }
    fastest = std::max(fastest, v);
  }
  return fastest;
}

/// Largest displacement of a vertex since the block was last at rest [m].
double FailureWatch::travel(std::size_t b) const {
  const Placement then(solid_.blocks()[b].centroid, watched_[b].displacement);
  const Point base =
      solid_.model().base.displacement(solid_.time_s()) - solid_.model().base.displacement(watched_[b].time_s);
  double farthest = 0;
  for (const Point& X : solid_.blocks()[b].vertices) {
    farthest = std::max(farthest, (solid_.placements()[b].displacement(X) - then.displacement(X) - base).norm());
  }
  return farthest;
}

/// One of many blocks whose contacts slip a little as the load grows, and seem to let a motion: it has not begun while
/// the block has not come far, at no more than twice the speed at which it strained when it last stood.
bool FailureWatch::creeps(std::size_t b) const {
  constexpr double near = 0.2;  // of a failure
  return unknown_[b] && !solid_.scene().base_motion && speed(b) <= watched_[b].strains &&
         travel(b) <= near * solid_.scene().analysis.failure_displacement_m;
}

/// Which blocks stand.
void FailureWatch::judge() {
  constexpr double straining = 100;  // times the speed of rest: still counts as at rest
  const double rest = solid_.scene().analysis.rest_speed_m_per_s;
  const std::vector<bool> owes = in_debt(solid_);
  std::vector<bool> moves(watched_.size());
  bool any_moves = false;
  bool at_rest = true;
  for (std::size_t b = 0; b < watched_.size(); ++b) {
    const double fastest = solid_.blocks()[b].fixed ? 0 : speed(b);
    moves[b] = fastest > rest || (owes[b] && sets_out(solid_, b));
    any_moves = any_moves || (moves[b] && !watched_[b].failed && !guided_[b]);
    at_rest = at_rest && fastest <= straining * rest;
  }
  slow_ = moves;
  slow_.flip();
  stands_ = slow_;
  at_rest_ = at_rest;
  if (!any_moves || !strains_) {
    at_rest_ = at_rest && std::find(moves.begin(), moves.end(), true) == moves.end();
    return;
  }
  const Mobility can_move = mobility(solid_, moves);
  unknown_ = can_move.unknown;
  // What is shaken slips time and again, and what bolts hold as far as they stretch.
  if (!solid_.scene().base_motion && solid_.bolts().empty()) slipped_ = slips_.largest();
  for (std::size_t b = 0; b < moves.size(); ++b) {
    // Contacts of a mechanism that strains as it goes seem to hold it.
    stands_[b] = stands_[b] || (can_move.only_strains[b] && slipped_[b] <= far_by_slip_m(solid_));
    at_rest_ = at_rest_ && stands_[b];
  }
}

/// It has had no rigid motion for long, and has slipped no farther than strain makes it slip.
bool FailureWatch::strains(std::size_t b) const {
  constexpr double strained = 0.2;  // of a failure
  return watched_[b].stood == a_spell && slipped_[b] <= strained * far_by_slip_m(solid_);
}

void FailureWatch::look(double time_s, const Levels& levels) {
  judge();
  const double passed_s = solid_.time_s() - seen_s_;
  const Point base_moved =
      solid_.model().base.displacement(solid_.time_s()) - solid_.model().base.displacement(seen_s_);
  const int stood_at_start = solid_.starts_at_rest() ? a_spell : -a_spell;  // what sets out rings at first
  for (std::size_t b = 0; b < watched_.size(); ++b) {
    Watched& block = watched_[b];
    if (solid_.blocks()[b].fixed || guided_[b] || block.failed) continue;
    const Vector6& displacement = solid_.states()[b].displacement;
    Point velocity = Point::Zero();
    if (passed_s > 0) velocity = ((displacement - block.seen).head<2>() - base_moved) / passed_s;
    block.stood = !begun_ ? stood_at_start : !stands_[b] ? 0 : std::min(block.stood + 1, a_spell);
    if (slow_[b]) slips_.rests(b);
    if (!begun_ || slow_[b] || strains(b)) {
      block.sets_out_later(time_s, levels);
      block.displacement = displacement;
      block.acceleration.setZero();
      if (passed_s > 0) block.acceleration = (velocity - block.velocity) / passed_s;
      block.strains = slow_[b] ? 0 : 2 * speed(b);
      block.crept = 0;
    } else if (creeps(b)) {
      block.crept = block.strains;
      block.sets_out_later(time_s, levels);
    } else {
      if (block.next_s < 0) block.next = levels, block.next_s = time_s;
      block.moves_on(speed(b), stands_[b], levels);
    }
    block.seen = displacement;
    block.velocity = velocity;
  }
  begun_ = true;
  seen_s_ = solid_.time_s();
  name_failures();
}

/// Of the blocks that have gone as far as a failure.
void FailureWatch::name_failures() {
  const double far = solid_.scene().analysis.failure_displacement_m;
  bool others_move = false;
  std::vector<std::pair<double, std::size_t>> far_gone;  // by displacement
  for (std::size_t b = 0; b < watched_.size(); ++b) {
    if (solid_.blocks()[b].fixed || guided_[b] || watched_[b].failed) continue;
    others_move = others_move || (!crumbs_[b] && watched_[b].next_s >= 0);
    if (stands_[b]) continue;
    if (const double way = travel(b); way > far) far_gone.emplace_back(-way, b);
  }
  if (others_move) std::erase_if(far_gone, [this](const auto& gone) { return crumbs_[gone.second]; });
  std::sort(far_gone.begin(), far_gone.end());
  for (const auto& [way, b] : far_gone) {
    if (watched_[b].failed) continue;  // with a body that went farther
    Failure failure = describe(b);
    std::erase_if(failure.blocks, [&](int other) { return watched_[at(other)].failed; });
    for (const int other : failure.blocks) watched_[at(other)].failed = true;
    failures_.push_back(std::move(failure));
  }
  const auto key = [this](const Failure& f) { return std::pair(of_crumbs(f), f.time_s); };
  std::stable_sort(failures_.begin(), failures_.end(),
                   [&](const Failure& f, const Failure& g) { return key(f) < key(g); });
}

bool FailureWatch::of_crumbs(const Failure& failure) const {
  return std::all_of(failure.blocks.begin(), failure.blocks.end(), [this](int b) { return crumbs_[at(b)]; });
}

bool FailureWatch::is_loose(std::size_t b) const {
  return std::binary_search(loose_.begin(), loose_.end(), static_cast<int>(b));
}

bool FailureWatch::judges_none() const {
  std::size_t judged = 0;
  for (std::size_t b = 0; b < guided_.size(); ++b) judged += !solid_.blocks()[b].fixed && !guided_[b] && !is_loose(b);
  return judged == 0 && !loose_.empty();
}

bool FailureWatch::rests_again() const {
  for (std::size_t b = 0; b < watched_.size(); ++b) {
    if (watched_[b].failed && !is_loose(b) && !slow_[b]) return false;
  }
  return true;
}

double FailureWatch::farthest_failed_m(double before_s) const {
  const Point base = solid_.model().base.displacement(solid_.time_s());
  double farthest = 0;
  for (std::size_t b = 0; b < watched_.size(); ++b) {
    if (!watched_[b].failed || is_loose(b) || watched_[b].time_s >= before_s) continue;
    for (const Point& X : solid_.blocks()[b].vertices) {
      farthest = std::max(farthest, (solid_.placements()[b].displacement(X) - base).norm());
    }
  }
  return farthest;
}

bool FailureWatch::unheld() const {
  constexpr long steps = 10;  // a motion that begins takes some, too
  return solid_.counts().unheld_steps >= steps && !solid_.scene().base_motion;
}

std::optional<Moving> FailureWatch::moving() const {
  std::vector<bool> free(watched_.size());
  for (std::size_t b = 0; b < free.size(); ++b) free[b] = !solid_.blocks()[b].fixed && !guided_[b];
  const std::vector<bool> held = mobility(solid_, free).only_strains;
  std::optional<Moving> fastest;
  for (std::size_t b = 0; b < watched_.size(); ++b) {
    const Watched& block = watched_[b];
    if (!free[b] || block.failed || (!slow_[b] && strains(b))) continue;
    // A slow one may have begun to move, also where what it owes of energy makes it count as moving.
    const double fast = speed(b);
    const bool slow = fast <= solid_.scene().analysis.rest_speed_m_per_s;
    if (slow && !unheld() && (held[b] || !sets_out(solid_, b))) continue;
    const auto key = [&](std::size_t other, double v) { return std::pair(!crumbs_[other], v); };
    if (!fastest || key(b, fast) > key(at(fastest->block), fastest->speed_m_per_s)) {
      fastest = {static_cast<int>(b), fast, travel(b)};
    }
  }
  return fastest;
}

}  // namespace blockweir::solid
