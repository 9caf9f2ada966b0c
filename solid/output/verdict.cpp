// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/scene/at.hpp"
#include "bridge/scene/constant_loads.hpp"
#include "bridge/scene/loose_blocks.hpp"
#include "solid/output/block_names.hpp"
#include "solid/output/breach.hpp"
#include "solid/output/level_doubt.hpp"
#include "solid/output/rest_text.hpp"
#include "solid/watch/joint_name.hpp"
#include "solid/watch/oscillations.hpp"
#include "solid/watch/surfaces.hpp"

namespace blockweir::solid::output {
namespace {

using nlohmann::json;

std::string failure_text(const Solid& solid, const Failure& f) {
  const bool one = f.blocks.size() == 1;
  std::string text = fmt::format("{} {} by {}", block_names(solid, f.blocks), one ? "fails" : "fail together", f.mode);
  // As limit analysis says it: on what bears, and what opens.
  if (!f.turns_on.empty()) return text + fmt::format(" on joint \"{}\"; joint \"{}\" opens", f.turns_on, f.joint);
  const bool leaves = f.mode == "lifting" || f.mode == "falling";
  if (!f.joint.empty()) text += fmt::format(" {} joint \"{}\"", leaves ? "off" : "on", f.joint);
  return text;
}

/// Of those that failed apart from the first body.
std::string others_text(std::size_t count) {
  if (count == 0) return {};
  return fmt::format(", and {} more block{} after it", count, count == 1 ? "" : "s");
}

/// What is below it at the run's end has no ground to come to.
double lowest_point_m(const scene::Scene& scene) {
  double lowest_m = std::numeric_limits<double>::infinity();
  for (const scene::Block& block : scene.blocks) {
    for (const scene::Point& p : block.vertices) lowest_m = std::min(lowest_m, p.y());
  }
  return lowest_m;
}

/// Has a block that failed before any breach?
bool have_left(const expect::Outcome& o) {
  const double lowest_m = lowest_point_m(o.solid.scene());
  const auto& failures = o.failure.failures();
  return std::any_of(failures.begin(), failures.end(), [&](const Failure& f) {
    return !is_after_breach(o, f) && std::any_of(f.blocks.begin(), f.blocks.end(),
                                                 [&](int b) { return o.last.blocks[at(b)].centroid_m.y() < lowest_m; });
  });
}

json failure(const expect::Outcome& o) {
  const Failure& first = o.failure.failures().front();
  json names = json::array();
  for (const Failure& f : o.failure.failures()) {
    if (is_after_breach(o, f)) continue;  // the breach tells of it
    for (const int block : f.blocks) names.push_back(o.solid.blocks()[at(block)].name);
  }
  // NaN (no pool) becomes null.
  json found = {{"level_m", first.level_m},
                {"pool", first.downstream ? "downstream" : "upstream"},
                {"level_falls", first.falls},
                {"head_m", first.head_m},
                {"level_is_bound", first.bound},
                {"level_is_constant", scene::level_is_constant(o.solid.scene(), first.downstream)},
                {"level_uncertainty_m", first.level_uncertainty_m},
                {"time_s", first.time_s},
                {"mode", first.mode},
                {"joint", first.joint},
                {"turns_on", first.turns_on},
                {"blocks", names},
                {"text", failure_text(o.solid, first) + others_text(names.size() - first.blocks.size())}};
  std::string text = level_doubt(o.solid.scene(), first);
  if (o.solid.scene().analysis.kind == scene::AnalysisKind::dynamic && o.failure.rests_again()) {
    constexpr double small_ratio = 0.05;  // of the structure: what moves farther has fallen
    const double farthest_m = o.failure.farthest_failed_m();
    const bool is_small = farthest_m <= small_ratio * o.solid.model().size_m;
    text += fmt::format(
        "{}the blocks that failed came to rest again before the run ended, at most {:.3g} m from where they were "
        "drawn{}",
        text.empty() ? "" : "; ", farthest_m,
        is_small ? ": if that is acceptable, state a larger failure_displacement_m" : "");
  }
  constexpr double far_ratio = 10;  // of the structure
  if (const double farthest_m = o.failure.farthest_failed_m(counted_until_s(o));
      farthest_m > far_ratio * o.solid.model().size_m && have_left(o)) {
    text += fmt::format(
        "{}blocks that failed have left the model, and were {:.3g} m from where they were drawn when the run ended: "
        "stop_at_failure = true, or a shorter duration_s, ends it sooner",
        text.empty() ? "" : "; ", farthest_m);
  }
  if (!o.failure.failed()) {
    text += fmt::format("{}only crumbs of the drawing have failed: nothing else moves", text.empty() ? "" : "; ");
  }
  if (!text.empty()) found["doubt"] = text;
  const scene::Analysis& analysis = o.solid.scene().analysis;
  if (analysis.kind == scene::AnalysisKind::quasi_static && !analysis.stop_at_failure && o.failure.failed()) {
    found["end"] = "the run ended there: a quasi-static analysis does not follow a fall; kind = \"dynamic\" does";
  }
  return found;
}

/// A run that ends while something moves has not shown that the structure stands.
json moving(const Solid& solid, const Moving& m, bool unheld) {
  const std::string& name = solid.blocks()[at(m.block)].name;
  const std::string text =
      unheld
          ? "no forces within the joints' laws hold these blocks where they are, though they have not moved off: the "
            "load exceeds what they bear by too little for these steps; it does not stand; find by how much with "
            "\"blockweir level SCENE\" or \"blockweir safety SCENE\""
          : fmt::format(
                "block \"{}\" moved at {:.3g} m/s when the run ended, {:.3g} m from where it last stood: "
                "whether it stands is not decided; lengthen duration_s",
                name, m.speed_m_per_s, m.travel_m);
  return {{"block", name},
          {"speed_m_per_s", m.speed_m_per_s},
          {"travel_m", m.travel_m},
          {"unheld", unheld},
          {"text", text}};
}

/// Was the lowest sliding factor one of an oscillation, which has died down under loads that did not change? The factor
/// that is left then, in words; empty else. Ground that shakes has no other minimum.
std::string transient_text(const expect::Outcome& o) {
  constexpr double seen = 0.01;        // of the factor
  constexpr double same_level = 1e-3;  // of the structure
  const auto& lowest = o.margins.sliding();
  const auto& now = o.margins.sliding_now();
  const scene::Scene& scene = o.solid.scene();
  if (!lowest || !now || scene.base_motion || scene.analysis.kind == scene::AnalysisKind::at_rest) return {};
  const bool level_changed = std::abs(now->level_m - lowest->level_m) > same_level * 2 * o.solid.model().size_m;
  if (level_changed || now->value < (1 + seen) * lowest->value) return {};
  const char* cause = anything_strains(o.solid)
                          ? "that of an oscillation, as after the start; with kind = \"static\" there is none"
                          : "that of a motion, or of other forces that hold the same rigid blocks";
  return fmt::format("; under the same level it is {:.4g} at the end: the lowest is {}", now->value, cause);
}

json margin(const expect::Outcome& o) {
  const auto place = [](const Margin& m) {
    return fmt::format(" joint \"{}\" at {:.4g} s", m.joint, m.time_s) +
           (std::isnan(m.level_m) ? "" : fmt::format(", level {:.5g} m", m.level_m));
  };
  json found;
  std::string text =
      o.margins.buttressed()    ? "no sliding factor: blocks downstream support every surface that carries shear"
      : o.margins.any_surface() ? "no surface that runs through carries shear"
                                : "no sliding factor: no joint, and no line of joints, runs through the structure";
  if (const auto& m = o.margins.sliding()) {
    found = {{"sliding_factor", m->value}, {"joint", m->joint}, {"level_m", m->level_m}, {"time_s", m->time_s}};
    text = fmt::format("lowest sliding factor {:.4g} on", m->value) + place(*m) + transient_text(o);
  }
  if (const auto& m = o.margins.overturning()) {
    found["overturning"] = {{"end_distance", m->value},
                            {"end", m->end},
                            {"joint", m->joint},
                            {"level_m", m->level_m},
                            {"time_s", m->time_s}};
    const bool held = !m->held_by.empty();
    text += held ? fmt::format("; resultant at or beyond the {} end of", m->end)
                 : fmt::format("; resultant nearest to an end (0: overturns): {:.4g} of the length from the {} end of",
                               m->value, m->end);
    text += place(*m);
    if (held) {
      found["overturning"]["held_by"] = m->held_by;
      text += ": held by " + m->held_by;
    }
  }
  if (const std::vector<std::string> bent = bent_joints(o.solid); bent.size() == 1) {
    text += fmt::format("; joint \"{}\" bends and has neither: safety finds its margin", bent.front());
  } else if (!bent.empty()) {
    text += fmt::format("; joint \"{}\" and {} more bend and have neither: safety finds their margin", bent.front(),
                        bent.size() - 1);
  }
  const ContactRow* slipped = nullptr;
  const auto is_loose = [&](int b) {
    return std::binary_search(o.failure.loose().begin(), o.failure.loose().end(), b);
  };
  for (const ContactRow& c : o.last.contacts) {
    if (is_loose(c.vertex_block) || is_loose(c.edge_block)) continue;  // their verdict is not asked for
    if (slipped == nullptr || std::abs(c.slip_m) > std::abs(slipped->slip_m)) slipped = &c;
  }
  constexpr double of_failure = 0.1;  // what strains slips by less
  constexpr double of_size = 1e-3;    // seen also where a failure is stated to be more
  const double seen_m =
      std::min(of_failure * o.solid.scene().analysis.failure_displacement_m, of_size * o.solid.model().size_m);
  if (slipped != nullptr && std::abs(slipped->slip_m) > seen_m) {
    const std::string joint = joint_name(o.solid, slipped->vertex_block, slipped->edge_block);
    found["slip_m"] = std::abs(slipped->slip_m);
    found["slip_joint"] = joint;
    text += fmt::format("; it has slipped by {:.3g} m on joint \"{}\"", std::abs(slipped->slip_m), joint);
  }
  if (o.failure.judges_none()) text = "nothing was judged: all blocks that could fail fall from the start";
  found["text"] = text;
  return found;
}

/// A pool whose level at the end has not acted: a window holds the level that it begins with.
void add_levels_not_reached(const expect::Outcome& o, json& text) {
  const scene::Scene& scene = o.solid.scene();
  if (!scene::still_pools(scene.fluid) || o.last.time_s < scene.analysis.duration_s) return;
  const auto look = [&](const char* pool, const std::optional<scene::TimeTable>& table, double acted_m) {
    constexpr double far = 1e-3;  // of the structure
    if (!table || std::isnan(acted_m)) return;
    const double end_m = table->at(scene.analysis.duration_s);
    if (std::abs(end_m - acted_m) <= far * 2 * o.solid.model().size_m) return;
    text["last_levels_acted"] = false;
    text["warnings"].push_back(
        fmt::format("the run ends before the last {} level, {:.6g} m, has acted: the last window used {:.6g} m; "
                    "shorten window_s, or hold the level for a while",
                    pool, end_m, acted_m));
  };
  look("upstream", scene.water.upstream_level_m, o.last.upstream_level_m);
  look("downstream", scene.water.downstream_level_m, o.last.downstream_level_m);
}

/// The outcome (stands, fails or moving) with its data.
void add_outcome(const expect::Outcome& outcome, json& text) {
  if (!outcome.failure.failures().empty()) {
    text["outcome"] = "fails";
    text["failure"] = failure(outcome);
  } else {
    const auto still = outcome.failure.moving();
    text["outcome"] = still ? "moving" : "stands";
    if (still) text["moving"] = moving(outcome.solid, *still, outcome.failure.unheld());
    text["margin"] = margin(outcome);
    add_levels_not_reached(outcome, text);
  }
}

/// A static analysis that finds no equilibrium, and no failure, has stopped.
void add_rest(const expect::Outcome& outcome, json& text) {
  if (outcome.solid.scene().analysis.kind != scene::AnalysisKind::at_rest) return;
  const Rest& rest = outcome.solid.state().rest;
  const auto steps = outcome.solid.counts().steps;
  text["rest"] = {{"found", rest.found}, {"unbalanced_ratio", rest.unbalanced}, {"steps", steps}};
  text["rest"]["text"] = rest_text(rest, steps, outcome.solid.scene().analysis, outcome.last.largest_displacement_m);
  if (!rest.found && outcome.failure.failures().empty()) {
    text["outcome"] = "stopped";
    text["stopped"] = text["rest"]["text"];
  }
}

/// Where the loose blocks are at the run's end: the ground may have ended below them.
std::string loose_end_text(const expect::Outcome& o) {
  const double lowest_m = lowest_point_m(o.solid.scene());
  const auto& loose = o.failure.loose();
  const auto gone =
      std::count_if(loose.begin(), loose.end(), [&](int b) { return o.last.blocks[at(b)].centroid_m.y() < lowest_m; });
  const double slow = o.solid.scene().analysis.failure_displacement_m;  // m/s: what rocks at its place is slower
  const auto moving = std::count_if(
      loose.begin(), loose.end(), [&](int b) { return o.last.blocks[at(b)].centroid_velocity_m_per_s.norm() > slow; });
  std::string text;
  if (gone > 0) text += fmt::format("; at the end {} had left the model, below its lowest point", gone);
  if (moving > gone) text += fmt::format("{} {} of them moved", gone > 0 ? ", and" : "; at the end", moving);
  return text;
}

void add_loose(const expect::Outcome& outcome, json& text) {
  const std::vector<int>& loose = outcome.failure.loose();
  if (loose.empty()) return;
  json names = json::array();
  for (const int b : loose) names.push_back(outcome.solid.blocks()[at(b)].name);
  text["loose"] = {{"blocks", names},
                   {"text", scene::loose_text(outcome.solid.scene(), loose) +
                                ", as nothing holds what the scene draws there: the verdict is that of the others" +
                                loose_end_text(outcome)}};
}

}  // namespace

void add_verdict(const expect::Outcome& outcome, json& text) {
  add_outcome(outcome, text);
  add_rest(outcome, text);
  add_breach(outcome, text);
  add_loose(outcome, text);
}

}  // namespace blockweir::solid::output
