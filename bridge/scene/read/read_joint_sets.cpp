// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of parallel joints through a section.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/geometry/joint_set.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/read/cuts.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {
namespace {

/// The region that a set of joints is to stay in; null where it may go anywhere.
const Region* read_region(TableReader& table, const std::vector<Region>& regions) {
  Names names("region");
  for (const Region& region : regions) {
    if (!region.name.empty()) names.add(region.name);
  }
  const int found = table.reference("region", names, /*required=*/false);
  const auto is_it = [&](const Region& region) { return found >= 0 && region.name == names.list()[at(found)]; };
  const auto region = std::find_if(regions.begin(), regions.end(), is_it);
  return region == regions.end() ? nullptr : &*region;
}

}  // namespace

void read_joint_sets(Reading& reading, const geometry::Bounds& bounds, const std::vector<Region>& regions, Cuts& cuts) {
  reading.each("joint_set", [&](TableReader& table) {
    geometry::JointSet set;
    std::string name;
    JointLaw law = reading.scene.default_joint;
    table.text("name", name, true);
    table.number("dip_deg", set.dip_deg, {[](double d) { return d >= -90 && d <= 90; }, "an angle from -90 to 90"},
                 true);
    const bool spaced = table.number("spacing_m", set.spacing_m, positive(), true);
    table.number("offset_m", set.offset_m, {[](double o) { return std::abs(o) <= 1e7; }, "a number within 1e7"});
    table.number("persistence", set.persistence,
                 {[](double p) { return p > 0 && p <= 1; }, "a number above 0, up to 1"});
    table.number("trace_length_m", set.trace_length_m, positive(), set.persistence < 1);
    table.number("spacing_deviation", set.spacing_deviation,
                 {[](double d) { return d >= 0 && d <= 1; }, "a number from 0 to 1"});
    int seed = 1;
    if (table.integer("seed", seed, 0)) set.seed = static_cast<std::uint64_t>(seed);
    bool own_residual = reading.residual_given;
    read_law(table, law, reading, own_residual);
    check_law(table, law, reading, /*of_all=*/false);
    const Region* region = read_region(table, regions);
    const int id = cuts.add(name, law, source_of(table, set.persistence < 1));
    const double length = 2 * bounds.size();
    const double shortest = set.persistence < 1 ? std::max(set.trace_length_m, 1e-9 * length) : length;
    // There is at least one line, and one to either side that may reach into the section when it lies off.
    const double count = (length / set.spacing_m + 3) * std::max(1.0, length / shortest);
    if (!spaced || (set.persistence < 1 && set.trace_length_m <= 0)) return;
    if (count > static_cast<double>(most_cut_lines)) {
      reading.problems.error(
          table.place("spacing_m"), fmt::format("{} would draw about {:.3g} joints", table.name(), count),
          fmt::format("at most {} in a section", most_cut_lines), "make spacing_m or trace_length_m larger");
      return;
    }
    for (geometry::Line& line : geometry::joints_of(set, bounds.low, bounds.high, id)) {
      if (region == nullptr) {
        cuts.lines.push_back(std::move(line));
        continue;
      }
      constexpr double beyond = 1e-7;  // of the section's size; dangling ends are removed
      for (geometry::Line& part : geometry::parts_within(line, region->outline, beyond * bounds.size())) {
        cuts.lines.push_back(std::move(part));
      }
    }
  });
}

}  // namespace blockweir::scene
