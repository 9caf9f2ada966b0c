// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/outcome_runs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <fstream>

#include "bridge/process/ask.hpp"
#include "bridge/process/run.hpp"
#include "bridge/process/side_by_side.hpp"
#include "bridge/results/seconds.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/study/safety.hpp"

namespace blockweir::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* without_studies = "study=[]";

/// Those of an earlier call; a killed one may have left half a line.
std::map<std::string, Outcome> read_known(const fs::path& file) {
  std::map<std::string, Outcome> known;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    json row = json::parse(line, nullptr, /*allow_exceptions=*/false);
    if (!row.is_object() || !row.contains("key") || !row.contains("outcome")) continue;
    const std::string key = row["key"];
    known[key] = std::move(row);
  }
  return known;
}

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

Outcome troubled(const char* outcome, const std::string& trouble) {
  Outcome row = outcome_of(json::object());
  row["outcome"] = outcome;
  row["trouble"] = trouble;
  return row;
}

/// The scene with `all`; one that ends on the move is run longer when that is asked for.
Outcome run_out(const fs::path& scene, Settings all, const fs::path& folder, bool until_decided) {
  constexpr double longer = 4;
  constexpr int tries = 4;
  Outcome row;
  for (int k = 0; k < tries; ++k) {
    const process::RunResult result = process::run({.scene = scene, .out = folder, .overrides = all, .quiet = true});
    if (!result.trouble.empty()) return troubled(result.refused ? "refused" : "stopped", result.trouble);
    row = outcome_of(result.summary);
    if (row["outcome"] != "moving" || !until_decided) break;
    all.push_back(setting("analysis.duration_s", longer * row["simulated_s"].get<double>()));
  }
  return row;
}

/// The factor of safety with `all`; none where no strength is needed or none would do.
Outcome factor_out(const fs::path& scene, const Settings& all, const fs::path& folder) {
  const json answer = process::ask("safety", {.scene = scene, .out = folder, .overrides = all, .quiet = true}).answer;
  if (answer["outcome"] == "not found") return troubled("stopped", answer["why_no_factor"]);
  Outcome row = outcome_of(json::object());
  row["outcome"] = answer["outcome"];
  if (const double factor = deciding_factor(answer); factor > 0 && std::isfinite(factor)) row["factor"] = factor;
  return row;
}

std::string duration(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

std::string outcome_key(const fs::path& scene, const Settings& all) {
  return scene::read(scene, joined(all, {without_studies})).scene.digest + " " BLOCKWEIR_VERSION;
}

OutcomeRuns::OutcomeRuns(OutcomePlan plan) : plan_(std::move(plan)), known_(read_known(plan_.kept)), kept_(plan_.kept) {
  for (const auto& [key, row] : known_) kept_.line(row.dump());
}

Settings OutcomeRuns::whole(const Settings& settings) const {
  return joined(joined(plan_.set, plan_.overrides), joined(settings, {without_studies}));
}

void OutcomeRuns::make_one(const Settings& settings, const fs::path& file) const {
  Outcome row;
  try {
    row = plan_.of_factor ? factor_out(plan_.scene, whole(settings), file.string() + "-run")
                          : run_out(plan_.scene, whole(settings), file.string() + "-run", plan_.until_decided);
  } catch (const scene::SceneError& error) {
    row = troubled("refused", error.what());
  } catch (const std::exception& error) {
    row = troubled("stopped", error.what());
  }
  results::write_file(file, row.dump());
}

std::vector<Outcome> OutcomeRuns::make(const std::vector<Settings>& settings, std::size_t later) {
  std::vector<Outcome> rows(settings.size());
  std::vector<std::string> keys(settings.size());
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    try {
      keys[i] = outcome_key(plan_.scene, whole(settings[i])) + (plan_.of_factor ? " factor" : "");
    } catch (const scene::SceneError& error) {
      rows[i] = troubled("refused", error.what());
    }
    if (const auto known = known_.find(keys[i]); known != known_.end()) rows[i] = known->second;
    if (rows[i].is_null()) missing.push_back(i);
    rows[i]["settings"] = settings[i];
  }
  std::size_t left = missing.size() + later;
  const auto file_of = [&](std::size_t k) { return scratch_.path() / std::to_string(missing[k]); };
  const auto take_up = [&](std::size_t k) {
    const std::size_t i = missing[k];
    std::ifstream stream(file_of(k));
    Outcome row = json::parse(stream, nullptr, /*allow_exceptions=*/false);
    if (!row.is_object()) row = troubled("stopped", "its process was killed");
    row["settings"] = settings[i];
    rows[i] = row;
    fs::remove_all(file_of(k).string() + "-run");
    fs::remove(file_of(k));
    tell(row, --left);
    if (row.contains("trouble")) return;
    row["key"] = keys[i];
    kept_.line(row.dump());
    known_[keys[i]] = row;
  };
  const bool all = process::side_by_side(
      missing.size(), plan_.jobs, [&](std::size_t k) { make_one(settings[missing[k]], file_of(k)); }, take_up);
  if (!all) throw Interrupted();
  return rows;
}

void OutcomeRuns::tell(const Outcome& outcome, std::size_t left) {
  ++done_;
  const double each_s = seconds_since(begun_) / static_cast<double>(done_);
  std::string ending = outcome["outcome"];
  if (outcome["factor"].is_number()) ending = fmt::format("factor {:.5g}", outcome["factor"].get<double>());
  if (outcome["mode"].is_string()) ending += " by " + outcome["mode"].get<std::string>();
  if (outcome.contains("trouble")) ending += ": " + outcome["trouble"].get<std::string>();
  fmt::print(
      stderr, "{}: {}: {}; {}\n", plan_.name, fmt::join(outcome["settings"].get<std::vector<std::string>>(), ", "),
      ending,
      left == 0 ? "no more runs" : fmt::format("{} more, some {}", left, duration(each_s * static_cast<double>(left))));
}

}  // namespace blockweir::study
