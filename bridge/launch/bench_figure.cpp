// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/launch/bench_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "bridge/launch/gnuplot.hpp"

namespace blockweir::launch {
namespace {

constexpr double least_error = 1e-16;  // what is exact has a place on the axis, too

std::string coordinates(const Point& p) {
  return fmt::format("{} {}\n", p.time_s, std::max(p.error, least_error));
}

}  // namespace

void draw_bench(const std::filesystem::path& file, const std::string& title, const std::string& figure,
                const std::vector<Point>& points) {
  std::string script = fmt::format(
      "set terminal pngcairo font 'sans,11' size 900,640\nset output {}\nset title {}\nset logscale xy\n"
      "set format y '%.0e'\nset xlabel 'wall time [s]'\nset ylabel {}\nset key outside right\nset grid\n"
      "set offsets graph 0.03, graph 0.03, graph 0.03, graph 0.03\n",
      gnuplot_path(file), gnuplot_text(title), gnuplot_text("relative error of " + figure));
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
  gnuplot(script + "plot " + plots + "\n");
}

}  // namespace blockweir::launch
