// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/step_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "bridge/results/counted.hpp"
#include "bridge/scene/at.hpp"
#include "solid/block/parallel.hpp"

namespace blockweir::solid {
namespace {

/// A support, and how far it goes [m].
struct Led {
  const Support* support = nullptr;
  double way_m = 0;
};

/// The support that goes farthest; none where none moves.
template <class Way>
Led farthest_led(const StepWorkspace& step, Way way) {
  Led farthest;
  for (const Support& support : step.state.supports) {
    if (const double m = way(support).norm(); m > farthest.way_m) farthest = {&support, m};
  }
  return farthest;
}

std::string name_of(const StepWorkspace& step, const Support& support) {
  const scene::Support& described = *support.described;
  return fmt::format("the [[support]] of block \"{}\" at ({:.6g}, {:.6g})",
                     step.model.scene.blocks[at(described.block)].name, described.point_m.x(), described.point_m.y());
}

}  // namespace

void refuse_step(const StepWorkspace& step, double time_s, double dt, Outcome last) {
  const Led led =
      farthest_led(step, [&](const Support& s) -> Point { return s.target(time_s + dt) - s.target(time_s); });
  const bool leads = led.support != nullptr;
  const std::string by_support = leads ? fmt::format("{} goes farthest in it, by {:.3g} m at {:.3g} m/s; ",
                                                     name_of(step, *led.support), led.way_m, led.way_m / dt)
                                       : "";
  if (last == Outcome::too_far) {
    throw SolveError(
        fmt::format("at {:.6g} s blocks move by more than [analysis] max_displacement_ratio in a step, or turn too far "
                    "to find their contacts, even in a step of {:.3g} s; {}are {} in the right units?",
                    time_s, dt, by_support, leads ? "its displacements and times" : "velocities and loads"));
  }
  throw SolveError(
      fmt::format("the contact states did not settle at {:.6g} s, even with a step of {:.3g} s; {}a smaller [analysis] "
                  "step_s or a larger [contact] max_iterations may help",
                  time_s, dt, by_support));
}

void refuse_supports(const StepWorkspace& step, double share, double at_s) {
  const Led led = farthest_led(step, [at_s](const Support& s) { return s.target(at_s); });
  throw SolveError(
      fmt::format("no equilibrium was found with the supports beyond {:.3g} % of their way to where they stand at "
                  "{:.6g} s; {} goes farthest, by {:.3g} m; expected displacements that blocks and joints can follow; "
                  "look for supports that pull a block apart, and for mm written as m",
                  100 * share, at_s, name_of(step, *led.support), led.way_m));
}

void require_small_strains(const StepWorkspace& step) {
  constexpr double most = 0.2;
  for (std::size_t b = 0; b < step.model.described(); ++b) {
    const double strain = step.state.blocks[b].displacement.tail<3>().cwiseAbs().maxCoeff();
    if (strain <= most) continue;
    const scene::Material& material = step.model.scene.materials[at(step.model.scene.blocks[b].material)];
    Box box;
    for (const Point& vertex : step.model.blocks[b].vertices) box.extend(vertex);
    const double own = material.density_kg_per_m3 * step.model.scene.analysis.gravity_m_per_s2 * box.sizes().y();
    throw SolveError(fmt::format(
        "block \"{}\" (line {}) is too soft: the first loads strain it by {:.3g}, above {:.3g}; its weight over its "
        "height of {:.4g} m alone strains its base by density x gravity x height / modulus = {:.3g}; are "
        "youngs_modulus_pa = {:.4g} of material \"{}\" in Pa, density_kg_per_m3 = {:.4g} in kg/m3 and all lengths in "
        "m?",
        step.model.blocks[b].name, step.model.scene.blocks[b].line, strain, most, box.sizes().y(),
        own / material.youngs_modulus_pa, material.youngs_modulus_pa, material.name, material.density_kg_per_m3));
  }
}

namespace {

/// Remedies: a start without stress releases moving parts, but finds no states that this one does not find.
std::string start_advice(const StepWorkspace& step, bool moves_on, double overlap_m) {
  if (moves_on) {
    const bool rests = step.model.scene.analysis.kind == scene::AnalysisKind::at_rest;  // where nothing is on its way
    return std::string("what holds it? Give it a support, a bolt or a face to stand on") +
           (rests ? "" : ", or set [analysis] start = \"unstressed\" if it is meant to move from the start");
  }
  if (overlap_m > 1e-6 * step.model.size_m) return "mend the outlines that overlap";
  return fmt::format("a larger [contact] max_iterations than {} may help", step.model.scene.contact.max_iterations);
}

}  // namespace

/// The unfinished part of the last attempt to start: which blocks still move, and which do not fit each other.
void refuse_start(const StepWorkspace& step, int steps, int most_steps, Outcome last) {
  const bool too_far = last == Outcome::too_far;
  std::string text = fmt::format("no equilibrium under the first loads was found with all joints held ({})",
                                 results::counted(at(steps), "step"));
  const auto moved = [&](std::size_t b) {
    double most = 0;
    for (const Point& X : step.model.blocks[b].vertices)
      most = std::max(most, step.state.placements[b].increment(step.trial.increment[b], X).norm());
    return most;
  };
  std::size_t farthest = 0;
  for (std::size_t b = 1; b < step.model.blocks.size(); ++b) {
    if (moved(b) > moved(farthest)) farthest = b;
  }
  text += fmt::format("; block \"{}\" moves most, by {:.3g} m in the last try", step.model.blocks[farthest].name,
                      moved(farthest));
  if (too_far) text += ", which is more than [analysis] max_displacement_ratio lets a step";
  const ContactPoint* worst = nullptr;
  double apart = 0;
  double overlap = 0;
  for (const ContactPoint& c : step.state.contacts) {
    if (c.state == ContactState::open) continue;
    overlap = std::max(overlap, -(c.gap + c.gap_at_start));
    const double now = separation_of(step.trial.now(), c, edge_frame(step.trial.now(), c)).value.norm();
    if (worst != nullptr && now <= apart) continue;
    worst = &c;
    apart = now;
  }
  if (worst != nullptr) {
    const Point where = step.state.place(*worst);
    text += fmt::format(
        "; blocks \"{}\" and \"{}\" fit least, at ({:.6g}, {:.6g}) they are {:.3g} m from where they were joined; the "
        "largest overlap in the scene is {:.3g} m",
        step.model.blocks[at(worst->vertex_block)].name, step.model.blocks[at(worst->edge_block)].name, where.x(),
        where.y(), apart, overlap);
  }
  throw SolveError(text + "; " + start_advice(step, too_far || steps >= most_steps, overlap));
}

void refuse_number(const StepWorkspace& step, std::size_t b, const char* what, double time_s) {
  throw NotFinite(fmt::format("{} of block \"{}\" is not a finite number at {:.6g} s (step {})", what,
                              step.model.blocks[b].name, time_s, step.counts.steps + 1));
}

void require_finite(const StepWorkspace& step, double time_s) {
  const auto finite = [&](std::size_t b) {
    return step.state.blocks[b].displacement.allFinite() && step.state.blocks[b].velocity.allFinite();
  };
  if (all_of(step.model.blocks.size(), finite)) return;
  for (std::size_t b = 0; b < step.model.blocks.size(); ++b) {
    if (!finite(b)) refuse_number(step, b, "the displacement", time_s);
  }
}

void require_finite_loads(const StepWorkspace& step, double time_s) {
  for (std::size_t b = 0; b < step.model.blocks.size(); ++b) {
    if (!step.trial.external[b].allFinite()) refuse_number(step, b, "the load", time_s);
  }
}

void require_numbers(const StepWorkspace& step, const IslandEquations& s) {
  for (const int b : s.island.blocks) {
    if (step.trial.balance[at(b)].hasNaN()) refuse_number(step, at(b), "the force", step.trial.end_s);
  }
}

}  // namespace blockweir::solid
