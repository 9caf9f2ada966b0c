// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/plot_snapshots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "bridge/picture/frames.hpp"
#include "bridge/picture/gnuplot.hpp"
#include "bridge/picture/openfoam_water.hpp"
#include "bridge/picture/silt.hpp"
#include "bridge/picture/still_pools.hpp"
#include "bridge/process/programs.hpp"
#include "bridge/results/counted.hpp"

namespace blockweir::picture {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string polygon(int& number, const json& outline, const View& view, const char* style) {
  std::vector<Eigen::Vector2d> whole;
  for (const json& p : outline) whole.emplace_back(p[0].get<double>(), p[1].get<double>());
  return gnuplot_polygon(number, whole, view, style);
}

std::string pools(int& number, const json& frame, const View& view) {
  std::string text;
  for (const auto& pool : still_pools(frame, view)) {
    text += gnuplot_polygon(number, pool, view, "fc rgb '#9fc5e8' fillstyle solid border lc rgb '#9fc5e8' behind");
  }
  return text;
}

std::string silt(int& number, const json& frame, const View& view) {
  std::string text;
  if (!frame.contains("silt_level_m")) return text;
  for (const auto& body : silt_bodies(frame, frame["silt_level_m"], view)) {
    text += gnuplot_polygon(number, body, view,
                            "fc rgb '#795548' fillstyle transparent pattern 4 border lc rgb '#795548' behind");
  }
  return text;
}

/// The larger principal stress of meshed blocks: red where tension, blue where compression, by `largest`.
std::string stress(int& number, const json& frame, const View& view, double& largest) {
  std::string text;
  const json triangles = frame.value("triangles", json::array());
  for (const json& t : triangles) largest = std::max(largest, std::abs(t[6].get<double>()));
  for (const json& t : triangles) {
    const double share = largest > 0 ? t[6].get<double>() / largest : 0;
    const auto pale = static_cast<int>(std::lround(255 * (1 - std::min(1.0, std::abs(share)))));
    const std::string colour =
        share > 0 ? fmt::format("#ff{0:02x}{0:02x}", pale) : fmt::format("#{0:02x}{0:02x}ff", pale);
    const json corners = {{t[0], t[1]}, {t[2], t[3]}, {t[4], t[5]}};
    text += polygon(number, corners, view,
                    fmt::format("fc rgb '{0}' fillstyle solid border lc rgb '{0}' lw 0.5", colour).c_str());
  }
  return text;
}

std::string bolts(const json& frame) {
  std::string text = "unset arrow\n";
  const json drawn = frame.value("bolts", json::array());
  for (const json& b : drawn) {
    text += fmt::format("set arrow from {},{} to {},{} nohead lw 3 lc rgb '#b03060' front\n", b[0].get<double>(),
                        b[1].get<double>(), b[2].get<double>(), b[3].get<double>());
  }
  return text;
}

/// Boxes of moving water as a data block: edges and colour, the darker the faster.
std::string flow(const std::vector<WaterBox>& boxes, const View& view, double fastest) {
  std::string text = "$water << E\n";
  constexpr double overlap = 0.15;  // of a box: no seams between neighbours
  for (const WaterBox& b : boxes) {
    if (b.right < view.left || b.left > view.right || b.top < view.bottom || b.bottom > view.top) continue;
    const double share = std::min(1.0, b.speed / fastest);
    const auto mix = [&](double slow, double fast) {
      return static_cast<int>(255 + b.share * (slow + share * (fast - slow) - 255));
    };
    const double dx = overlap * (b.right - b.left);
    const double dy = overlap * (b.top - b.bottom);
    text += fmt::format("{} {} {} {} {} {} {}\n", (b.left + b.right) / 2, (b.bottom + b.top) / 2,
                        std::max(view.left, b.left - dx), std::min(view.right, b.right + dx),
                        std::max(view.bottom, b.bottom - dy), std::min(view.top, b.top + dy),
                        mix(0x9f, 0x0b) * 65536 + mix(0xc5, 0x3d) * 256 + mix(0xe8, 0x91));
  }
  return text + "E\n";
}

/// Of the points that mark contacts: no larger than half of the blocks can carry.
double marker_size(const json& frame, const View& view) {
  constexpr double most_per_width = 40;  // points of size 1 beside each other, over a panel
  std::vector<double> widths;
  for (const json& block : frame["blocks"]) {
    if (block["fixed"].get<bool>()) continue;
    double low = view.right;
    double high = view.left;
    for (const json& p : block["outline"])
      low = std::min(low, p[0].get<double>()), high = std::max(high, p[0].get<double>());
    widths.push_back(high - low);
  }
  if (widths.empty()) return 1;
  const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
  std::nth_element(widths.begin(), middle, widths.end());
  return std::clamp(most_per_width / 2 * *middle / (view.right - view.left), 0.2, 1.0);
}

/// Digits behind the point that tell the moments of a run apart.
int decimals_of(double end_s) {
  return end_s > 0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(end_s))), 2, 9) : 2;
}

/// What a picture of several moments has in common.
struct Film {
  View view;
  double breached_s;  // from then on still water has no place; infinite where it keeps its own
  int decimals;       // of the time
};

std::string moment(const json& frame, const Film& film, bool contacts, const std::string& water = "") {
  const View& view = film.view;
  const double breached_s = film.breached_s;
  int number = 0;
  const bool breached = frame["time_s"].get<double>() >= breached_s && water.empty();
  std::string text = "unset object\n" + water;
  const std::string layer = water.empty() ? "" : " front";  // over the water's boxes
  if (water.empty() && !breached) text += pools(number, frame, view) + silt(number, frame, view);
  for (const json& block : frame["blocks"]) {
    const bool fixed = block["fixed"].get<bool>();
    const std::string style = fixed ? "fc rgb '#8d7f6d' fillstyle solid border lc rgb '#5b5146' lw 1"
                                    : "fc rgb '#c9c9c4' fillstyle solid border lc rgb '#303030' lw 1.5";
    text += polygon(number, block["outline"], view, (style + layer).c_str());
  }
  double largest = 0;
  text += stress(number, frame, view, largest);
  text += bolts(frame);
  std::string level;
  if (frame["upstream_level_m"].is_number()) {
    level = fmt::format(", level {:.2f} m{}", frame["upstream_level_m"].get<double>(),
                        water.empty() && above_all(frame) ? " (above all blocks)" : "");
  }
  if (breached) level = fmt::format(", breached at {:.2f} s", breached_s);
  if (const std::size_t out = blocks_beyond(frame, view); out > 0) {
    level += ", " + results::counted(out, "block") + " beyond the picture";
  }
  text +=
      fmt::format("set title '{:.{}f} s{}'\nset xrange [{}:{}]\nset yrange [{}:{}]\n", frame["time_s"].get<double>(),
                  film.decimals, level, view.left, view.right, view.bottom, view.top);
  if (!water.empty()) {
    return text + "plot $water using 1:2:3:4:5:6:7 with boxxyerror fillstyle solid noborder lc rgb variable notitle\n";
  }
  std::string points;
  for (const json& c : frame["contacts"]) {
    const int state = c[2];
    if (contacts && state > 0) points += fmt::format("{} {} {}\n", c[0].get<double>(), c[1].get<double>(), state);
  }
  if (largest > 0) {
    text += fmt::format(
        "set palette defined (-1 '#0000ff', 0 '#ffffff', 1 '#ff0000')\nset cbrange [{0}:{1}]\n"
        "set cbtics ('{0:.3g}' {0}, '0' 0, '{1:.3g}' {1})\nset colorbox\n",
        -largest / 1e6, largest / 1e6);
    if (points.empty()) return text + "plot NaN with points palette notitle\n";
  }
  if (points.empty()) return text + "plot NaN notitle\n";
  text += fmt::format("$contacts << E\n{}E\n", points);
  return text + fmt::format(
                    "plot {}$contacts using 1:2:($3 == 2 ? 0xd00000 : 0x1a7f37) with points pt 7 ps {:.2g} lc rgb "
                    "variable notitle\n",
                    largest > 0 ? "NaN with points palette notitle, " : "", marker_size(frame, view));
}

/// At least `least`: 1, 2 or 5 times a power of ten.
double round_step(double least) {
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10 * power;
}

/// The speed of the darkest water [m/s]: the largest of these moments, rounded up.
double darkest_speed(const OpenFoamWater& water, const std::vector<json>& frames,
                     const std::vector<std::size_t>& picks) {
  constexpr double least = 0.1;  // what stands is never quite at rest
  constexpr double most = 12;    // spray, a few cells of it, is as dark
  double fastest = least;
  for (const std::size_t pick : picks) {
    for (const WaterBox& box : water.boxes(frames[pick]["time_s"])) fastest = std::max(fastest, box.speed);
  }
  return std::min(most, round_step(fastest));
}

/// Steps of the axes' numbers that leave room between them, in a panel so many points wide.
std::string tics(const View& view, double panel_points) {
  constexpr double tall_points = 40;  // that a number needs
  constexpr double wide_points = 80;
  const double m_per_point = (view.right - view.left) / panel_points;
  const double quarter = (view.top - view.bottom) / 4;  // flat pictures, too, have more numbers than one
  return fmt::format("set ytics {}\nset xtics {}\n", round_step(std::min(tall_points * m_per_point, quarter)),
                     round_step(wide_points * m_per_point));
}

/// Six moments from just before the failure to the end, or over the whole run when nothing fails. `with_start`: the
/// first of them is the start, where the scene draws water that then falls.
std::vector<std::size_t> chosen(const std::vector<json>& frames, const json& summary, bool with_start) {
  double from = frames.front()["time_s"];
  const double to = frames.back()["time_s"];
  if (summary.contains("failure")) from = std::min(summary["failure"]["time_s"].get<double>(), to);
  std::vector<std::size_t> picks;
  const bool start_first = with_start && from > frames.front()["time_s"].get<double>();
  if (start_first) picks.push_back(0);
  const int last = start_first ? 4 : 5;
  for (int k = 0; k <= last; ++k) {
    const double due = from + (to - from) * k / last;
    const auto next = std::lower_bound(frames.begin(), frames.end(), due,
                                       [](const json& f, double t) { return f["time_s"].get<double>() < t; });
    const auto pick = std::min<std::size_t>(static_cast<std::size_t>(next - frames.begin()), frames.size() - 1);
    if (picks.empty() || picks.back() != pick) picks.push_back(pick);
  }
  return picks;
}

}  // namespace

std::vector<Picture> snapshot_pictures(const fs::path& run, const json& summary, const std::string& ending,
                                       bool animated) {
  std::vector<json> frames = read_frames(run);
  const OpenFoamWater water(run);
  const std::optional<double> silt_m = water.empty() ? silt_level_m(process::scene_of(run)) : std::nullopt;
  for (json& frame : frames) {
    if (silt_m) frame["silt_level_m"] = *silt_m;
  }
  const auto drawn_water =
      water.empty() ? std::vector<std::vector<geometry::Point>>() : all_drawn_water(run, frames[0]);
  const auto picks = chosen(frames, summary, !drawn_water.empty());
  double highest = water.empty() ? 1e300 : -1e300;
  for (const WaterBox& box : water.boxes(0)) highest = std::max(highest, box.top);
  const View view = with_drawn_water(view_of(frames, highest), drawn_water);
  const double aspect = std::clamp((view.top - view.bottom) / (view.right - view.left), 0.12, 2.0);
  const std::string axes =
      "set size ratio -1\nunset key\nset tics out nomirror\nset style fill solid\nset xlabel 'x (m)'\n"
      "set ylabel 'elevation (m)'\n";
  const double breached_s =
      summary.contains("breach") ? summary["breach"]["time_s"].get<double>() : std::numeric_limits<double>::infinity();
  const double darkest = darkest_speed(water, frames, picks);
  const auto flow_at = [&](const json& frame) {
    return water.empty() ? "" : flow(water.boxes(frame["time_s"]), view, darkest);
  };
  const Film film{view, breached_s, decimals_of(frames.back()["time_s"])};
  const bool meshed = frames.front().contains("triangles");
  const std::string scale = meshed ? "; larger principal stress (MPa)" : "";
  const std::string legend =
      water.empty() ? fmt::format(" (contacts: green stick, red slip{}{})", silt_m ? "; hatched: silt" : "", scale)
                    : fmt::format(" (water: the darker the faster, up to {} m/s)", darkest);
  const std::string title = summary.value("title", std::string("section"));
  const std::size_t columns = std::min<std::size_t>(3, picks.size());
  const std::size_t rows = (picks.size() + 2) / 3;
  std::string snapshots =
      axes + tics(view, 390) +
      fmt::format("set multiplot layout {},{} title {}\n", rows, columns, gnuplot_title(title + legend, 450 * columns));
  for (const std::size_t pick : picks) snapshots += moment(frames[pick], film, true, flow_at(frames[pick]));
  std::vector<Picture> pictures{{run / ("snapshots" + ending), 450.0 * columns,
                                 60 + rows * (60 + (meshed ? 330 : 430) * aspect), snapshots + "unset multiplot\n"}};
  // Where a structure falls, what is left at the end shows no longer how.
  const bool fails = summary.contains("failure") && picks.size() > 1;
  const json& one = frames[fails ? picks[picks.size() * 2 / 3] : picks.back()];
  const std::string when =
      fails ? fmt::format("between the failure and the end at {:.4g} s", frames.back()["time_s"].get<double>())
            : "the end of the run";
  const double wide = meshed ? 720 : 900;  // beside the scale of stresses
  pictures.push_back(
      {run / ("picture" + ending), 1000, 120 + 1.04 * wide * aspect,
       axes + tics(view, wide / 1.5) +
           fmt::format("set multiplot layout 1,1 title {}\n{}unset multiplot\n",
                       gnuplot_title(title + ": " + when + scale, 1000), moment(one, film, false, flow_at(one)))});
  if (!animated) return pictures;
  std::string all = axes + tics(view, 800);
  for (const json& frame : frames) {
    all += moment(frame, film, false, flow_at(frame)) + one_more_drawn;
  }
  pictures.push_back({run / "animation.gif", 900, 80 + 840 * aspect, all});
  return pictures;
}

}  // namespace blockweir::picture
