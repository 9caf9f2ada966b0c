// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/outcome_runs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "bridge/results/seconds.hpp"
#include "bridge/results/wrapped.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Tables that ask for runs do not affect their outcome.
const Settings without_questions{"study=[]", "random=[]", "correlation=[]", "reliability={}"};

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

/// The file of known outcomes, for appending. It is rewritten in one operation, so that a stop loses nothing.
results::ResultFile kept_file(const fs::path& file, const std::map<std::string, Outcome>& known) {
  std::string text;
  for (const auto& [key, row] : known) text += row.dump() + "\n";
  results::replace_file(file, text);
  return results::ResultFile(file, results::Begin::where_it_stopped);
}

std::string duration(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

/// A number that was drawn has sixteen digits: of "key=number" six are shown.
std::string shortened(const std::string& setting) {
  const std::size_t value = setting.find('=') + 1;
  char* end = nullptr;
  const double number = std::strtod(setting.c_str() + value, &end);
  if (value == 0 || value == setting.size() || *end != '\0') return setting;
  return fmt::format("{}{:.6g}", setting.substr(0, value), number);
}

void say(const std::string& text) {
  fmt::print(stderr, "{}", results::for_stderr(text));
}

}  // namespace

OutcomeRuns::OutcomeRuns(OutcomePlan plan, engine::Engine& engine)
    : plan_(std::move(plan)),
      engine_(engine),
      base_(scene::read(plan_.scene, joined(plan_.overrides, without_questions)).scene.digest + " " BLOCKWEIR_VERSION),
      known_(read_known(plan_.kept)),
      kept_(kept_file(plan_.kept, known_)) {}

std::string OutcomeRuns::key_of(const Settings& settings) const {
  return fmt::format("{} {} {}", base_, plan_.by, fmt::join(joined(plan_.set, settings), "; "));
}

std::vector<Outcome> OutcomeRuns::make(const std::vector<Settings>& settings, std::size_t later, bool brief) {
  std::vector<Outcome> rows(settings.size());
  std::vector<std::size_t> missing;
  engine::Work work{.name = plan_.name,
                    .common = {{"scene", fs::absolute(plan_.scene).string()},
                               {"settings", joined(plan_.set, plan_.overrides)},
                               {"by", plan_.by},
                               {"until_decided", plan_.until_decided}},
                    .items = {},
                    .brief = brief};
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const auto known = known_.find(key_of(settings[i]));
    if (known != known_.end()) rows[i] = known->second;
    if (known == known_.end()) {
      missing.push_back(i);
      work.items.push_back({{"settings", settings[i]}});
    }
    rows[i]["settings"] = settings[i];
  }
  std::size_t left = missing.size() + later;
  const auto take_up = [&](std::size_t k, const json& answer) {
    const std::size_t i = missing[k];
    Outcome row = answer.is_object() ? answer : troubled("stopped", "its process was killed");
    row["settings"] = settings[i];
    rows[i] = row;
    report_progress(row, --left);
    if (row.contains("trouble")) return;
    row["key"] = key_of(settings[i]);
    kept_.line(row.dump());
    known_[row["key"]] = row;
  };
  if (!engine_.perform(work, take_up)) throw Interrupted();
  return rows;
}

void OutcomeRuns::report_progress(const Outcome& outcome, std::size_t left) {
  ++done_;
  const double each_s = seconds_since(begun_) / static_cast<double>(done_);
  const std::string more =
      left == 0 ? "no more runs" : fmt::format("{} more, some {}", left, duration(each_s * static_cast<double>(left)));
  if (plan_.of_many) {
    constexpr double report_every_s = 5;
    if (seconds_since(reported_) < report_every_s) return;
    reported_ = std::chrono::steady_clock::now();
    return say(fmt::format("{}: {} done, {}\n", plan_.name, done_, more));
  }
  std::string ending = outcome["outcome"];
  if (outcome["factor"].is_number()) ending = fmt::format("factor {:.5g}", outcome["factor"].get<double>());
  if (outcome["mode"].is_string()) ending += " by " + outcome["mode"].get<std::string>();
  if (outcome.contains("trouble")) ending += ": " + outcome["trouble"].get<std::string>();
  std::vector<std::string> settings = outcome["settings"];
  std::transform(settings.begin(), settings.end(), settings.begin(), shortened);
  say(fmt::format("{}: {}: {}; {}\n", plan_.name, fmt::join(settings, ", "), ending, more));
}

}  // namespace blockweir::study
