// SPDX-License-Identifier: GPL-3.0-or-later
// What is held against an answer, as work for an engine: runs of a case with the figures that it states, also those of
// a bench, and studies with an answer, each as a whole.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "bridge/engine/engine.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {

/// One run: answered by "trouble", "checks" and "wall_time_s".
nlohmann::json run_item(const std::filesystem::path& scene, const std::string& variant, const Settings& overrides);

/// One setting of a bench: answered as run_item() is, with "energy_gain", and where its motion is asked for with
/// "simulated_s" and "ways": see ways_of().
nlohmann::json bench_item(const std::filesystem::path& scene, const Settings& overrides, bool inproc, bool motion);

/// One study: answered by what study_result() reads. `brief`: of a map only the first, the middle and the last values.
/// `told`: each of its runs is told on standard error.
nlohmann::json study_item(const std::filesystem::path& scene, const std::string& name, const Settings& overrides,
                          bool brief, bool told);

/// From the answer to a study_item(); null: its process was killed.
StudyResult study_result(const nlohmann::json& answer);

/// Does any of them.
engine::Worker check_worker();

/// A map with only the first, the middle and the last values.
scene::MapStudy thinned(scene::MapStudy map);

/// Has all done; `taken` gets the answers in the order of the items, each as soon as it and those before it are there.
/// Throws Interrupted.
void perform_in_order(engine::Engine& engine, const engine::Work& work, const engine::Heard& taken);

}  // namespace blockweir::study
