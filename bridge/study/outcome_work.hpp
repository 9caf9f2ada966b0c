// SPDX-License-Identifier: GPL-3.0-or-later
// One item of a study: the outcome of a scene with some settings, found in a process of an engine.
#pragma once

#include <string>

#include "bridge/engine/engine.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {

/// What a run was set to and how it ended: settings, outcome, mode, joint, level_m, head_m, time_s, sliding_factor,
/// factor (of safety, where that is asked for), simulated_s, wall_time_s; trouble where it gave no answer. A figure
/// that it has not is null.
using Outcome = nlohmann::json;

/// One without an answer: "refused" or "stopped", and why.
Outcome troubled(const char* outcome, const std::string& trouble);

/// False of a run that was killed or broke off: of it nothing is known. That a scene is refused is an answer.
bool has_answer(const Outcome& outcome);

/// What all studies have their engines do. Of "by" = "check": see check_worker(). Else of "scene", "settings" that hold
/// for all, "by" ("run", "factor", "limit" or "statics") and "until_decided": a run that ends on the move is made
/// longer. Each item has its own "settings".
engine::Worker study_worker(const nlohmann::json& common);

}  // namespace blockweir::study
