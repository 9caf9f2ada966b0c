// SPDX-License-Identifier: GPL-3.0-or-later
// One item of a study: the outcome of a scene with some settings, computed by a process of an engine.
#pragma once

#include <string>

#include "bridge/engine/engine.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {

/// Settings and result of a run: settings, outcome, mode, joint, level_m, head_m, time_s, sliding_factor, factor
/// (of safety, if requested), simulated_s, wall_time_s; and trouble, if it gave no answer. Missing figures are
/// null.
using Outcome = nlohmann::json;

/// An outcome without an answer: "refused" or "stopped", and the reason.
Outcome troubled(const char* outcome, const std::string& trouble);

/// False for a run that was killed or broke off. A refused scene counts as an answer.
bool has_answer(const Outcome& outcome);

/// The work of an engine for all studies. With "by" = "check": see check_worker(). Otherwise `common` has "scene",
/// "settings" of all runs, "by" ("run", "factor", "limit" or "statics") and "until_decided": a run that ends in motion
/// is continued longer. Each item has its own "settings".
engine::Worker study_worker(const nlohmann::json& common);

}  // namespace blockweir::study
