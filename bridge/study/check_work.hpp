// SPDX-License-Identifier: GPL-3.0-or-later
// Comparisons with stated results, as work for an engine: runs of a case with its expected figures, runs of a bench,
// and whole studies.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "bridge/engine/engine.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {

/// One run; its answer has "trouble", "checks" and "wall_time_s".
nlohmann::json run_item(const std::filesystem::path& scene, const std::string& variant, const Settings& overrides);

/// One setting of a bench; its answer is that of run_item() with "energy_gain", and, for a bench on motion, with
/// "simulated_s" and "ways": see ways_of().
nlohmann::json bench_item(const std::filesystem::path& scene, const Settings& overrides, bool inproc, bool motion);

/// One study; study_result() reads its answer. `brief`: of a map only the first, the middle and the last values.
/// `reported`: reports each run on standard error.
nlohmann::json study_item(const std::filesystem::path& scene, const std::string& name, const Settings& overrides,
                          bool brief, bool reported);

/// The result in the answer to a study_item(); null: its process was killed.
StudyResult study_result(const nlohmann::json& answer);

/// Works on any of these items.
engine::Worker check_worker();

/// A map with only the first, the middle and the last values.
scene::MapStudy thinned(scene::MapStudy map);

/// Works on all items; `taken` gets the answers in the order of the items, each as soon as it and all earlier ones
/// exist. Throws Interrupted.
void perform_in_order(engine::Engine& engine, const engine::Work& work, const engine::OnAnswer& taken);

}  // namespace blockweir::study
