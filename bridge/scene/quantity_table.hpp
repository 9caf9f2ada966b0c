// SPDX-License-Identifier: GPL-3.0-or-later
// The quantities that a scene may expect, and the formulas that give them: names, what they refer to, what they need.
// Their values are computed in solid/expect. The table is here so that a scene with a wrong name is refused before the
// run.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace blockweir::scene {

/// What `of` names. Where a block is needed, a joint means its upper block, except in formulas.
enum class Subject { none, block, block_if_any, block_only, joint, bolt, arch };

/// What else the scene must contain.
enum class Need { nothing, water, upstream_level, face_pressure, column };

/// A row of both tables: a quantity, or a formula.
struct QuantityEntry {
  const char* name;
  Subject of = Subject::none;
  Need needs = Need::nothing;
  bool at_point = false;  ///< `at_m`
  bool word = false;      ///< the value is a word, not a number
  /// Needs limit equilibrium of one block above a joint: the block carries no other, and no water is downstream of it.
  bool one_block = false;
};

/// Values of `quantity` in [[expect]] and in studies.
std::span<const QuantityEntry> quantities();
/// Values of `formula` in the same tables.
std::span<const QuantityEntry> formulas();
/// Null if there is none of that name.
const QuantityEntry* find_entry(std::span<const QuantityEntry> table, const std::string& name);

std::vector<std::string> quantity_names();
std::vector<std::string> formula_names();

}  // namespace blockweir::scene
