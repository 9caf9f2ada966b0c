// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/plot_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "bridge/picture/along_joint.hpp"
#include "bridge/picture/flow_files.hpp"
#include "bridge/picture/gnuplot.hpp"
#include "bridge/picture/history.hpp"

namespace blockweir::picture {
namespace {

/// Names in the order of the table.
std::vector<std::string> joints_of(const Rows& rows) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (std::find(names.begin(), names.end(), rows[i][1]) == names.end()) names.push_back(rows[i][1]);
  }
  return names;
}

/// Pressure at a time over the way along the joint from its upstream end, so that a steep joint is no spike.
std::string pressures(const Rows& rows, double time_s, const std::string& joint) {
  std::vector<JointPoint> points;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i][1] != joint || std::stod(rows[i][0]) != time_s) continue;
    points.push_back({{number_in(rows[i][2]), number_in(rows[i][3])}, number_in(rows[i][5]) / 1000});
  }
  std::string text;
  for (const AlongJoint& p : along_joint(points)) text += fmt::format("{:.8g} {:.6g}\n", p.way_m, p.value);
  return text;
}

std::string flows(const Rows& rows, std::size_t column) {
  constexpr double per_day = 86400;
  std::string text;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    text += fmt::format("{} {:.6g}\n", rows[i][0], per_day * std::stod(rows[i][column]));
  }
  return fmt::format("$flow_{} << EOD\n{}EOD\n", column, text);
}

std::string title(const History& history, double time_s) {
  const auto& times = history.column("time_s");
  const auto row = std::lower_bound(times.begin(), times.end(), time_s - 1e-9) - times.begin();
  if (!history.has_values("upstream_level_m") || row == static_cast<std::ptrdiff_t>(times.size())) {
    return fmt::format("{:.4g} s", time_s);
  }
  const double level_m = history.column("upstream_level_m")[static_cast<std::size_t>(row)];
  return fmt::format("{:.4g} s, level {:.4g} m", time_s, level_m);
}

/// Data of a panel, and the commands that draw it.
struct Panel {
  std::string data;
  std::string commands;
};

std::vector<double> times_of(const Rows& rows) {
  std::vector<double> times;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double time_s = std::stod(rows[i][0]);
    if (times.empty() || times.back() != time_s) times.push_back(time_s);
  }
  return times;
}

/// A colour for each joint: thick at the last time, dashed and thin at the first.
Panel along_joints(const Rows& rows, const std::vector<double>& times, const History& history) {
  constexpr std::size_t most_letters = 48;
  Panel panel;
  std::string curves;
  int colour = 0;
  int number = 0;
  for (const std::string& joint : joints_of(rows)) {
    ++colour;
    const auto add = [&](double time_s, const std::string& look) {
      const std::string data = pressures(rows, time_s, joint);
      if (data.empty()) return;
      panel.data += fmt::format("$at_{} << EOD\n{}EOD\n", ++number, data);
      curves += fmt::format("{}$at_{} with lines lt {} {}", curves.empty() ? "" : ", ", number, colour, look);
    };
    if (times.size() > 1) add(times.front(), "lw 1 dt 2 notitle");
    add(times.back(), "lw 2.5 title " + gnuplot_text(shortened(joint, most_letters)));
  }
  const std::string first = times.size() > 1 ? "; dashed: " + title(history, times.front()) : "";
  panel.commands = fmt::format(
      "set key bmargin center horizontal maxcols 2 samplen 2\nset bmargin 8\nset yrange [0:*]\nset title {}\n"
      "set xlabel 'way along the joint from its upstream end (m)'\n"
      "set ylabel 'pressure in joints (kPa)'\nplot {}\nunset title\n",
      gnuplot_text(title(history, times.back()) + first), curves);
  return panel;
}

/// All joints at the last time, by the colour of their pressure.
Panel map_of_joints(const Rows& rows, double time_s, const History& history) {
  std::string lines;
  for (std::size_t i = 1; i + 1 < rows.size(); ++i) {
    if (std::stod(rows[i][0]) != time_s || rows[i][1] != rows[i + 1][1]) continue;
    for (const auto& row : {rows[i], rows[i + 1]}) {
      lines += fmt::format("{} {} {:.6g}\n", row[2], row[3], std::stod(row[5]) / 1000);
    }
    lines += "\n\n";
  }
  return {fmt::format("$joints << EOD\n{}EOD\n", lines),
          fmt::format("unset key\nset size ratio -1\nset palette defined (0 '#dddddd', 0.01 '#9ecae1', 1 '#08306b')\n"
                      "set title '{}: pressure in joints (kPa)'\nset xlabel 'x (m)'\nset ylabel 'elevation (m)'\n"
                      "plot $joints using 1:2:3 with lines lc palette lw 2\nset size noratio\nunset title\n",
                      title(history, time_s))};
}

Panel over_time(const Rows& rows) {
  Panel panel;
  std::string lines;
  for (std::size_t column = 1; column < rows.front().size(); ++column) {
    if (rows.front()[column].find("_m2_per_s") == std::string::npos) break;
    panel.data += flows(rows, column);
    lines += fmt::format("{}$flow_{} with linespoints pt 7 ps 0.2 lw 2 title {}", column > 1 ? ", " : "", column,
                         gnuplot_text(words_of_flow(rows.front()[column])));
  }
  panel.commands = fmt::format(
      "set key bmargin center horizontal\nset bmargin 6\nset yrange [0:*]\nset xlabel 'time (s)'\n"
      "set ylabel 'flow (m³ a day and metre)'\nplot {}\n",
      lines);
  return panel;
}

/// Of the joint with the highest uplift at the end: its force over time, and those of the guideline laws; none where
/// there is one moment only.
Panel against_laws(const Rows& rows) {
  namespace column = uplift_column;
  if (rows.size() < 2 || rows[1][0] == rows.back()[0]) return {};
  const Rows last = last_rows(rows);
  const auto highest = std::max_element(last.begin(), last.end(), [](const auto& a, const auto& b) {
    return number_in(a[column::uplift]) < number_in(b[column::uplift]);
  });
  Panel panel;
  std::string lines;
  const auto add = [&](std::size_t k, const char* name, const char* look) {
    std::string data;
    for (const auto& row : rows) {
      if (&row == &rows.front() || row[column::joint] != (*highest)[column::joint] || row[k].empty()) continue;
      data += fmt::format("{} {:.6g}\n", row[0], number_in(row[k]) / 1000);
    }
    if (data.empty()) return;
    panel.data += fmt::format("$law_{} << EOD\n{}EOD\n", k, data);
    lines +=
        fmt::format("{}$law_{} with linespoints pt 7 ps 0.2 {} title '{}'", lines.empty() ? "" : ", ", k, look, name);
  };
  add(column::uplift, "flow", "lw 3 lc rgb '#08519c'");
  add(column::triangular, "triangular", "lw 1.5 dt 2 lc rgb '#555555'");
  add(column::drained, "drained", "lw 1.5 dt 4 lc rgb '#2c7a3f'");
  add(column::full, "full", "lw 1.5 dt 3 lc rgb '#d9622b'");
  panel.commands = fmt::format(
      "set key bmargin center horizontal\nset bmargin 6\nset yrange [0:*]\nset xlabel 'time (s)'\n"
      "set ylabel 'uplift (kN/m)'\n"
      "set title {}\nplot {}\nunset title\n",
      gnuplot_text("joint " + (*highest)[column::joint]), lines);
  return panel;
}

}  // namespace

std::vector<Picture> flow_picture(const std::filesystem::path& run, const nlohmann::json& summary,
                                  const std::string& ending) {
  const Rows along = flow_rows(run, "joint_water.csv", summary);
  const Rows totals = flow_rows(run, "flow.csv", summary);
  if (along.size() < 2 || totals.size() < 2) return {};
  std::set<std::string> joints;
  for (std::size_t i = 1; i < along.size(); ++i) joints.insert(along[i][1]);
  const std::vector<double> times = times_of(along);
  const History history(run / "history.csv");
  constexpr std::size_t few = 12;
  const Panel above =
      joints.size() <= few ? along_joints(along, times, history) : map_of_joints(along, times.back(), history);
  const Panel below = over_time(totals);
  const Panel laws = against_laws(flow_rows(run, "joint_uplift.csv", summary));
  const int panels = laws.commands.empty() ? 2 : 3;
  return {{run / ("flow" + ending), 900, 400.0 * panels,
           above.data + below.data + laws.data +
               fmt::format("set multiplot layout {},1\nset grid lc rgb '#dddddd'\nset tics out nomirror\n{}{}{}unset "
                           "multiplot\n",
                           panels, above.commands, below.commands, laws.commands)}};
}

}  // namespace blockweir::picture
