// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/outcome_work.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bridge/process/ask.hpp"
#include "bridge/process/line_program.hpp"
#include "bridge/process/run.hpp"
#include "bridge/process/temporary_folder.hpp"
#include "bridge/scene/diagnostic.hpp"
#include "bridge/scene/read/ramp_ends.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/study/check_work.hpp"
#include "bridge/study/safety.hpp"

namespace blockweir::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

Outcome outcome_of(const json& summary) {
  const json none;
  const json failure = summary.value("failure", json::object());
  const json margin = summary.value("margin", json::object());
  const bool fails = summary.value("outcome", "stopped") == "fails";
  const bool has_level = fails && failure.value("level_m", none).is_number();
  return {{"outcome", summary.value("outcome", "stopped")},
          {"mode", fails ? failure.value("mode", none) : none},
          {"joint", fails ? failure.value("joint", none) : none},
          {"level_m", fails ? failure.value("level_m", none) : none},
          {"level_uncertainty_m", fails ? failure.value("level_uncertainty_m", none) : none},
          {"level_is_bound", has_level ? failure.value("level_is_bound", none) : none},
          {"level_doubt", has_level ? failure.value("doubt", none) : none},
          {"head_m", fails ? failure.value("head_m", none) : none},
          {"time_s", fails ? failure.value("time_s", none) : none},
          {"sliding_factor", margin.value("sliding_factor", none)},
          {"factor", none},
          {"simulated_s", summary.value("simulated_s", none)},
          {"wall_time_s", summary.value("wall_time_s", none)}};
}

}  // namespace

Outcome troubled(const char* outcome, const std::string& trouble) {
  Outcome row = outcome_of(json::object());
  row["outcome"] = outcome;
  row["trouble"] = trouble;
  return row;
}

bool has_answer(const Outcome& outcome) {
  return outcome["outcome"] != "stopped";
}

namespace {

/// The scene with `all`; one that ends on the move is run longer when that is asked for. Throws Interrupted: a run that
/// was stopped on request has no outcome.
Outcome run_out(const fs::path& scene, Settings all, const fs::path& folder, bool until_decided) {
  constexpr double longer = 4;
  constexpr int tries = 4;
  Outcome row;
  for (int k = 0; k < tries; ++k) {
    const process::RunResult result = process::run({.scene = scene, .out = folder, .overrides = all, .quiet = true});
    if (result.exit_code == 130) throw Interrupted();
    if (!result.trouble.empty()) return troubled(result.refused ? "refused" : "stopped", result.trouble);
    row = outcome_of(result.summary);
    if (row["outcome"] != "moving" || !until_decided) break;
    if (k == 0) all = joined(all, scene::ramp_ends(scene::read(scene, all).scene));
    all.push_back(setting("analysis.duration_s", longer * row["simulated_s"].get<double>()));
  }
  return row;
}

/// The factor of safety with `all`; none if no strength is needed or no strength is enough.
Outcome factor_out(const fs::path& scene, const Settings& all, const fs::path& folder) {
  const json answer = process::ask("safety", {.scene = scene, .out = folder, .overrides = all, .quiet = true}).answer;
  if (answer["outcome"] == "not found") return troubled("stopped", answer["why_no_factor"]);
  Outcome row = outcome_of(json::object());
  row["outcome"] = answer["outcome"];
  if (const double factor = deciding_factor(answer); factor > 0 && std::isfinite(factor)) row["factor"] = factor;
  return row;
}

/// By limit analysis or by static analysis, in a program that lasts for as long as it is well.
class CapacityProgram {
 public:
  CapacityProgram(std::string scene, std::string question) : scene_(std::move(scene)), question_(std::move(question)) {}
  Outcome of(const Settings& all) {
    try {
      if (!program_) program_ = std::make_unique<process::LineProgram>(Settings{"blockweir-limit", question_, scene_});
      Outcome row = outcome_of(json::object());
      row.update(program_->ask(all));
      return row;
    } catch (const std::exception& error) {
      program_.reset();
      return troubled("stopped", error.what());
    }
  }

 private:
  std::string scene_;
  std::string question_;
  std::unique_ptr<process::LineProgram> program_;
};

/// Of one item, in a folder of the process's own.
Outcome made_outcome(const json& common, const Settings& all, const fs::path& folder) {
  Outcome row;
  try {
    row = common["by"] == "factor" ? factor_out(common["scene"].get<std::string>(), all, folder)
                                   : run_out(common["scene"].get<std::string>(), all, folder, common["until_decided"]);
  } catch (const process::Stopped&) {
    throw Interrupted();
  } catch (const scene::SceneError& error) {
    row = troubled("refused", error.what());
  } catch (const std::exception& error) {
    row = troubled("stopped", error.what());
  }
  fs::remove_all(folder);
  return row;
}

}  // namespace

engine::Worker study_worker(const json& common) {
  const std::string by = common["by"];
  if (by == "check") return check_worker();
  const auto whole = [common](const json& item) {
    return joined(joined(common["settings"].get<Settings>(), item["settings"].get<Settings>()), {"study=[]"});
  };
  if (by == "limit" || by == "statics") {
    const auto capacities = std::make_shared<CapacityProgram>(common["scene"].get<std::string>(),
                                                              by == "limit" ? "capacity" : "static-capacity");
    return [capacities, whole](const json& item) { return capacities->of(whole(item)); };
  }
  const auto scratch = std::make_shared<process::TemporaryFolder>();
  return
      [common, whole, scratch](const json& item) { return made_outcome(common, whole(item), scratch->path() / "run"); };
}

}  // namespace blockweir::study
