// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/reservoir_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/checkpoint/archive.hpp"
#include "bridge/geometry/polygon.hpp"
#include "bridge/results/saving.hpp"
#include "bridge/results/stopwatch.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/water_answers.hpp"
#include "bridge/schedule/velocities.hpp"
#include "bridge/wire/panels.hpp"
#include "fluid/reservoir/carry_over.hpp"
#include "fluid/reservoir/scene_water.hpp"

namespace blockweir::reservoir {
namespace {

void copy_panels(const wire::Load& from, std::size_t first, std::size_t last, wire::Load& to) {
  for (std::size_t i = first; i < last; ++i) {
    wire::add_panel(to, static_cast<int>(from.block[i]), static_cast<int>(from.edge[i]), from.s_from[i], from.s_to[i],
                    from.pressure_from_pa[i], from.pressure_to_pa[i]);
  }
}

std::array<double, 2> levels_of(const wire::Load& load) {
  return {load.upstream_level_m, load.downstream_level_m};
}

}  // namespace

ReservoirModel::ReservoirModel(const scene::Scene& scene, const std::filesystem::path& folder)
    : scene_(scene), shaking_(scene), still_(scene) {
  if (scene::flows_in_joints(scene) && !folder.empty()) flow_.emplace(scene, folder);
  if (scene.output.reservoir && !folder.empty()) pictures_.emplace(scene, folder);
  for (const scene::Block& block : scene.blocks) fixed_.push_back(block.fixed);
  const scene::Analysis& analysis = scene.analysis;
  if (scene::answers_ahead(scene)) {
    ahead_ = window_ahead(scene::newmark_weights(analysis.integrator, analysis.spectral_radius));
  }
}

void ReservoirModel::advance(const wire::Motion& motion, double to_s, wire::Load& load) {
  // The solid says nothing while nothing moves: what has changed since has done so in the last window.
  const double longest_s = scene_.coupling.window_s;
  const double window_s = told_ && to_s > time_s_ ? std::min(to_s - time_s_, longest_s) : longest_s;
  const Motions before = accelerations_;
  const double before_s = time_s_;
  take_accelerations(motion, {to_s - window_s, to_s});
  still_.advance(motion, to_s, still_load_);
  const double solved_s = ahead_ ? longest_s : window_s;
  const bool kept = !outdated(solved_s);
  if (!kept) {
    solved_ = {{}, to_s, still_.outlines(), levels_of(still_load_), solved_s};
    solved_.motion.displacement = motion.displacement.values();
    solved_.motion.face_s = motion.face_s.values();
    solved_.motion.face_edge = motion.face_edge.values();
    solve(still_);
  } else {
    ++kept_;
  }
  wire::clear_panels(load);
  load.upstream_level_m = still_load_.upstream_level_m;
  load.downstream_level_m = still_load_.downstream_level_m;
  load.breached = still_load_.breached;
  copy_panels(still_load_, 0, still_load_.cracks_from, load);
  if (ahead_) {
    look_ahead(before, before_s, kept);
  } else {
    for (AnsweringWater& water : waters_) water.advance(for_modes(water.answer(), accelerations_, ground_), kept);
  }
  for (const AnsweringWater& water : waters_) water.add_panels(load);
  load.cracks_from = static_cast<std::uint32_t>(load.block.size());
  copy_panels(still_load_, still_load_.cracks_from, still_load_.block.size(), load);
  guarded_.write(load);
  load.holds_until_s = moves() || pictures_ ? to_s : still_load_.holds_until_s;
}

/// The time of the motion behind the velocities told.
double ReservoirModel::known_until_s(double told_s) const {
  const bool middles = scene_.coupling.schedule == scene::Schedule::improved;
  return std::max(0.0, told_s - (middles ? scene_.coupling.window_s / 2 : 0));
}

/// Steps to where the motion is known, and looks a window further. `before`: accelerations told at before_s.
void ReservoirModel::look_ahead(const Motions& before, double before_s, bool kept) {
  const double window_s = scene_.coupling.window_s;
  const double now_s = known_until_s(time_s_);
  const Motions none(accelerations_.size(), Eigen::Vector3d::Zero());
  Motions mean = none;
  for (std::size_t m = 0; m < std::min(before.size(), mean.size()); ++m) {
    mean[m] = ahead_->gamma * accelerations_[m] + (1 - ahead_->gamma) * before[m];
  }
  const auto ground_until = [&](double end_s) {  // its mean over a window, of the values at both ends
    const double from_s = end_s - window_s;
    return Point(ahead_->gamma * shaking_.stated_acceleration({from_s, end_s}) +
                 (1 - ahead_->gamma) * shaking_.stated_acceleration({from_s - window_s, from_s}));
  };
  for (AnsweringWater& water : waters_) {
    const WaterAnswer& answer = water.answer();
    if (now_s > known_until_s(before_s)) {
      water.advance(for_modes(answer, mean, ground_until(now_s)), kept);
    }
    water.look_ahead(for_modes(answer, accelerations_, Point::Zero()),
                     for_modes(answer, none, ground_until(now_s + window_s)), *ahead_, kept);
  }
}

void ReservoirModel::record(double time_s) {
  if (flow_) flow_->record(time_s, still_.flow_in_joints());
  if (pictures_) pictures_->record(time_s, waters_);
}

bool ReservoirModel::moves() const {
  return scene_.base_motion ||
         !std::all_of(accelerations_.begin(), accelerations_.end(), [](const auto& a) { return a.isZero(0); }) ||
         !std::all_of(waters_.begin(), waters_.end(), [](const AnsweringWater& water) { return water.at_rest(); });
}

void ReservoirModel::take_accelerations(const wire::Motion& motion, const scene::TimeSpan& window) {
  Motions velocities = schedule::velocities_in(motion);
  accelerations_.resize(velocities.size(), Eigen::Vector3d::Zero());
  if (told_ && velocities.size() == velocities_.size() && window.to_s > time_s_) {
    for (std::size_t b = 0; b < velocities.size(); ++b) {
      accelerations_[b] = (velocities[b] - velocities_[b]) / (window.to_s - window.from_s);
    }
    ground_ = ground_acceleration(window);
  }
  if (shaking_.is_steady()) ground_ = shaking_.steady_acceleration();
  velocities_ = std::move(velocities);
  time_s_ = window.to_s;
  told_ = true;
}

Point ReservoirModel::ground_acceleration(const scene::TimeSpan& window) const {
  if (!scene_.base_motion) return Point::Zero();
  const auto ground = std::find(fixed_.begin(), fixed_.end(), true);
  if (scene_.base_motion->form == scene::BaseForm::inertia || ground == fixed_.end()) {
    return shaking_.stated_acceleration(window);
  }
  return accelerations_[static_cast<std::size_t>(ground - fixed_.begin())].head<2>();
}

/// Has a corner, or a level, moved by more than a share of the depth since the water was solved for? Water that
/// remembers is solved for windows of one length.
bool ReservoirModel::outdated(double window_s) const {
  if (solved_.outlines.empty()) return true;
  if (physics_of(scene_).remembers() && std::abs(window_s / solved_.window_s - 1) > 1e-9) return true;
  const double tolerance = scene_.reservoir.move_tolerance * deepest_m_;
  const std::array<double, 2> levels = levels_of(still_load_);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (std::abs(levels[i] - solved_.levels_m[i]) > tolerance) return true;
  }
  for (std::size_t b = 0; b < solved_.outlines.size(); ++b) {
    for (std::size_t v = 0; v < solved_.outlines[b].size(); ++v) {
      if ((still_.outlines()[b][v] - solved_.outlines[b][v]).norm() > tolerance) return true;
    }
  }
  return false;
}

void ReservoirModel::solve(const hydrostatic::HydrostaticModel& water) {
  const Stopwatch watch(solve_s_);
  ++solutions_;
  const FaceMotions moves(scene_, solved_.motion, water.outlines());
  if (!move_meshes(water, moves)) mesh_anew(water, moves);
  ground_m_ = water.ground_displacement();
  deepest_m_ = 0;
  for (const hydrostatic::WaterBody& body : water.bodies()) deepest_m_ = std::max(deepest_m_, depth(body));
  guarded_ = GuardedMass(moves.count());
  for (const AnsweringWater& body : waters_) guarded_.add(body.answer(), ahead_ ? ahead_->inertia : 1);
}

/// False if a mesh cannot follow: all stay as they are then.
bool ReservoirModel::move_meshes(const hydrostatic::HydrostaticModel& water, const FaceMotions& moves) {
  if (scene_.reservoir.move_tolerance == 0 || motions_.empty()) return false;
  std::vector<WaterMesh> meshes;
  for (const hydrostatic::WaterBody& body : water.bodies()) {
    if (is_film(scene_, body)) continue;
    if (meshes.size() == motions_.size()) return false;
    const Banks banks{water.outlines(), moves.corners(), water.ground_displacement()};
    std::optional<WaterMesh> moved = motions_[meshes.size()].moved(body, banks, far_ends(scene_, body, banks));
    if (!moved) return false;
    meshes.push_back(*std::move(moved));
  }
  if (meshes.size() != motions_.size()) return false;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    waters_[i].move_to(std::move(meshes[i]), moves, solved_.window_s);
  }
  return true;
}

void ReservoirModel::mesh_anew(const hydrostatic::HydrostaticModel& water, const FaceMotions& moves) {
  const Stopwatch watch(mesh_s_);
  ++meshes_;
  meshed_ = solved_;
  const WaterPhysics physics = physics_of(scene_);
  std::vector<AnsweringWater> waters;
  motions_.clear();
  for (const hydrostatic::WaterBody& body : water.bodies()) {
    const Banks banks{water.outlines(), moves.corners(), water.ground_displacement()};
    WaterMesh mesh = mesh_of(scene_, body, banks);
    if (mesh.triangle.empty()) continue;
    PressureState before =
        physics.remembers() ? carry_over(waters_, mesh, banks.ground_m - ground_m_) : PressureState();
    motions_.emplace_back(mesh, body, banks);
    waters.emplace_back(std::move(mesh), physics, moves, fixed_, solved_.window_s);
    if (physics.remembers()) waters.back().go_on_from(std::move(before));
  }
  for (std::size_t i = 0; i < waters.size() && waters.size() == waters_.size(); ++i)
    waters[i].keep(waters_[i].lifted());
  waters_ = std::move(waters);
}

Eigen::VectorXd ReservoirModel::for_modes(const WaterAnswer& answer, const Motions& motions,
                                          const Point& ground) const {
  const bool inertia = shaking_.is_in_frame_of_ground();
  Eigen::VectorXd a(static_cast<Eigen::Index>(answer.modes.size()));
  for (std::size_t k = 0; k < answer.modes.size(); ++k) {
    const auto [motion, axis] = answer.modes[k];
    const std::size_t n = scene_.blocks.size();
    const bool strains = motion >= 0 && at(motion) >= n && at(motion) < 2 * n;
    const bool with_ground = (motion < 0 || inertia) && axis < 2 && !strains;
    a[static_cast<Eigen::Index>(k)] = (motion < 0 ? 0 : motions[at(motion)][axis]) + (with_ground ? ground[axis] : 0);
  }
  return a;
}

std::string ReservoirModel::state() const {
  std::vector<PressureState> states;
  for (const AnsweringWater& water : waters_) states.push_back(water.state());
  return checkpoint::pack(still_.state(), flow_ ? flow_->state() : "", pictures_ ? checkpoint::pack(*pictures_) : "",
                          meshed_.motion, meshed_.time_s, meshed_.window_s, solved_.motion, solved_.time_s,
                          solved_.window_s, states, velocities_, accelerations_, ground_, time_s_, told_, solutions_,
                          meshes_, kept_);
}

void ReservoirModel::restore(const std::string& state) {
  std::string of_still;
  std::string of_flow;
  std::string of_pictures;
  std::vector<PressureState> states;
  checkpoint::unpack(state, of_still, of_flow, of_pictures, meshed_.motion, meshed_.time_s, meshed_.window_s,
                     solved_.motion, solved_.time_s, solved_.window_s, states, velocities_, accelerations_, ground_,
                     time_s_, told_, solutions_, meshes_, kept_);
  still_.restore(of_still);
  if (flow_) flow_->restore(of_flow);
  if (pictures_) checkpoint::unpack(of_pictures, *pictures_);
  if (!told_) return;
  const std::array counts{solutions_, meshes_};
  const Geometry last = solved_;
  solve_again(meshed_);
  if (last.time_s != meshed_.time_s) solve_again(last);
  for (std::size_t i = 0; i < waters_.size(); ++i) waters_[i].go_on_from(std::move(states.at(i)));
  solutions_ = counts[0];
  meshes_ = counts[1];
}

/// For blocks and levels as they were.
void ReservoirModel::solve_again(Geometry then) {
  hydrostatic::HydrostaticModel water(scene_);
  wire::Load load;
  water.advance(then.motion, then.time_s, load);
  solved_ = std::move(then);
  solved_.outlines = water.outlines();
  solved_.levels_m = levels_of(load);
  solve(water);
}

schedule::FluidReport ReservoirModel::report() const {
  schedule::FluidReport report = still_.report();
  report.seconds["reservoir"] = solve_s_;
  report.counts["reservoir solutions"] = solutions_;
  report.counts["reservoir meshes"] = meshes_;
  if (kept_ > 0) {
    report.skips.push_back(fmt::format(
        "the reservoir's mesh and factors in {} of {} windows: neither a level nor a corner had moved by {} of the "
        "depth{}",
        kept_, kept_ + solutions_, scene_.reservoir.move_tolerance, results::saved(solve_s_, solutions_, kept_)));
  }
  if (solutions_ > meshes_) {
    report.skips.push_back(fmt::format("meshing the reservoir, {} of {} times: the mesh's nodes followed its boundary",
                                       solutions_ - meshes_, solutions_));
  }
  return report;
}

}  // namespace blockweir::reservoir
