// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/plot_spectrum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/picture/gnuplot.hpp"
#include "bridge/picture/response_spectrum.hpp"
#include "bridge/process/programs.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::picture {
namespace {

constexpr double damping_ratio = 0.05;

struct Component {
  const char* name;
  const char* colour;
  const scene::TimeTable* acceleration;
};

bool moves(const scene::TimeTable& a) {
  return a.sine || std::any_of(a.value.begin(), a.value.end(), [](double value) { return value != 0; });
}

std::string over_time(const Component& c, double duration_s) {
  constexpr int points = 4000;
  std::string rows;
  for (int i = 0; i <= points; ++i) {
    const double t = duration_s * i / points;
    rows += fmt::format("{:.6g} {:.6g}\n", t, c.acceleration->at(t));
  }
  return fmt::format("$time_{} << EOD\n{}EOD\n", c.name, rows);
}

/// From 0.02 s to 5 s.
std::string over_periods(const Component& c, double duration_s) {
  constexpr int points = 120;
  std::string rows;
  for (int i = 0; i <= points; ++i) {
    const double period = 0.02 * std::pow(250.0, static_cast<double>(i) / points);
    rows +=
        fmt::format("{:.5g} {:.6g}\n", period, pseudo_acceleration(*c.acceleration, duration_s, period, damping_ratio));
  }
  return fmt::format("$spectrum_{} << EOD\n{}EOD\n", c.name, rows);
}

}  // namespace

std::vector<Picture> spectrum_picture(const std::filesystem::path& run, const std::string& ending) {
  const scene::Scene scene = scene::read(process::scene_of(run)).scene;
  if (!scene.base_motion) return {};
  const double duration_s = scene.analysis.duration_s;
  std::string script;
  std::string history;
  std::string spectrum;
  for (const Component& c : {Component{"x", "#1f6fb4", &scene.base_motion->acceleration_x_m_per_s2},
                             Component{"y", "#d9622b", &scene.base_motion->acceleration_y_m_per_s2}}) {
    if (!moves(*c.acceleration)) continue;
    script += over_time(c, duration_s) + over_periods(c, duration_s);
    const char* comma = history.empty() ? "" : ", ";
    history += fmt::format("{}$time_{} with lines lc rgb '{}' lw 1 title '{}'", comma, c.name, c.colour, c.name);
    spectrum += fmt::format("{}$spectrum_{} with lines lc rgb '{}' lw 2 title '{}'", comma, c.name, c.colour, c.name);
  }
  if (history.empty()) return {};
  const std::string title = scene.title.empty() ? run.filename().string() : scene.title;
  return {{run / ("spectrum" + ending), 900, 760,
           script + fmt::format(
                        "set multiplot layout 2,1 title {}\nset grid lc rgb '#dddddd'\nset lmargin 10\n"
                        "set tics out nomirror\nset key top right\nset xlabel 'time (s)'\n"
                        "set ylabel 'acceleration of the ground (m/s²)'\nplot {}\nset logscale x\nset xrange [0.02:5]\n"
                        "set xlabel 'period (s)'\nset ylabel 'pseudo-acceleration (m/s²)'\nset title 'response "
                        "spectrum, damping "
                        "ratio {}'\nplot {}\n"
                        "unset multiplot\n",
                        gnuplot_title(title + ": the ground's acceleration", 900), history, damping_ratio, spectrum)}};
}

}  // namespace blockweir::picture
