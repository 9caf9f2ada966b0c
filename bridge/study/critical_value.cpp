// SPDX-License-Identifier: GPL-3.0-or-later
// kind = "critical": bisection over whole runs. With several processors, the possible next halvings are run in parallel
// with the present one, so that the answer does not depend on their number.
#include <fmt/format.h>

#include <cmath>
#include <deque>

#include "bridge/results/figure.hpp"
#include "bridge/study/critical_figure.hpp"

namespace blockweir::study {
namespace {

using scene::CriticalValue;

struct Bracket {
  double low;
  double high;
  [[nodiscard]] double middle() const { return results::without_rounding_error((low + high) / 2); }
  [[nodiscard]] double width() const { return std::abs(high - low) / std::max(std::abs(low), std::abs(high)); }
};

/// The middle of the bracket, those of its halves, of their halves: the first `count` of them.
std::vector<double> middles(const Bracket& bracket, std::size_t count) {
  std::vector<double> values;
  std::deque<Bracket> open{bracket};
  for (; values.size() < count; open.pop_front()) {
    const Bracket b = open.front();
    values.push_back(b.middle());
    open.push_back({b.low, b.middle()});
    open.push_back({b.middle(), b.high});
  }
  return values;
}

/// The property that only one end may have, in words.
std::string wanted(const CriticalValue& critical) {
  if (critical.target) return fmt::format("a factor of at least {:.5g}", *critical.target);
  return fmt::format("\"{}\"{}", critical.outcome, critical.outcome == "fails" ? " (by any mode)" : "");
}

/// "fails" includes every mode. Throws if the run is undecided.
bool has(const CriticalValue& critical, const Outcome& outcome) {
  const std::string word = outcome["outcome"];
  if (outcome.contains("trouble")) throw std::runtime_error(outcome["trouble"].get<std::string>());
  if (critical.target) {  // without a factor it stands or fails at any strength
    return outcome["factor"].is_number() ? outcome["factor"].get<double>() >= *critical.target : word == "stands";
  }
  if (word == "moving" && critical.outcome != "moving") {
    throw std::runtime_error(
        fmt::format("with {} the run ends while blocks still move, so its outcome is not decided: lengthen duration_s",
                    outcome["settings"][0].get<std::string>()));
  }
  return word == critical.outcome || shown_word(outcome) == critical.outcome;
}

class Search {
 public:
  Search(const CriticalValue& critical, std::size_t jobs, OutcomeRuns& runs)
      : critical_(critical), jobs_(jobs), runs_(runs) {}

  Finding find() {
    Bracket bracket{critical_.from, critical_.to};
    make({bracket.low, bracket.high}, bracket);
    const bool at_low = known_.at(bracket.low);
    if (known_.at(bracket.high) == at_low) no_change();
    constexpr int most_halvings = 60;
    for (int i = 0; i < most_halvings && bracket.width() > critical_.width; ++i) {
      if (!known_.contains(bracket.middle())) make(middles(bracket, jobs_), bracket);
      (known_.at(bracket.middle()) == at_low ? bracket.low : bracket.high) = bracket.middle();
    }
    return finding_of(bracket);
  }

 private:
  void make(const std::vector<double>& values, const Bracket& bracket) {
    std::vector<Settings> settings;
    for (const double value : values) settings.push_back({setting(critical_.key, value)});
    const double halvings = std::log2(std::max(1.0, bracket.width() / critical_.width));
    const std::vector<Outcome> outcomes = runs_.make(settings, static_cast<std::size_t>(halvings));
    for (std::size_t i = 0; i < values.size(); ++i) {
      known_[values[i]] = has(critical_, outcomes[i]);
      finding_.runs.push_back(outcomes[i]);
    }
  }

  [[noreturn]] void no_change() const {
    throw std::runtime_error(fmt::format(
        "no change found: the outcome is \"{}\" with {} and \"{}\" with {}; expected {} at one of "
        "both alone; move from or to",
        shown_word(finding_.runs[0]), finding_.runs[0]["settings"][0].get<std::string>(), shown_word(finding_.runs[1]),
        finding_.runs[1]["settings"][0].get<std::string>(), wanted(critical_)));
  }

  Finding finding_of(const Bracket& bracket) {
    const auto word_at = [&](double value) {
      for (const Outcome& run : finding_.runs) {
        if (run["settings"][0] == setting(critical_.key, value)) return shown_word(run);
      }
      return std::string("not run");
    };
    finding_.answer = {{"key", critical_.key},
                       {"value", bracket.middle()},
                       {"bracket", {bracket.low, bracket.high}},
                       {"outcomes", {word_at(bracket.low), word_at(bracket.high)}}};
    finding_.text = fmt::format("  {} = {:.9g}\n  {} at {:.9g}, {} at {:.9g}\n", critical_.key, bracket.middle(),
                                word_at(bracket.low), bracket.low, word_at(bracket.high), bracket.high);
    finding_.figure = critical_figure(critical_, finding_.runs, bracket.middle());
    return finding_;
  }

  CriticalValue critical_;
  std::size_t jobs_;
  OutcomeRuns& runs_;
  std::map<double, bool> known_;
  Finding finding_;
};

}  // namespace

OpenStudyTask critical_task(const scene::OpenStudy& study, int jobs) {
  const auto critical = std::get<CriticalValue>(study.question);
  return {.name = study.name,
          .kind = "critical",
          .line = study.line,
          .set = study.set,
          .keys = {critical.key},
          .extremes = {{setting(critical.key, critical.from)}, {setting(critical.key, critical.to)}},
          .until_decided = true,
          .of_factor = critical.target.has_value(),
          .find = [critical, jobs](OutcomeRuns& runs) {
            return Search(critical, static_cast<std::size_t>(jobs), runs).find();
          }};
}

}  // namespace blockweir::study
