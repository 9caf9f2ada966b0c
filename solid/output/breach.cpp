// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/breach.hpp"

#include <fmt/format.h>

#include <limits>

#include "bridge/scene/at.hpp"
#include "solid/output/block_names.hpp"

namespace blockweir::solid::output {
namespace {

double drawn_crest_m(const scene::Scene& scene) {
  Eigen::AlignedBox2d all;
  for (const scene::Block& block : scene.blocks) {
    for (const scene::Point& p : block.vertices) all.extend(p);
  }
  return all.max().y();
}

/// Whether pressures of still water have outlived it: from the breach on they are not those of the water.
bool ends_still_water(const expect::Outcome& outcome) {
  return outcome.breach && outcome.solid.scene().fluid != scene::FluidModel::openfoam;
}

}  // namespace

double counted_until_s(const expect::Outcome& outcome) {
  const auto& failures = outcome.failure.failures();
  const bool made_it =
      ends_still_water(outcome) && !failures.empty() && failures.front().time_s < outcome.breach->time_s;
  return made_it ? outcome.breach->time_s : std::numeric_limits<double>::infinity();
}

bool is_after_breach(const expect::Outcome& outcome, const Failure& failure) {
  return failure.time_s >= counted_until_s(outcome);
}

void add_breach(const expect::Outcome& outcome, nlohmann::json& text) {
  if (!outcome.breach) return;
  const Breach& breach = *outcome.breach;
  std::string how = "open water passes the structure";
  if (breach.level_m > breach.crest_m && breach.level_m <= drawn_crest_m(outcome.solid.scene())) {
    how = fmt::format("water at a level of {:.4g} m flows over the crest, which has sunk to {:.4g} m", breach.level_m,
                      breach.crest_m);
  }
  if (ends_still_water(outcome)) {
    how += outcome.solid.scene().analysis.stop_at_breach
               ? "; from then on water would flow: the run ends here"
               : "; from then on water would flow. The run keeps the pressures of still water, so where blocks come to "
                 "rest is no answer (stop_at_breach ends it here)";
  }
  std::vector<int> later;
  for (const Failure& f : outcome.failure.failures()) {
    if (is_after_breach(outcome, f)) later.insert(later.end(), f.blocks.begin(), f.blocks.end());
  }
  nlohmann::json names = nlohmann::json::array();
  for (const int b : later) names.push_back(outcome.solid.blocks()[at(b)].name);
  if (!later.empty()) {
    how += fmt::format("; after the breach {} also move{}, by these pressures", block_names(outcome.solid, later),
                       later.size() == 1 ? "s" : "");
  }
  text["breach"] = {{"time_s", breach.time_s}, {"crest_m", breach.crest_m}, {"blocks_after", names}, {"text", how}};
}

}  // namespace blockweir::solid::output
