// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/skips.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/results/counted.hpp"
#include "bridge/results/saving.hpp"

namespace blockweir::solid {
namespace {

using nlohmann::json;
using results::saved;

/// Three strains a block. Systems cost at least in proportion to their unknowns.
void rigid_blocks(const Solid& solid, json& list) {
  long rigid = 0;
  long unknowns = 0;
  for (const Block& block : solid.blocks()) {
    if (block.fixed || block.meshed) continue;
    unknowns += block.unknowns();
    rigid += block.rigid ? 1 : 0;
  }
  if (rigid == 0) return;
  const bool found = solid.scene().analysis.rigid == scene::Rigid::automatic;
  const Profile& profile = solid.profile();
  list.push_back(fmt::format("strains of {}: {}{}", results::counted(at(rigid), "block"),
                             found ? "contact forces follow from equilibrium alone, and own strain moves points by "
                                     "less than 1 % of failure_displacement_m"
                                   : "the scene calls them rigid",
                             saved(profile.assembly - profile.contact + profile.solve, unknowns, 3 * rigid)));
}

/// Less what refinement took, and tries of it that failed.
void factorizations(const Counts& counts, const Profile& profile, json& list) {
  if (counts.reused_factorizations == 0) return;
  const double mean_s = profile.factorization / static_cast<double>(std::max(1L, counts.factorizations));
  const double net_s = mean_s * static_cast<double>(counts.reused_factorizations) - profile.refinement;
  list.push_back(
      fmt::format("{} of {} factorizations: earlier factors served{}", counts.reused_factorizations,
                  counts.reused_factorizations + counts.factorizations,
                  net_s >= 0 ? saved(net_s) : fmt::format(", and trying them cost about {:.2g} s more", -net_s)));
}

}  // namespace

json skips(const Solid& solid, const Frames& frames) {
  json list = json::array();
  const Counts counts = solid.counts();
  const Profile& profile = solid.profile();
  rigid_blocks(solid, list);
  if (counts.most_islands > 1) {
    list.push_back(
        fmt::format("one system of all blocks: up to {} groups in contact were solved apart", counts.most_islands));
  }
  if (counts.slept_islands > 0) {
    list.push_back(fmt::format("{} of {} solutions of islands that slept{}", counts.slept_islands,
                               counts.slept_islands + counts.solved_islands,
                               saved(profile.equilibria, counts.solved_islands, counts.slept_islands)));
  }
  if (counts.skipped_searches > 0) {
    list.push_back(fmt::format("{} of {} searches for contacts: nothing had moved{}", counts.skipped_searches,
                               counts.skipped_searches + counts.searches,
                               saved(profile.search, counts.searches, counts.skipped_searches)));
  }
  factorizations(counts, profile, list);
  if (frames.windows_without > 0) {
    list.push_back(fmt::format("frames after {} of {} windows: one in {} s is asked for{}", frames.windows_without,
                               frames.windows_without + frames.written, solid.scene().output.frame_every_s,
                               saved(frames.seconds, frames.written, frames.windows_without)));
  }
  return list;
}

}  // namespace blockweir::solid
