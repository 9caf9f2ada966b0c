// SPDX-License-Identifier: GPL-3.0-or-later
// Results of a run that are words: the mode of failure, and the mode that a formula predicts.
#pragma once

#include <string>
#include <vector>

#include "solid/expect/quantities.hpp"

namespace blockweir::solid::expect {

/// Whether this quantity is a word, not a number.
bool is_label(const std::string& quantity);

/// "invariants": "hold", or "energy made" if a run produced more than 1e-5 of its energy and of that of a fall by the
/// model's size, or "in each other" if blocks overlapped by more than 1e-4 of the model's size and what corners may
/// pass over where blocks strain or contacts are springs. "stability": "grows" if
/// the exchange produces energy, otherwise "stable". "mode": failure mode of the block (for a joint: the upper one), or
/// of the first failure if `of` is empty; "moving" if blocks moved at the run's end; otherwise "stands".
std::string label(const Outcome& outcome, const scene::Expectation& expectation);

std::vector<std::string> label_quantity_names();
std::vector<std::string> label_formula_names();

/// The word of `expectation.formula` for this scene. Throws std::runtime_error if there is no such formula, or if the
/// scene lacks what the formula refers to.
std::string word_formula(const scene::Scene& scene, const scene::Expectation& expectation);

}  // namespace blockweir::solid::expect
