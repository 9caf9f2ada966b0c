// SPDX-License-Identifier: GPL-3.0-or-later
// Usual magnitudes of what scenes state, and what a value beyond them likely is: one table.
#pragma once

#include <toml++/toml.h>
#include <limits>
#include <span>

#include "bridge/scene/read/problems.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// A number that some sections of a file state. 0 is never unusual: it switches off what it is of, or is an error.
struct Magnitude {
  const char* section;  ///< "material.*": each table in it; "joints[]": each of the list
  const char* key;
  const char* unit;
  double least;
  double most;
  const char* slip;              ///< what a value beyond likely is
  bool grows_with_size = false;  ///< the least of a structure of L < 10 m is L/10 m of `least`: models have less stress
};

std::span<const Magnitude> magnitudes();

/// Warns of numbers beyond their usual magnitudes, and of times, levels, lengths and gaps that are unusual beside each
/// other. The scene is sound.
void check_magnitudes(const toml::table& file, const Scene& scene, Problems& problems);

/// Warns of faces beside each other that are nearly, but not quite, in touch while a structure begins at rest.
void check_gaps(const Scene& scene, Problems& problems);

/// Warns of levels that change faster than a wave runs, and of tailwater above headwater.
void check_levels(const toml::table& file, const Scene& scene, Problems& problems);

}  // namespace blockweir::scene
