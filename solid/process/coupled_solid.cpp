// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/process/coupled_solid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/checkpoint/archive.hpp"
#include "bridge/results/stopwatch.hpp"
#include "bridge/scene/repeat.hpp"
#include "bridge/schedule/velocities.hpp"
#include "solid/watch/fill_motion.hpp"
#include "solid/watch/make_frame.hpp"

namespace blockweir::solid {

namespace {

/// The water's panels as a scene states pressures.
std::vector<scene::FacePressure> face_pressures_of(const std::vector<Panel>& water, const scene::Scene& scene) {
  std::vector<scene::FacePressure> loads;
  for (const Panel& panel : water) {
    const auto& outline = scene.blocks[static_cast<std::size_t>(panel.block)].vertices;
    const auto edge = static_cast<std::size_t>(panel.edge);
    const Point& a = outline[edge];
    const Point span = outline[(edge + 1) % outline.size()] - a;
    if (panel.s_to - panel.s_from < 1e-6) continue;
    loads.push_back({.block = panel.block,
                     .from_m = a + panel.s_from * span,
                     .to_m = a + panel.s_to * span,
                     .pressure_from_pa = scene::TimeTable::constant(panel.pressure_from_pa),
                     .pressure_to_pa = scene::TimeTable::constant(panel.pressure_to_pa)});
  }
  return loads;
}

double highest_point_m(const Solid& solid) {
  Eigen::AlignedBox2d all;
  for (std::size_t b = 0; b < solid.blocks().size(); ++b) {
    for (const Point& X : solid.blocks()[b].vertices) all.extend(solid.placements()[b].position(X));
  }
  return all.max().y();
}

}  // namespace

CoupledSolid::CoupledSolid(const scene::Scene& scene, const std::filesystem::path& folder, results::Begin begin,
                           Progress progress)
    : solid_(scene),
      water_(static_cast<int>(scene.coupling.load_in_window)),
      failure_(solid_),
      series_(solid_),
      interface_energy_(solid_),
      folder_(folder),
      history_(folder, scene, begin),
      frame_log_(folder, begin),
      vtk_(folder),
      progress_(std::move(progress)) {}

void CoupledSolid::place(wire::Motion& motion) {
  predict(0, motion);
}

void CoupledSolid::map(const wire::Load& load) {
  const Stopwatch watch(map_s_);
  water_.add(load.time_s, panels_of(load, solid_));
}

void CoupledSolid::predict(double ahead_s, wire::Motion& motion) {
  const Stopwatch watch(map_s_);
  fill_motion(solid_, ahead_s, motion);
}

void CoupledSolid::start(const wire::Load& load) {
  map(load);
  added_mass_.look(load, solid_);
  solve(solid_.scene().coupling.window_s, [&] {
    if (solid_.scene().analysis.start == scene::Start::equilibrium) {
      solid_.call_meanwhile([this] { progress_.settling(solid_.counts().iterations); });
      solid_.settle(water_.at(load.time_s));
    }
  });
  interface_energy_.begin();
  observe(load, 0);
  last_load_ = load;
  unrecorded_ = 0;
  record();
  first_ = frame_;
}

void CoupledSolid::advance(const wire::Load& load, const wire::Motion& sent, double from_s, double to_s) {
  if (load.window > 0) map(load);
  if (load.breached && !breach_) {
    breach_ = {from_s, std::fmax(load.upstream_level_m, load.downstream_level_m), highest_point_m(solid_)};
  }
  const std::vector<Eigen::Vector3d> velocities = schedule::velocities_in(sent);
  AddedMasses masses;
  solid_.call_meanwhile([this, window = sent.window, before = solid_.counts().iterations] {
    progress_.solving(window, solid_.time_s(), solid_.counts().iterations - before);
  });
  solve(to_s, [&] {
    masses = added_mass_.look(load, solid_);
    solid_.advance(from_s, to_s, water_, {masses, velocities, sent.time_s});
  });
  observe(load, to_s);
  watch_interface(load, sent, masses, from_s, to_s);
  for (const ContactPoint& c : solid_.contacts()) {
    const bool over_edge = c.anchor >= 0 && c.anchor <= 1;  // beside the edge there is nothing to enter
    if (c.state != ContactState::open && over_edge) largest_penetration_m_ = std::max(largest_penetration_m_, -c.gap);
  }
  last_load_ = load;
  unrecorded_ = to_s;
}

void CoupledSolid::prepare() {
  const Stopwatch watch(step_s_);
  solid_.prepare();
}

bool CoupledSolid::at_rest() const {
  return failure_.at_rest();
}

void CoupledSolid::solve(double until_s, const std::function<void()>& step) {
  const Stopwatch watch(step_s_);
  try {
    step();
  } catch (const NotFinite&) {
    const scene::Scene& scene = solid_.scene();
    results::replace_file(folder_ / "repeat.toml", scene::repeat_text(scene, std::max(until_s, scene.analysis.step_s),
                                                                      face_pressures_of(water_.last(), scene)));
    throw;
  }
}

void CoupledSolid::watch_interface(const wire::Load& load, const wire::Motion& sent, const AddedMasses& masses,
                                   double from_s, double to_s) {
  const scene::Scene& scene = solid_.scene();
  if (load.block.empty() || scene.analysis.kind != scene::AnalysisKind::dynamic) return;
  const Stopwatch watch(watch_s_);
  double kinetic = energy_.now().kinetic;
  const auto velocities = solid_.model().water_motions.velocities(solid_.states(), masses.own.size());
  const std::vector<Eigen::Vector3d> momenta = masses.times(velocities);
  for (std::size_t m = 0; m < momenta.size(); ++m) kinetic += velocities[m].dot(momenta[m]) / 2;
  interface_energy_.look(water_.last(), sent, {from_s, to_s}, kinetic);
  if (!interface_energy_.growth() || scene.coupling.on_energy_gain == scene::EnergyGain::report) return;
  throw SolveError(interface_energy_.trouble(added_mass_.ratio()));
}

void CoupledSolid::observe(const wire::Load& load, double time_s) {
  const Stopwatch watch(watch_s_);
  const Levels levels{load.upstream_level_m, load.downstream_level_m};
  failure_.look(time_s, levels);
  // A static analysis iterates to equilibrium beyond the initial state, which is only close to it.
  const bool sought = solid_.scene().analysis.kind != scene::AnalysisKind::at_rest || time_s > 0;
  if (failure_.failures().empty() && sought) {
    margins_.look(solid_, time_s, levels);
    edge_tension_.look(solid_, time_s, levels.higher_m());
  }
  acceleration_.add(time_s, solid_.states(), solid_.model().base.displacement(time_s));
  series_.look(solid_, water_.at(time_s), time_s);
  energy_.look(solid_);
  strain_.look(solid_, time_s);
}

void CoupledSolid::record() {
  if (!unrecorded_) return;
  const double time_s = *unrecorded_;
  unrecorded_.reset();
  const Stopwatch watch(output_s_);
  const scene::Output& every = solid_.scene().output;
  const double duration = solid_.scene().analysis.duration_s;
  const double soon = 1e-9 * duration;  // a time that is due but for round-off is due
  const bool last = time_s >= duration - soon || finished();
  const bool history_due = last || time_s >= next_history_s_ - soon;
  const bool frame_due = last || time_s >= next_frame_s_ - soon;
  if (!frame_due) ++frames_.windows_without;
  if (!history_due && !frame_due) return;
  make_frame(solid_, last_load_, water_.last(), time_s, frame_);
  recorded_s_ = time_s;
  if (history_due) {
    history_.write(frame_);
    while (next_history_s_ <= time_s + soon) next_history_s_ += every.history_every_s;
  }
  if (frame_due) {
    const Stopwatch of_frames(frames_.seconds);
    ++frames_.written;
    frame_log_.write(frame_);
    vtk_.write(frame_);
    while (next_frame_s_ <= time_s + soon) next_frame_s_ += every.frame_every_s;
  }
  progress_.run(time_s, last_load_.upstream_level_m, frame_.largest_displacement_m);
}

bool CoupledSolid::finished() const {
  const scene::Analysis& analysis = solid_.scene().analysis;
  const bool sought = solid_.state().rest.steps > 0;
  // A static analysis ends when water that has followed the blocks moves them no more, or nothing holds them.
  if (analysis.kind == scene::AnalysisKind::at_rest && sought) {
    return !solid_.state().rest.found || solid_.state().rest.steps == 1;
  }
  if (interface_energy_.growth() || (analysis.stop_at_breach && breach_)) return true;
  // Without velocities nothing follows a fall.
  return failure_.failed() && (analysis.stop_at_failure || analysis.kind == scene::AnalysisKind::quasi_static);
}

std::string CoupledSolid::state() const {
  return checkpoint::pack(*this);
}

void CoupledSolid::restore(const std::string& state) {
  checkpoint::unpack(state, *this);
}

/// By phase, none of which holds another. Phases of which only samples were timed are not together longer than all
/// steps, nor shorter than what is timed within them.
nlohmann::json CoupledSolid::seconds() const {
  Profile p = solid_.profile();
  const double phases_s = p.search + p.islands + p.assembly + p.solve + p.sweeps + p.accept;
  const double too_long = phases_s > step_s_ ? step_s_ / phases_s : 1;
  for (double* s : {&p.search, &p.islands, &p.contact, &p.assembly, &p.factorization, &p.solve, &p.sweeps, &p.accept}) {
    *s *= too_long;
  }
  return {{"search", p.search},
          {"islands", p.islands},
          {"contact", p.contact},
          {"assembly", std::max(0.0, p.assembly - p.contact)},
          {"factorization", p.factorization},
          {"solve", std::max(0.0, p.solve - p.factorization)},
          {"state_changes", p.sweeps},
          {"accept", p.accept},
          {"rest_of_step", std::max(0.0, step_s_ - too_long * phases_s)},
          {"mapping", map_s_},
          {"watch", watch_s_},
          {"output", output_s_}};
}

void CoupledSolid::finish(const nlohmann::json& extra, const std::string& stopped,
                          const std::vector<std::string>& more_skips) {
  record();
  vtk_.finish();
  const expect::Outcome outcome{.solid = solid_,
                                .first = first_.blocks.empty() ? frame_ : first_,
                                .last = frame_,
                                .failure = failure_,
                                .margins = margins_,
                                .edge_tension = edge_tension_,
                                .strain = strain_,
                                .acceleration = acceleration_,
                                .series = series_,
                                .energy = energy_,
                                .added_mass = added_mass_,
                                .interface_energy = interface_energy_,
                                .frames = frames_,
                                .largest_penetration_m = largest_penetration_m_,
                                .breach = breach_};
  nlohmann::json text = {{"warnings", solid_.scene().warnings}};  // of a start that fails, too
  if (recorded_s_ >= 0) text = output::summary(outcome);
  if (!vtk_.lost().empty()) text["warnings"].push_back(vtk_.lost());
  for (const std::string& skip : more_skips) text["skips"].push_back(skip);
  text["profile_s"] = seconds();
  if (!stopped.empty()) {
    text["outcome"] = "stopped";
    text["stopped"] = stopped;
  }
  text.merge_patch(extra);
  results::replace_file(folder_ / "summary.json", text.dump(2) + "\n");
}

}  // namespace blockweir::solid
