// SPDX-License-Identifier: GPL-3.0-or-later
// [[map]]: a word over two keys, as the mode of failure, each cell against the word of a formula.
#include <fmt/format.h>

#include <array>
#include <set>

#include "bridge/launch/gnuplot.hpp"
#include "bridge/launch/study.hpp"

namespace blockweir::launch {
namespace {

using nlohmann::json;

struct Word {
  const char* word;
  char letter;
  const char* colour;
};
constexpr std::array<Word, 7> words{{{"stands", '.', "#73a946"},
                                     {"sliding", 's', "#3465a4"},
                                     {"overturning", 'o', "#e08e0b"},
                                     {"sliding and overturning", 'b', "#a0408a"},
                                     {"falling", 'f', "#555753"},
                                     {"stable", '-', "#73a946"},
                                     {"grows", 'g', "#e08e0b"}}};

char letter(const std::string& word) {
  for (const Word& one : words) {
    if (word == one.word) return one.letter;
  }
  return '?';
}

/// A square a cell in the colour of its word, a red cross on wrong ones.
std::string map_figure(const scene::MapStudy& study, const json& cells) {
  std::string figure = fmt::format(
      "set xlabel {}\nset ylabel {}\nset key outside bottom horizontal\nset offsets "
      "graph 0.05, graph 0.05, graph 0.05, graph 0.05\n",
      gnuplot_text(study.keys[0]), gnuplot_text(study.keys[1]));
  std::string curves;
  const auto plot = [&](const std::string& name, const std::string& style, const auto& holds) {
    std::string points;
    for (const json& cell : cells) {
      if (holds(cell)) points += fmt::format("{} {}\n", cell["x"].get<double>(), cell["y"].get<double>());
    }
    if (points.empty()) return;
    figure += fmt::format("${} << EOD\n{}EOD\n", name, points);
    curves += fmt::format("{}${} {}", curves.empty() ? "" : ", ", name, style);
  };
  for (const Word& one : words) {
    plot(fmt::format("m{}", &one - words.data()),
         fmt::format("pt 5 ps 2.5 lc rgb '{}' title '{}'", one.colour, one.word),
         [&](const json& cell) { return cell["got"] == one.word; });
  }
  plot("wrong", "pt 2 ps 2 lw 3 lc rgb '#ef2929' title 'not so'",
       [](const json& cell) { return cell["got"] != cell["expected"]; });
  return figure + "plot " + curves + "\n";
}

StudyResult draw_map(const scene::MapStudy& study, StudyRuns& runs) {
  StudyResult result;
  int wrong = 0;
  std::string differences;
  std::set<std::string> seen;
  // Rows from the largest value down, as a map has its north on top; a cell that differs has the formula's letter too.
  for (auto y = study.values[1].rbegin(); y != study.values[1].rend(); ++y) {
    result.text += fmt::format("  {:>10.6g} ", *y);
    for (const double x : study.values[0]) {
      const Settings cell{setting(study.keys[0], x), setting(study.keys[1], *y)};
      const json check = runs.run(cell, study.expected)["checks"][0];
      const std::string got = check["got"];
      const std::string expected = check["expected"];
      seen.insert({got, expected});
      const bool right = got == expected;
      wrong += right ? 0 : 1;
      result.runs.push_back({{"x", x}, {"y", *y}, {"expected", expected}, {"got", got}});
      result.text += fmt::format(" {}{}", letter(got), right ? ' ' : letter(expected));
      if (!right) differences += fmt::format("  {}, {}: {}, but {} by the formula\n", cell[0], cell[1], got, expected);
    }
    result.text += "\n";
  }
  result.text += fmt::format("  {} rightwards from {:.6g} to {:.6g}; {} upwards\n", study.keys[0],
                             study.values[0].front(), study.values[0].back(), study.keys[1]);
  for (const Word& one : words) {
    if (seen.contains(one.word)) result.text += fmt::format("  {} {}", one.letter, one.word);
  }
  result.text += "\n" + differences;
  result.check = {{"name", fmt::format("wrong of {} cells", result.runs.size())},
                  {"expected", 0},
                  {"got", wrong},
                  {"relative_error", static_cast<double>(wrong)},
                  {"tolerance", 0.0},
                  {"passed", wrong == 0},
                  {"formula", study.expected.formula},
                  {"source", study.expected.source}};
  result.figure = map_figure(study, result.runs);
  return result;
}

}  // namespace

StudyTask map_task(const scene::MapStudy& study) {
  StudyTask task{.name = study.name, .set = study.set};
  for (const double x : study.values[0]) {
    for (const double y : study.values[1])
      task.extremes.push_back({setting(study.keys[0], x), setting(study.keys[1], y)});
  }
  task.go = [study](StudyRuns& runs) { return draw_map(study, runs); };
  return task;
}

}  // namespace blockweir::launch
