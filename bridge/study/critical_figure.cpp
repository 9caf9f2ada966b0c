// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/critical_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "bridge/picture/gnuplot.hpp"
#include "bridge/study/key_label.hpp"

namespace blockweir::study {
namespace {

/// What stands at the y axis over each value.
struct Heights {
  std::map<double, double> of_value{};
  std::vector<std::string> words{};  ///< at 0, 1, ...; none: the heights are factors
};

Heights heights_of(const scene::CriticalValue& critical, const std::vector<Outcome>& runs) {
  Heights heights;
  const auto value_of = [&](const Outcome& run) { return std::stod(value_in(run, critical.key)); };
  for (const Outcome& run : runs) {  // without a factor it stands or fails at any strength
    if (critical.target && run["factor"].is_number()) heights.of_value[value_of(run)] = run["factor"];
  }
  if (!heights.of_value.empty()) return heights;
  for (const Outcome& run : runs) {
    const std::string word = shown_word(run);
    auto row = std::find(heights.words.begin(), heights.words.end(), word);
    if (row == heights.words.end()) row = heights.words.insert(row, word);
    heights.of_value[value_of(run)] = static_cast<double>(row - heights.words.begin());
  }
  return heights;
}

/// The values with some room beside them; a quantity that is never negative has no axis below 0.
std::string range_of(const std::map<double, double>& of_value) {
  if (of_value.empty()) return "[*:*]";
  const double low = of_value.begin()->first;
  const double high = of_value.rbegin()->first;
  const double room = 0.03 * (high - low);
  return high > low ? fmt::format("[{:.9g}:{:.9g}]", low < 0 ? low - room : std::max(0.0, low - room), high + room)
                    : "[*:*]";
}

}  // namespace

std::string critical_figure(const scene::CriticalValue& critical, const std::vector<Outcome>& runs, double found) {
  const Heights heights = heights_of(critical, runs);
  std::string figure = fmt::format(
      "set xlabel {}\nset key outside top horizontal\nset grid\nset rmargin 6\n"  // of the last number's half
      "set xrange {}\nset offsets 0, 0, graph 0.05, graph 0.05\n"
      "set arrow from first {:.9g}, graph 0 to first {:.9g}, graph 1 nohead dt 2 lc rgb '#555753'\n",
      picture::gnuplot_text(key_label(critical.key)), range_of(heights.of_value), found, found);
  std::string legend = fmt::format(", NaN dt 2 lc rgb '#555753' title 'found: {:.5g}'", found);
  if (heights.words.empty()) {
    figure += fmt::format(
        "set ylabel 'factor of safety'\nset arrow from graph 0, first {:.9g} to graph 1, first {:.9g} nohead lc rgb "
        "'#c00000'\n",
        *critical.target, *critical.target);
    legend += fmt::format(", NaN lc rgb '#c00000' title 'target: {:.5g}'", *critical.target);
  } else {
    std::string tics;
    for (const std::string& word : heights.words) {
      tics +=
          fmt::format("{}{} {}", tics.empty() ? "" : ", ", picture::gnuplot_tic(word), &word - heights.words.data());
    }
    figure +=
        fmt::format("set ytics ({})\nset yrange [-0.5:{}]\n", tics, static_cast<double>(heights.words.size()) - 0.5);
  }
  std::string points;
  for (const auto& [value, height] : heights.of_value) points += fmt::format("{:.9g} {:.9g}\n", value, height);
  return fmt::format("{}$runs << EOD\n{}EOD\nplot $runs with {} pt 7 lc rgb '#204a87' title 'runs'{}\n", figure, points,
                     heights.words.empty() ? "linespoints" : "points", legend);
}

}  // namespace blockweir::study
