// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of a finished run that are words: how a block fails, and how a formula says that it does.
#pragma once

#include <string>
#include <vector>

#include "solid/expect/quantities.hpp"

namespace blockweir::solid::expect {

/// Is this quantity a word and no number?
bool is_label(const std::string& quantity);

/// "invariants": "hold", or "energy made" where a run made more than 1e-5 of what it had and of what a fall by the
/// model's size has, "in each other" where blocks entered each other by more than 1e-4 of the model's size;
/// "stability": "grows" where the exchange makes energy, else "stable"; "mode": how the block (of a joint: the upper
/// one) fails, or the first that does where none is named; "moving" where blocks moved as the run ended; "stands".
std::string label(const Outcome& outcome, const scene::Expectation& expectation);

std::vector<std::string> label_quantity_names();
std::vector<std::string> label_formula_names();

/// The word of `expectation.formula` for this scene. Throws std::runtime_error when there is no such formula, or the
/// scene has not what it speaks of.
std::string word_formula(const scene::Scene& scene, const scene::Expectation& expectation);

}  // namespace blockweir::solid::expect
