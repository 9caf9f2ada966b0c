// SPDX-License-Identifier: GPL-3.0-or-later
// A map as a picture and as letters.
#include "bridge/study/map_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bridge/picture/gnuplot.hpp"
#include "bridge/study/key_label.hpp"

namespace blockweir::study {
namespace {

using picture::gnuplot_text;

using nlohmann::json;

struct Word {
  const char* word;
  char letter;
  const char* colour;
};
constexpr std::array<Word, 16> outcomes{{{"stands", '.', "#73a946"},
                                         {"moving", 'm', "#ad7fa8"},
                                         {"sliding", 's', "#3465a4"},
                                         {"overturning", 'o', "#e08e0b"},
                                         {"sliding and overturning", 'b', "#a0408a"},
                                         {"lifting", 'l', "#06989a"},
                                         {"falling", 'f', "#555753"},
                                         {"stable", '-', "#73a946"},
                                         {"grows", 'g', "#e08e0b"},
                                         {"hold", '.', "#73a946"},
                                         {"energy made", 'e', "#cc0000"},
                                         {"in each other", 'i', "#a40000"},
                                         {"right", '.', "#73a946"},
                                         {"refused", 'r', "#d3d7cf"},
                                         {"stopped", 'x', "#babdb6"},
                                         {"wrong", 'X', "#f57900"}}};
constexpr std::size_t most_labels = 200;  // more would cover each other

bool has(const json& cells, const char* word) {
  return std::any_of(cells.begin(), cells.end(), [&](const json& cell) { return cell["shown"] == word; });
}

std::string tics(const char* axis, const scene::Sweep& sweep) {
  std::string text = fmt::format("set {}tics {} (", axis, *axis == 'x' ? "rotate by -40" : "");
  for (std::size_t i = 0; i < sweep.values.size(); ++i)
    text += fmt::format("{}{} {}", i == 0 ? "" : ", ", picture::gnuplot_tic(sweep.values[i]), i);
  return text + fmt::format(")\nset {}range [-0.5:{}]\nset {}label {}\n", axis,
                            static_cast<double>(sweep.values.size()) - 0.5, axis, gnuplot_text(key_label(sweep.key)));
}

}  // namespace

char letter(const std::string& word) {
  const auto* found = std::find_if(outcomes.begin(), outcomes.end(), [&](const Word& one) { return word == one.word; });
  return found == outcomes.end() ? '?' : found->letter;
}

std::string colour(const std::string& word) {
  const auto* found = std::find_if(outcomes.begin(), outcomes.end(), [&](const Word& one) { return word == one.word; });
  return found == outcomes.end() ? "#000000" : found->colour;
}

std::string legend(const json& cells) {
  std::string text;
  for (const Word& one : outcomes) {
    if (has(cells, one.word)) text += fmt::format("  {} {}", one.letter, one.word);
  }
  const auto is_wrong = [](const json& cell) { return cell["verdict"] == "wrong"; };
  if (std::any_of(cells.begin(), cells.end(), is_wrong)) text += fmt::format("  {} not as expected", wrong_mark);
  return text + "\n";
}

std::string map_figure(const std::array<scene::Sweep, 2>& axes, const json& cells) {
  std::string figure = tics("x", axes[0]) + tics("y", axes[1]) +
                       "set key outside top horizontal\nset style fill solid border lc rgb 'white'\n";
  std::string curves;
  const std::size_t columns = axes[0].values.size();
  const std::size_t rows = axes[1].values.size();
  const auto plot = [&](const std::string& name, const std::string& style, const auto& row_of) {
    std::string points;
    for (std::size_t i = 0; i < cells.size(); ++i) {  // rows from the last down
      if (const std::string more = row_of(cells[i]); !more.empty())
        points += fmt::format("{} {} {}\n", i % columns, rows - 1 - i / columns, more);
    }
    if (points.empty()) return;
    figure += fmt::format("${} << EOD\n{}EOD\n", name, points);
    curves += fmt::format("{}${} {}", curves.empty() ? "" : ", ", name, style);
  };
  for (const Word& one : outcomes) {
    plot(fmt::format("m{}", &one - outcomes.data()),
         fmt::format("with boxxyerror fc rgb '{}' title '{}'", one.colour, one.word),
         [&](const json& cell) { return cell["shown"] == one.word ? "0.5 0.5" : ""; });
  }
  if (cells.size() <= most_labels) {
    plot("errors", "with labels font ',8' notitle", [](const json& cell) -> std::string {
      const bool number = cell.contains("got") && cell["got"].is_number();
      return number ? fmt::format("{:.0e}", cell["error"].get<double>()) : "";
    });
  }
  plot("wrong", "pt 2 ps 2 lw 3 lc rgb '#ef2929' title 'not as expected'",
       [](const json& cell) { return cell["verdict"] == "wrong" ? "0" : ""; });
  return figure + "plot " + curves + "\n";
}

}  // namespace blockweir::study
