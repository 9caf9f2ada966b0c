// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/validate/bench_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "bridge/picture/draw.hpp"
#include "bridge/picture/gnuplot.hpp"

namespace blockweir::study {
namespace {

using picture::gnuplot_text;

constexpr double least_error = 1e-16;  // what is exact has a place on the axis, too

double shown(double error) {
  return std::max(error, least_error);
}

std::string coordinates(const Point& p) {
  return fmt::format("{} {}\n", p.time_s, shown(p.error));
}

/// Axes that end close to the points: gnuplot's own end at whole decades.
std::string ranges(const std::vector<Point>& points) {
  const auto [fast, slow] = std::minmax_element(points.begin(), points.end(),
                                                [](const Point& a, const Point& b) { return a.time_s < b.time_s; });
  const auto [fine, coarse] = std::minmax_element(points.begin(), points.end(),
                                                  [](const Point& a, const Point& b) { return a.error < b.error; });
  return fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", fast->time_s / 1.3, slow->time_s * 1.3,
                     shown(fine->error) / 2, shown(coarse->error) * 2);
}

/// At 1, 2 and 5 of each decade: times often span less than one.
std::string time_tics() {
  std::string tics;
  for (int decade = -3; decade <= 4; ++decade) {
    for (const int digit : {1, 2, 5}) tics += fmt::format("{}{}e{}", tics.empty() ? "" : ", ", digit, decade);
  }
  return "set xtics (" + tics + ")\n";
}

}  // namespace

void draw_bench(const std::filesystem::path& file, const std::string& title, const std::string& error,
                const std::vector<Point>& points) {
  std::string script = fmt::format(
      "set title {}\nset logscale xy\n"
      "set format x '%g'\nset format y '%.0e'\nset xlabel 'wall time (s)'\nset ylabel {}\nset grid\n"
      "set key outside right top Left reverse font ',9'\n{}{}",
      gnuplot_text(title), gnuplot_text(error), ranges(points), time_tics());
  std::string plots;
  const auto plot = [&](const std::string& data, const std::string& style) {
    const auto number = std::count(plots.begin(), plots.end(), '$');
    script += fmt::format("$d{} << EOD\n{}EOD\n", number, data);
    plots += fmt::format("{}$d{} {}", plots.empty() ? "" : ", ", number, style);
  };
  std::string best;
  for (const std::size_t i : front(points)) best += coordinates(points[i]);
  plot(best, "with steps lw 6 lc rgb '#dddddd' title 'front'");
  std::map<std::string, std::string> curves;
  std::vector<std::string> names;
  for (const Point& p : points) {
    if (p.setting.empty()) continue;
    if (!curves.contains(p.curve)) names.push_back(p.curve);
    curves[p.curve] += coordinates(p);
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    plot(curves[names[i]],
         fmt::format("with linespoints lw 1.5 pt {} lt {} title {}", 4 + i % 10, i + 1, gnuplot_text(names[i])));
  }
  plot(coordinates(points.front()), "pt 3 ps 3 lw 3 lc rgb 'black' title 'as it stands'");
  picture::draw({{file, 1100, 560, script + "plot " + plots + "\n", 11}});
}

}  // namespace blockweir::study
