// SPDX-License-Identifier: GPL-3.0-or-later
// Usual magnitudes of the numbers in a scene, and the probable mistake when a number is outside: one table.
#pragma once

#include <toml++/toml.h>
#include <limits>
#include <span>
#include <string>

#include "bridge/scene/read/problems.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// A unit in which the value may have been given by mistake, and its size in the key's unit.
struct Unit {
  const char* name;
  double size;
};

/// Usual range of a key in some sections of a file. 0 is never unusual: it switches an effect off, or is an error.
struct Magnitude {
  const char* section;  ///< "material.*": each table in it; "joints[]": each of the list
  const char* key;
  const char* unit;
  double least;
  double most;
  Unit units[3];                 ///< in which an unusual value may have been given, the likeliest first
  const char* remark = "";       ///< further advice
  bool grows_with_size = false;  ///< structures of L < 10 m: `least` is scaled by L/10 m, as models have lower stresses
  bool may_glue = false;         ///< 5e8 to 1e12 is usual, too: what holds blocks together whatever comes
};

std::span<const Magnitude> magnitudes();

/// The probable meaning of a value outside its range: the first of the row's units in which it is usual, and the value
/// to write instead.
std::string likely_meaning(const Magnitude& row, double value);

/// Warns of numbers outside their usual range. Some lower bounds depend on the structure's size; with `size_m` = 0
/// (unknown) they are not checked.
void check_ranges(const toml::table& file, double size_m, Problems& problems);

/// Makes these warnings for a valid scene, and warns of times, levels, lengths and gaps that do not fit each other.
void check_magnitudes(const toml::table& file, const Scene& scene, Problems& problems);

/// Warns of faces that are almost, but not quite, in contact in a structure that starts at rest.
void check_gaps(const Scene& scene, Problems& problems);

/// Warns of loads that are less than a thousandth of the weight of the block that bears them.
void check_small_loads(const toml::table& file, const Scene& scene, Problems& problems);

/// Warns of two or more blocks that touch nothing that holds them, in a structure that starts at rest.
void check_hovering(const Scene& scene, Problems& problems);

/// Warns of blocks that stand on one corner in a structure that starts at rest.
void check_corner_stands(const Scene& scene, Problems& problems);

/// Warns of blocks far smaller than the others, and names the smallest.
void check_crumbs(const Scene& scene, Problems& problems);

/// Warns of parts far larger than the ground below them, or than the water in front of them: probably another unit of
/// length.
void check_proportions(const toml::table& file, const Scene& scene, Problems& problems);

/// Warns of levels that change faster than waves travel or that a run does not see, and of tailwater above headwater.
void check_levels(const toml::table& file, const Scene& scene, Problems& problems);

}  // namespace blockweir::scene
