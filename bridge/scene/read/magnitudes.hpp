// SPDX-License-Identifier: GPL-3.0-or-later
// Usual magnitudes of what scenes state, and what a value beyond them likely is: one table.
#pragma once

#include <toml++/toml.h>
#include <limits>
#include <span>
#include <string>

#include "bridge/scene/read/problems.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// A unit in which the value may have been written, and its size in the key's own.
struct Unit {
  const char* name;
  double size;
};

/// A number that some sections of a file state. 0 is never unusual: it switches off what it is of, or is an error.
struct Magnitude {
  const char* section;  ///< "material.*": each table in it; "joints[]": each of the list
  const char* key;
  const char* unit;
  double least;
  double most;
  Unit units[3];                 ///< that a value beyond may be written in, the likeliest first
  const char* remark = "";       ///< what else to say of it
  bool grows_with_size = false;  ///< the least of a structure of L < 10 m is L/10 m of `least`: models have less stress
};

std::span<const Magnitude> magnitudes();

/// What a value beyond its magnitude likely is: the first of the row's units in which it is usual, and the value to
/// write.
std::string likely_meaning(const Magnitude& row, double value);

/// Warns of numbers beyond their usual magnitudes. Some are smaller in a small structure: at 0 m, where its size is not
/// known, these are never too small.
void check_ranges(const toml::table& file, double size_m, Problems& problems);

/// Warns of those, and of times, levels, lengths and gaps that are unusual beside each other. The scene is sound.
void check_magnitudes(const toml::table& file, const Scene& scene, Problems& problems);

/// Warns of faces beside each other that are nearly, but not quite, in touch while a structure begins at rest.
void check_gaps(const Scene& scene, Problems& problems);

/// Warns of what is far larger than the ground that it stands on, or than the water before it: coordinates in another
/// unit.
void check_proportions(const toml::table& file, const Scene& scene, Problems& problems);

/// Warns of levels that change faster than a wave runs, that a run does not see, and of tailwater above headwater.
void check_levels(const toml::table& file, const Scene& scene, Problems& problems);

}  // namespace blockweir::scene
