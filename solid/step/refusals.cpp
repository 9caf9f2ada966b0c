// SPDX-License-Identifier: GPL-3.0-or-later
// Steps that cannot be made, and numbers that are none: what is said of them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "bridge/scene/at.hpp"
#include "solid/block/parallel.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

void Solid::refuse_step(double time_s, double dt, Outcome last) const {
  if (last == Outcome::too_far) {
    throw SolveError(
        fmt::format("at {:.6g} s blocks move by more than [analysis] max_displacement_ratio, or turn by more than a "
                    "search of contacts follows, even in a step of {:.3g} s; are velocities and loads in their units?",
                    time_s, dt));
  }
  throw SolveError(
      fmt::format("the contact states did not settle at {:.6g} s, even with a step of {:.3g} s; a smaller [analysis] "
                  "step_s or a larger [contact] max_iterations may help",
                  time_s, dt));
}

/// A block that is strained as no solid is: its modulus or its size is in other units.
void Solid::require_small_strains() const {
  constexpr double most = 0.2;
  for (std::size_t b = 0; b < described(); ++b) {
    const double strain = states_[b].displacement.tail<3>().cwiseAbs().maxCoeff();
    if (strain <= most) continue;
    const scene::Material& material = scene_.materials[at(scene_.blocks[b].material)];
    Box box;
    for (const Point& vertex : blocks_[b].vertices) box.extend(vertex);
    const double own = material.density_kg_per_m3 * scene_.analysis.gravity_m_per_s2 * box.sizes().y();
    throw SolveError(fmt::format(
        "block \"{}\" (line {}) is too soft: the first loads strain it by {:.3g}, above {:.3g}; its weight over its "
        "height of {:.4g} m alone strains its base by density x gravity x height / modulus = {:.3g}; are "
        "youngs_modulus_pa = {:.4g} of material \"{}\" in Pa, density_kg_per_m3 = {:.4g} in kg/m3 and all lengths in "
        "m?",
        blocks_[b].name, scene_.blocks[b].line, strain, most, box.sizes().y(), own / material.youngs_modulus_pa,
        material.youngs_modulus_pa, material.name, material.density_kg_per_m3));
  }
}

/// What the last try of a start left open: where blocks still move, and which of them do not fit onto each other.
void Solid::refuse_start(int steps, Outcome last) const {
  const bool too_far = last == Outcome::too_far;
  std::string text =
      fmt::format("no equilibrium under the first loads was found with all joints held ({} steps)", steps);
  const auto moved = [this](std::size_t b) {
    double most = 0;
    for (const Point& X : blocks_[b].vertices) most = std::max(most, start_[b].increment(increment_[b], X).norm());
    return most;
  };
  std::size_t farthest = 0;
  for (std::size_t b = 1; b < blocks_.size(); ++b) {
    if (moved(b) > moved(farthest)) farthest = b;
  }
  text +=
      fmt::format("; block \"{}\" moves most, by {:.3g} m in the last try", blocks_[farthest].name, moved(farthest));
  if (too_far) text += ", which is more than [analysis] max_displacement_ratio lets a step";
  const ContactPoint* worst = nullptr;
  double apart = 0;
  double overlap = 0;
  for (const ContactPoint& c : contacts_) {
    if (c.state == ContactState::open) continue;
    overlap = std::max(overlap, -(c.gap + c.gap_at_start));
    const double now = separation_of(trial(), c, edge_frame(trial(), c)).value.norm();
    if (worst != nullptr && now <= apart) continue;
    worst = &c;
    apart = now;
  }
  if (worst != nullptr) {
    const Point where = place(*worst);
    text += fmt::format(
        "; blocks \"{}\" and \"{}\" fit least, at ({:.6g}, {:.6g}) they are {:.3g} m from where they were joined; the "
        "largest overlap in the scene is {:.3g} m",
        blocks_[at(worst->vertex_block)].name, blocks_[at(worst->edge_block)].name, where.x(), where.y(), apart,
        overlap);
  }
  throw SolveError(text + "; " + start_advice(too_far || steps >= most_settling_steps, overlap));
}

/// What helps: a start without stress lets go what is on its way, and finds no states that this one does not find.
std::string Solid::start_advice(bool moves_on, double overlap_m) const {
  if (moves_on) {
    const bool rests = scene_.analysis.kind == scene::AnalysisKind::at_rest;  // where nothing is on its way
    return std::string("what holds it? Give it a support, a bolt or a face to stand on") +
           (rests ? "" : ", or set [analysis] start = \"unstressed\" if it is meant to move from the start");
  }
  if (overlap_m > 1e-6 * size_) return "mend the outlines that overlap";
  return fmt::format("a larger [contact] max_iterations than {} may help", scene_.contact.max_iterations);
}

void Solid::refuse(std::size_t b, const char* what, double time_s) const {
  throw NotFinite(fmt::format("{} of block \"{}\" is not a finite number at {:.6g} s (step {})", what, blocks_[b].name,
                              time_s, counts_.steps + 1));
}

void Solid::require_finite(double time_s) const {
  const auto finite = [this](std::size_t b) {
    return states_[b].displacement.allFinite() && states_[b].velocity.allFinite();
  };
  if (all_of(blocks_.size(), finite)) return;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (!finite(b)) refuse(b, "the displacement", time_s);
  }
}

void Solid::require_finite_loads(double time_s) const {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (!external_[b].allFinite()) refuse(b, "the load", time_s);
  }
}

/// Forces that overflow may do so for too long a step; those that are no numbers end the run.
void Solid::require_numbers(const IslandSystem& s) const {
  for (const int b : s.island.blocks) {
    if (balance_[static_cast<std::size_t>(b)].hasNaN()) refuse(static_cast<std::size_t>(b), "the force", end_s_);
  }
}

}  // namespace blockweir::solid
