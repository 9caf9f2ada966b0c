// SPDX-License-Identifier: GPL-3.0-or-later
// The figures that a scene may expect, and the formulas that yield them: their names, what each speaks of and what it
// needs of the scene. How they are computed is the solid's (solid/expect): a scene is refused for a wrong one before
// anything runs.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace blockweir::scene {

/// What `of` names. A joint stands for its upper block where a block is asked for, but not in formulas.
enum class Subject { none, block, block_if_any, block_only, joint, bolt, arch };

/// What the scene must hold beside that.
enum class Need { nothing, water, upstream_level, face_pressure, column };

struct Answer {
  const char* name;
  Subject of = Subject::none;
  Need needs = Need::nothing;
  bool at_point = false;  ///< `at_m`
  bool word = false;      ///< a word, no number
  /// Limit equilibrium of the block above a joint alone: it carries no other, and no water is downstream of it.
  bool one_block = false;
};

/// `quantity` of [[expect]] and of studies.
std::span<const Answer> quantities();
/// `formula` of these.
std::span<const Answer> formulas();
/// Null where there is none of that name.
const Answer* find_answer(std::span<const Answer> answers, const std::string& name);

std::vector<std::string> quantity_names();
std::vector<std::string> formula_names();

}  // namespace blockweir::scene
