// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/reliability/reliability_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bridge/reliability/capacities.hpp"
#include "bridge/reliability/contradiction.hpp"
#include "bridge/reliability/refused_draws.hpp"
#include "bridge/reliability/reliability_output.hpp"
#include "bridge/results/seconds.hpp"
#include "bridge/study/engines.hpp"
#include "bridge/study/outcome_runs.hpp"
#include "bridge/study/probability.hpp"

namespace blockweir::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using scene::CapacityBy;

const char* word_of(CapacityBy by) {
  return by == CapacityBy::limit ? "limit" : by == CapacityBy::statics ? "statics" : "run";
}

/// Which other way the one is held against at a few points.
const char* other_than(CapacityBy by) {
  return by == CapacityBy::limit ? "statics" : "limit";
}

constexpr int designs = 10;  // for dependent points: independent designs, whose scatter gives the interval

int groups_of(const scene::Reliability& asked) {
  return asked.sampling == "monte-carlo" ? 1 : designs;
}

/// The level whose probability is asked for.
double level_of(const scene::ReadScene& read) {
  const std::string file = read.scene.file.string();
  const auto& water = read.scene.water.upstream_level_m;
  const scene::Reliability& asked = read.randomness.reliability;
  if (!asked.level_m && !water) {
    throw std::invalid_argument(
        fmt::format("{}: found no level; expected one whose probability of failure is asked for; add [reliability] "
                    "level_m = ..., or upstream_level_m to [water]",
                    file));
  }
  const double level_m = asked.level_m ? *asked.level_m : water->at(read.scene.analysis.duration_s);
  if (asked.by != CapacityBy::runs) return level_m;
  const double end_m = water ? water->at(read.scene.analysis.duration_s) : level_m - 1;
  if (end_m >= level_m) return level_m;
  throw std::invalid_argument(fmt::format(
      "{}: found by = \"runs\" and level_m = {} in [reliability], and runs that do not end at that level; expected a "
      "filling that reaches it; raise upstream_level_m of [water], or take by = \"limit\"",
      file, level_m));
}

/// One call of the command.
class Reliability {
 public:
  Reliability(const ReliabilityOptions& options, const scene::ReadScene& read, fs::path folder)
      : options_(options),
        randomness_(read.randomness),
        asked_(read.randomness.reliability),
        level_m_(level_of(read)),
        digest_(read.scene.digest),
        folder_(std::move(folder)),
        probability_(randomness_),
        engine_(make_engine(options.engine, folder_)),
        here_(make_engine({.jobs = jobs_of(options.engine)}, folder_)) {}

  json find() {
    const json drawn = probability_.ask({{"do", "draw"},
                                         {"sampling", asked_.sampling},
                                         {"groups", groups_of(asked_)},
                                         {"count", std::max(1, asked_.samples / groups_of(asked_))}});
    points_ = drawn["points"].get<std::vector<RandomPoint>>();
    means_ = drawn["means"].get<RandomPoint>();
    refuse_unsound(options_.scene, randomness_, points_, options_.overrides);
    answer_ = {{"digest", digest_},           {"level_m", level_m_}, {"by", word_of(asked_.by)},
               {"sampling", asked_.sampling}, {"means", means_},     {"correlated", !randomness_.correlations.empty()}};
    for (const auto& variable : randomness_.variables) {
      answer_["variables"].push_back(variable.name);
      answer_["distributions"].push_back(distribution_text(variable.distribution));
    }
    OutcomeRuns runs(plan(word_of(asked_.by), "samples"), *engine_);
    add_samples(runs);
    for (const std::string& method : asked_.methods) add_method(runs, method);
    add_comparison(runs);
    if (const std::string words = contradiction_of(answer_); !words.empty()) answer_["contradiction"] = words;
    return answer_;
  }
  [[nodiscard]] std::string table() const { return sample_table(randomness_, points_, rows_); }

 private:
  [[nodiscard]] OutcomePlan plan(const std::string& by, const char* kept) const {
    return {.name = "reliability",
            .scene = options_.scene,
            .set = {},
            .overrides = options_.overrides,
            .kept = folder_ / fmt::format("{}.runs.jsonl", kept),
            .by = by,
            .of_many = true};
  }
  [[nodiscard]] std::vector<Settings> settings(const std::vector<RandomPoint>& points) const {
    std::vector<Settings> all;
    for (const RandomPoint& point : points) all.push_back(settings_of(randomness_, point));
    return all;
  }

  void add_samples(OutcomeRuns& runs) {
    const auto begun = std::chrono::steady_clock::now();
    rows_ = runs.make(settings(points_));
    require_looked_at();
    std::vector<double> levels;
    for (const Outcome& row : rows_) levels.push_back(capacity_of(row));
    const Capacities capacities(std::move(levels), static_cast<std::size_t>(groups_of(asked_)));
    const Share share = capacities.failing(level_m_);
    answer_["samples"] = {{"count", capacities.size()},
                          {"without_answer", capacities.without_answer()},
                          {"that_stand", capacities.that_stand()},
                          {"that_never_stand", capacities.that_never_stand()},
                          {"probability", share.value},
                          {"interval", {share.from, share.to}},
                          {"index", index_json(share.value)},
                          {"wall_time_s", seconds_since(begun)},
                          {"made", runs.made()},
                          {"lost_to_the_engine", engine_->effort().lost()}};
    for (const Outcome& row : rows_) {
      if (row.contains("trouble")) answer_["samples"]["trouble"] = row["trouble"];
      if (row.value("upper_bound", false)) answer_["upper_bound"] = true;
    }
    add_note(rows_);
    answer_["curve"] = capacities.curve();
    const std::vector<double> finite = capacities.finite();
    if (finite.size() < 10 || finite.front() == finite.back()) return;
    answer_["fit"] = probability_.ask({{"do", "fit"}, {"values", finite}});
    answer_["fit"]["samples"] = finite.size();
    if (const auto [level_m, count] = capacities.commonest(); 2 * count > finite.size()) {
      answer_["fit"]["commonest"] = {{"level_m", level_m}, {"samples", count}};
    }
    for (const Outcome& row : rows_) {  // a stable sample may fail at any higher level: the fit is truncated
      if (row["outcome"] == "stands") answer_["fit"]["cut_off_m"] = row.value("full_m", json());
    }
  }

  /// What limit analysis takes otherwise than the blocks, such as anchors that hold any force.
  void add_note(const std::vector<Outcome>& by_limit) {
    for (const Outcome& row : by_limit) {
      if (!row.contains("limit_analysis_note")) continue;
      const char* remedy =
          asked_.by == CapacityBy::limit ? "; by = \"statics\" in [reliability] has anchors that stretch" : "";
      answer_["limit_analysis_note"] = row["limit_analysis_note"].get<std::string>() + remedy;
    }
  }

  /// A sample that stands at the highest level may fail at a higher one.
  void require_looked_at() const {
    for (const Outcome& row : rows_) {
      const json full_m = row.value("full_m", json());
      if (!full_m.is_number() || full_m >= level_m_ || row["outcome"] != "stands") continue;
      throw std::invalid_argument(
          fmt::format("level_m = {} in [reliability], and samples that stand at {} m, the highest level that is looked "
                      "at; expected "
                      "a level up to that; lower level_m, or add may_overtop = true to [water]",
                      level_m_, full_m.get<double>()));
    }
  }

  /// Infinite numbers are null in JSON.
  static json index_json(double probability) {
    const double index = reliability_index(probability);
    return std::isfinite(index) ? json(index) : json();
  }

  void add_method(OutcomeRuns& runs, const std::string& method) {
    if (method == "sobol" && !randomness_.correlations.empty()) {
      answer_["sobol"] = {{"trouble",
                           "variables that are correlated have no Sobol indices: their shares of the variance "
                           "overlap; leave \"sobol\" out of methods, or the correlations"}};
      return;
    }
    constexpr std::size_t few = 64;
    std::vector<Outcome> rows;
    const auto evaluate = [&](const std::vector<RandomPoint>& points) {
      rows = runs.make(settings(points), 0, points.size() <= few);
      std::vector<double> values;
      for (const Outcome& row : rows) values.push_back(value_of(row));
      return values;
    };
    try {
      answer_[method] =
          probability_.ask({{"do", method}, {"threshold", level_m_}, {"samples", asked_.method_samples}}, evaluate);
    } catch (const scene::SceneError&) {
      throw;
    } catch (const Unanswered& error) {
      answer_[method] = {{"trouble", why_no_answer(randomness_, runs.make(settings({error.at}), 0, true).front())}};
    } catch (const std::runtime_error& error) {
      answer_[method] = {{"trouble", trouble_of(error.what(), rows)}};
    }
  }

  /// And why all of the last points have the same level, where they do. If limit analysis lets anchors hold whatever
  /// comes, that is the cause, and higher levels or other methods are of no use.
  [[nodiscard]] std::string trouble_of(const std::string& error, const std::vector<Outcome>& rows) const {
    const auto all = [&rows](const char* outcome) {
      return !rows.empty() &&
             std::all_of(rows.begin(), rows.end(), [&](const Outcome& row) { return row["outcome"] == outcome; });
    };
    if (all("stands")) {
      const std::string where = fmt::format("all points there stand at {:.6g} m, the highest level that is looked at",
                                            rows.front()["full_m"].get<double>());
      if (answer_.contains("limit_analysis_note")) {
        return fmt::format("{}: {}", where, answer_["limit_analysis_note"].get<std::string>());
      }
      return fmt::format("{}; {}: may_overtop = true in [water] looks for higher ones", error, where);
    }
    return error + (all("does not stand empty")
                        ? "; no point there stands with an empty reservoir: see the scene's strength"
                        : "");
  }

  /// The level as a function; for samples that are stable when full or fail when empty, the end of the range. NaN
  /// without an answer.
  [[nodiscard]] double value_of(const Outcome& row) const {
    const double capacity = capacity_of(row);
    if (std::isfinite(capacity)) return capacity;
    if (std::isnan(capacity)) return capacity;
    return row[capacity > 0 ? "full_m" : "empty_m"];
  }

  /// The same two points by another way: what the ways differ by.
  void add_comparison(OutcomeRuns& runs) {
    std::vector<RandomPoint> points{means_};
    std::vector<std::string> names{"at the means"};
    if (const json form = answer_.value("form", json::object()); form.contains("design_point")) {
      points.push_back(form["design_point"].get<RandomPoint>());
      names.emplace_back("at the design point");
    }
    OutcomeRuns others(plan(other_than(asked_.by), "comparison"), *here_);
    const std::vector<Outcome> by_one = runs.make(settings(points), 0, true);
    const std::vector<Outcome> by_other = others.make(settings(points), 0, true);
    add_note(asked_.by == CapacityBy::limit ? by_one : by_other);
    for (std::size_t i = 0; i < points.size(); ++i) {
      answer_["comparison"].push_back({{"where", names[i]},
                                       {word_of(asked_.by), level_json(by_one[i])},
                                       {other_than(asked_.by), level_json(by_other[i])}});
    }
  }
  static json level_json(const Outcome& row) {
    return {
        {"level_m", row.value("level_m", json())}, {"outcome", row["outcome"]}, {"trouble", row.value("trouble", "")}};
  }

  const ReliabilityOptions& options_;
  const scene::Randomness& randomness_;
  const scene::Reliability& asked_;
  double level_m_;
  std::string digest_;
  fs::path folder_;
  Probability probability_;
  std::unique_ptr<engine::Engine> engine_;
  std::unique_ptr<engine::Engine> here_;
  std::vector<RandomPoint> points_;
  RandomPoint means_;
  std::vector<Outcome> rows_;
  json answer_;
};

}  // namespace

FoundReliability find_reliability(const ReliabilityOptions& options, const scene::ReadScene& read,
                                  const fs::path& folder) {
  Reliability reliability(options, read, folder);
  json answer = reliability.find();
  return {.answer = std::move(answer), .samples = reliability.table()};
}

}  // namespace blockweir::study
