// SPDX-License-Identifier: GPL-3.0-or-later
// [[limit]]: bisection over whole runs for the value of a key at which the outcome changes.
#include <fmt/format.h>

#include <cmath>

#include "bridge/picture/gnuplot.hpp"
#include "bridge/results/figure.hpp"
#include "bridge/study/key_label.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {
namespace {

using picture::gnuplot_text;

using nlohmann::json;

/// Whether the run has the outcome whose limit is sought. "fails" includes every mode.
bool has(const std::string& outcome, const std::string& word) {
  return outcome == "fails" ? word != "stands" : word == outcome;
}

/// The bracket closes from run to run onto the answer.
std::string bracket_figure(const json& runs, const std::string& key, double expected) {
  std::string figure = fmt::format("set xlabel 'run'\nset ylabel {}\nset key outside top horizontal\nset grid\n",
                                   gnuplot_text(key_label(key)));
  for (const bool with : {true, false}) {
    figure += fmt::format("$d{} << EOD\n", with ? 1 : 0);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (runs[i]["has"].get<bool>() == with) figure += fmt::format("{} {}\n", i + 1, runs[i]["value"].get<double>());
    }
    figure += "EOD\n";
  }
  return figure + fmt::format(
                      "plot {} with lines lc rgb '#808080' title 'expected', $d1 pt 7 lc rgb '#c00000' title "
                      "'fails so', $d0 pt 6 lc rgb '#204a87' title 'does not'\n",
                      expected);
}

StudyResult find_limit(const scene::LimitStudy& study, StudyRuns& runs) {
  StudyResult result;
  scene::Expectation answer = study.expected;
  answer.quantity = "largest_penetration_m";  // any figure that every run has: its answer alone is read
  double expected = 0;
  const auto has_outcome = [&](double value) {
    // A run that ends in motion is undecided; a longer one decides.
    constexpr double longer = 4;
    constexpr int tries = 4;
    json summary = runs.run({setting(study.key, value)}, answer);
    for (int k = 1; outcome_word(summary) == "moving" && study.outcome != "moving"; ++k) {
      if (k == tries) {
        throw std::runtime_error(fmt::format(
            "with {} = {:.6g} the run ends while blocks still move, so its outcome is not decided: lengthen duration_s",
            study.key, value));
      }
      const double duration_s = longer * summary["simulated_s"].get<double>();
      summary = runs.run_longer({setting(study.key, value)}, duration_s, answer);
    }
    const std::string word = outcome_word(summary);
    expected = summary["checks"][0]["expected"].get<double>();
    const bool with = has(study.outcome, word);
    result.runs.push_back({{"value", value}, {"outcome", word}, {"has", with}});
    result.text += fmt::format("  {:<12.9g} {}\n", value, word);
    return with;
  };

  double low = study.from;
  double high = study.to;
  const bool at_low = has_outcome(low);
  if (has_outcome(high) == at_low) {
    const auto end = [&](std::size_t run) { return result.runs[run]["outcome"].get<std::string>(); };
    throw std::runtime_error(fmt::format(
        "no limit of {} found: the outcome is \"{}\" at {:.6g} and \"{}\" at {:.6g}; expected \"{}\" at one "
        "of both alone; move from or to",
        study.key, end(0), low, end(1), high, study.outcome));
  }
  constexpr int most_halvings = 60;
  const auto width = [&] { return std::abs(high - low) / std::max(std::abs(low), std::abs(high)); };
  for (int i = 0; i < most_halvings && width() > study.width; ++i) {
    const double middle = results::without_rounding_error((low + high) / 2);
    (has_outcome(middle) == at_low ? low : high) = middle;
  }
  const double got = (low + high) / 2;
  const double error = expected == 0 ? std::abs(got) : std::abs(got / expected - 1);
  result.check = {{"name", "limit of " + study.key},
                  {"expected", expected},
                  {"got", got},
                  {"relative_error", error},
                  {"tolerance", study.expected.tolerance},
                  {"passed", error <= study.expected.tolerance},
                  {"formula", study.expected.formula},
                  {"source", study.expected.source}};
  result.figure = bracket_figure(result.runs, study.key, expected);
  return result;
}

}  // namespace

StudyTask limit_task(const scene::LimitStudy& study) {
  return {.name = study.name,
          .kind = "[[limit]]",
          .line = study.line,
          .set = study.set,
          .extremes = {{setting(study.key, study.from)}, {setting(study.key, study.to)}},
          .go = [study](StudyRuns& runs) { return find_limit(study, runs); }};
}

}  // namespace blockweir::study
