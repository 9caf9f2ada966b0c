// SPDX-License-Identifier: GPL-3.0-or-later
// kind = "sample": keys drawn at random or read from a file, and how often each outcome is met.
#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <map>

#include "bridge/picture/gnuplot.hpp"
#include "bridge/study/draws.hpp"
#include "bridge/study/key_label.hpp"
#include "bridge/study/map_figure.hpp"
#include "bridge/study/open_study.hpp"

namespace blockweir::study {
namespace {

/// 95 % confidence interval of Clopper and Pearson. Runs without an answer widen it: all or none of them have this
/// outcome.
std::array<double, 2> interval_of(std::size_t with, std::size_t without_answer, std::size_t total) {
  using Trials = boost::math::binomial_distribution<>;
  constexpr double tail = 0.025;
  const auto trials = static_cast<double>(total);
  return {Trials::find_lower_bound_on_p(trials, static_cast<double>(with), tail),
          Trials::find_upper_bound_on_p(trials, static_cast<double>(with + without_answer), tail)};
}

/// The first two variables, or the run's number over the only one, in the colour of the outcome.
std::string figure(const Settings& keys, const std::vector<Outcome>& runs) {
  std::map<std::string, std::string> points;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::string across = keys.size() > 1 ? value_in(runs[i], keys[1]) : std::to_string(i + 1);
    points[shown_word(runs[i])] += fmt::format("{} {}\n", value_in(runs[i], keys[0]), across);
  }
  std::string text = fmt::format("set xlabel {}\nset ylabel {}\nset key outside top horizontal\nset grid\n",
                                 picture::gnuplot_text(key_label(keys[0])),
                                 keys.size() > 1 ? picture::gnuplot_text(key_label(keys[1])) : "'run'");
  std::string curves;
  int number = 0;
  for (const auto& [word, rows] : points) {
    text += fmt::format("$w{} << EOD\n{}EOD\n", ++number, rows);
    curves += fmt::format("{}$w{} pt 7 lc rgb '{}' title {}", curves.empty() ? "" : ", ", number, colour(word),
                          picture::gnuplot_text(word));
  }
  return text + "plot " + curves + "\n";
}

Finding draw_sample(const Settings& keys, const std::vector<Settings>& settings, OutcomeRuns& runs) {
  Finding finding{.runs = runs.make(settings)};
  std::map<std::string, std::size_t> counts;
  std::size_t without_answer = 0;
  for (const Outcome& run : finding.runs) {
    if (has_answer(run)) {
      ++counts[shown_word(run)];
    } else {
      ++without_answer;
    }
  }
  finding.answer["without_answer"] = without_answer;
  for (const auto& [word, count] : counts) {
    const auto [least, most] = interval_of(count, without_answer, settings.size());
    finding.answer["outcomes"][word] = {{"runs", count}, {"share_from", least}, {"share_to", most}};
    finding.text += fmt::format(
        "  {:<24} {} of {} runs, {:.3g} %; 95 % interval {:.3g} to {:.3g} %\n", word, count, settings.size(),
        100.0 * static_cast<double>(count) / static_cast<double>(settings.size()), 100 * least, 100 * most);
  }
  finding.figure = figure(keys, finding.runs);
  return finding;
}

/// The runs with the least and the largest value of each variable, of those that are numbers.
std::vector<Settings> extremes_of(const std::vector<Settings>& all) {
  std::vector<Settings> extremes{all.front()};
  const auto value = [](const std::string& text) { return std::strtod(text.c_str() + text.find('=') + 1, nullptr); };
  for (std::size_t v = 0; v < all.front().size(); ++v) {
    const auto [least, most] = std::minmax_element(
        all.begin(), all.end(), [&](const Settings& a, const Settings& b) { return value(a[v]) < value(b[v]); });
    extremes.push_back(*least);
    extremes.push_back(*most);
  }
  return extremes;
}

}  // namespace

OpenStudyTask sample_task(const scene::OpenStudy& study, const std::filesystem::path& scene) {
  const auto& sample = std::get<scene::Sample>(study.question);
  const std::vector<Settings> settings = drawn_settings(study, scene);
  OpenStudyTask task{.name = study.name, .kind = "sample", .line = study.line, .set = study.set};
  for (const scene::Variable& variable : sample.variables) task.keys.push_back(variable.key);
  task.extremes = extremes_of(settings);
  task.may_refuse = sample.file.empty();  // what a user has written into a file is to be sound
  task.find = [keys = task.keys, settings](OutcomeRuns& runs) { return draw_sample(keys, settings, runs); };
  return task;
}

}  // namespace blockweir::study
