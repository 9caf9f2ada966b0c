// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/plot_section.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "bridge/picture/frames_data.hpp"
#include "bridge/picture/gnuplot.hpp"
#include "bridge/picture/json_point.hpp"
#include "bridge/picture/label_places.hpp"
#include "bridge/picture/load_diagrams.hpp"
#include "bridge/picture/pictured_state.hpp"
#include "bridge/picture/section_data.hpp"
#include "bridge/picture/view.hpp"
#include "bridge/process/programs.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::picture {
namespace {

using nlohmann::json;
using Point = Eigen::Vector2d;

constexpr const char* joint_colour = "#b3261e";
constexpr const char* water_colour = "#1f6fb4";

/// The figure's frame in m, and its margins and texts in pixels.
struct Sheet {
  static constexpr double width = 1000;
  static constexpr double left = 80;
  static constexpr double right = 30;
  static constexpr double top = 70;  // a title of two lines
  static constexpr double below_axis = 72;
  static constexpr double row = 21;
  static constexpr double letter = 8.2;
  View view;
  double legend_rows;

  [[nodiscard]] double per_pixel() const { return (view.right - view.left) / (width - left - right); }
  [[nodiscard]] double bottom() const { return below_axis + row * legend_rows; }
  [[nodiscard]] double height() const { return top + bottom() + (view.top - view.bottom) / per_pixel(); }
};

/// gnuplot's commands for the elements of the picture, from back to front.
class Drawing {
 public:
  explicit Drawing(const Sheet& sheet)
      : sheet_(sheet),
        places_({Point(sheet.view.left, sheet.view.bottom) + Point::Constant(inset * sheet.per_pixel()),
                 Point(sheet.view.right, sheet.view.top) - Point::Constant(inset * sheet.per_pixel())}) {}

  static constexpr double inset = 8;  // pixels, of labels from the frame

  void polygon(const json& outline, const std::string& style) {
    std::vector<Point> points;
    for (const json& p : outline) points.emplace_back(p[0].get<double>(), p[1].get<double>());
    script += gnuplot_polygon(objects_, points, sheet_.view, style);
  }
  void line(const Point& from, const Point& to, const std::string& style) {
    script += fmt::format("set arrow from {},{} to {},{} {} front\n", from.x(), from.y(), to.x(), to.y(), style);
    const Point step = (to - from) / 40;
    const Point half = Point::Constant(3 * sheet_.per_pixel());
    for (int i = 0; i <= 40; ++i) places_.keep_free({from + i * step - half, from + i * step + half});
  }
  /// What of a line lies in the frame.
  [[nodiscard]] std::optional<std::pair<Point, Point>> in_view(const Point& from, const Point& to) const {
    const Eigen::AlignedBox2d frame(Point(sheet_.view.left, sheet_.view.bottom),
                                    Point(sheet_.view.right, sheet_.view.top));
    double enters = 0;
    double leaves = 1;
    for (const int axis : {0, 1}) {
      const double way = to[axis] - from[axis];
      if (way == 0 && (from[axis] < frame.min()[axis] || from[axis] > frame.max()[axis])) return std::nullopt;
      if (way == 0) continue;
      const double low = (frame.min()[axis] - from[axis]) / way;
      const double high = (frame.max()[axis] - from[axis]) / way;
      enters = std::max(enters, std::min(low, high));
      leaves = std::min(leaves, std::max(low, high));
    }
    if (enters >= leaves) return std::nullopt;
    return std::pair<Point, Point>(from + enters * (to - from), from + leaves * (to - from));
  }
  void label(const Point& wanted, const std::string& text, const std::string& colour) {
    const Point size = sheet_.per_pixel() * Point(Sheet::letter * static_cast<double>(text.size()) + 10, Sheet::row);
    const auto middle = places_.place(wanted, size);
    if (!middle) return;  // the legend has the loads
    const Point away = (*middle - wanted).cwiseAbs();
    if (away.x() > size.x() / 2 + size.y() || away.y() > 1.5 * size.y()) {
      script += fmt::format("set arrow from {},{} to {},{} nohead lw 0.7 lc rgb '{}' front\n", wanted.x(), wanted.y(),
                            middle->x(), middle->y(), colour);
    }
    script += fmt::format("set label {} at {},{} center boxed tc rgb '{}' front\n", gnuplot_text(text), middle->x(),
                          middle->y(), colour);
  }

  std::string script;

 private:
  Sheet sheet_;
  LabelPlaces places_;
  int objects_ = 0;
};

void draw_loads(const json& loads, Drawing& drawing) {
  for (const json& load : loads) {
    const std::string colour = load["colour"];
    for (const json& outline : load["diagrams"]) {
      drawing.polygon(outline,
                      fmt::format("fc rgb '{0}' fillstyle transparent solid 0.25 border lc rgb '{0}'", colour));
    }
    if (!load["in_view"].get<bool>()) continue;
    drawing.line(point_of(load["arrow"][0]), point_of(load["arrow"][1]),
                 fmt::format("filled lw 2 lc rgb '{}'", colour));
  }
}

void draw_joints(const json& joints, Drawing& drawing) {
  for (const json& joint : joints) {
    for (const json& line : joint["lines"]) {
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const auto seen = drawing.in_view(point_of(line[i]), point_of(line[i + 1]));
        if (seen) drawing.line(seen->first, seen->second, fmt::format("nohead dt 2 lw 2 lc rgb '{}'", joint_colour));
      }
    }
  }
}

/// A bolt's line with a plate across either end's direction at the head, which is the higher end.
void draw_bolts(const json& bolts, double size_m, Drawing& drawing) {
  for (const json& bolt : bolts) {
    Point head = point_of(bolt["from"]);
    Point foot = point_of(bolt["to"]);
    if (foot.y() > head.y()) std::swap(head, foot);
    const Point along = (foot - head).normalized();
    const Point across = 0.02 * size_m * Point(-along.y(), along.x());
    drawing.line(head, foot, fmt::format("nohead lw 3 lc rgb '{}'", bolt_colour));
    drawing.line(head - across, head + across, fmt::format("nohead lw 5 lc rgb '{}'", bolt_colour));
  }
}

/// Height of the reservoir above the highest moving point; 0 if it is lower.
double over_the_crest_m(const json& data, const json& level_m) {
  const json& box = data["dimensions"];
  return level_m.is_number() && box.is_object() ? std::max(0.0, level_m.get<double>() - box["top"].get<double>()) : 0;
}

/// The surface of what flows over the crest, as far as the crest reaches. It is level here: its shape is not computed.
void draw_nappe(const json& data, const json& state, Drawing& drawing) {
  const json& level_m = state["upstream"];
  if (over_the_crest_m(data, level_m) == 0) return;
  drawing.line({state["view"]["left"].get<double>(), level_m.get<double>()},
               {data["dimensions"]["crest"][1].get<double>(), level_m.get<double>()},
               fmt::format("nohead dt 3 lw 1.5 lc rgb '{}'", water_colour));
}

/// The middle of the longest leg that lies in the frame; none where nothing of the joint does.
std::optional<Point> place_of(const json& line, const Drawing& drawing) {
  std::optional<Point> place;
  double longest_m = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const auto seen = drawing.in_view(point_of(line[i]), point_of(line[i + 1]));
    if (!seen || (seen->second - seen->first).norm() <= longest_m) continue;
    longest_m = (seen->second - seen->first).norm();
    place = (seen->first + seen->second) / 2;
  }
  return place;
}

/// Behind all lines are drawn, so that no text lies on one where there is room.
void write_labels(const json& data, const json& state, Drawing& drawing) {
  for (const json& joint : data["joints"]) {
    if (!joint["labelled"].get<bool>()) continue;
    if (const auto place = place_of(joint["lines"][0], drawing)) drawing.label(*place, joint["name"], joint_colour);
  }
  constexpr std::size_t most = 12;  // of a mesh of joints, each with its uplift, the legend must do
  const auto of_kind = [&](const json& kind) {
    return std::count_if(state["acting"].begin(), state["acting"].end(),
                         [&](const json& l) { return l["kind"] == kind; });
  };
  for (const json& load : state["acting"]) {
    if (load["labelled"].get<bool>() && load["in_view"].get<bool>() &&
        static_cast<std::size_t>(of_kind(load["kind"])) <= most) {
      drawing.label(point_of(load["arrow"][0]), load["label"], load["colour"]);
    }
  }
  const json& view = state["view"];
  for (const auto& [pool, x] : {std::pair{"upstream", "left"}, {"downstream", "right"}}) {
    if (!state[pool].is_number()) continue;
    const double over_m = over_the_crest_m(data, state[pool]);
    drawing.label({view[x].get<double>(), state[pool].get<double>()},
                  fmt::format("{:.2f} m{}", state[pool].get<double>(),
                              over_m > 0 ? fmt::format(", {:.2f} m over the crest", over_m) : ""),
                  water_colour);
  }
  for (const json& bolt : state["bolts"]) {
    drawing.label((point_of(bolt["from"]) + point_of(bolt["to"])) / 2, bolt["label"], bolt_colour);
  }
}

std::string legend(const json& rows) {
  std::string plots = "plot NaN notitle";
  for (const json& row : rows) {
    plots += fmt::format(", keyentry with lines lw 8 lc rgb '{}' title {}", row["colour"].get<std::string>(),
                         gnuplot_text(row["label"]));
  }
  return plots + "\n";
}

std::string frame_of(const Sheet& sheet, const std::string& title) {
  return fmt::format(
      "set lmargin at screen {}\nset rmargin at screen {}\n"
      "set tmargin at screen {}\nset bmargin at screen {}\nset tics out nomirror\nset xlabel 'x (m)'\n"
      "set ylabel 'elevation (m)'\nset title {}\nset style textbox opaque noborder fillcolor rgb '#60ffffff' margins "
      "1,1\n"
      "set key at screen 0.5,0.005 bottom center horizontal Left reverse maxcols 2 samplen 2\n"
      "set xrange [{}:{}]\nset yrange [{}:{}]\n",
      Sheet::left / Sheet::width, 1 - Sheet::right / Sheet::width, 1 - Sheet::top / sheet.height(),
      sheet.bottom() / sheet.height(), title, sheet.view.left, sheet.view.right, sheet.view.bottom, sheet.view.top);
}

}  // namespace

Picture section_picture(const std::filesystem::path& run, const json& summary, const std::string& ending) {
  const scene::Scene scene = scene::read(process::scene_of(run)).scene;
  const json data = section_data(scene);
  const json state = pictured_state(scene, run, frames_data(run, summary));
  const double size_m = data["size_m"];
  const json& view = state["view"];
  const Sheet sheet{{view["left"], view["right"], view["bottom"], view["top"]},
                    std::ceil(static_cast<double>(state["legend"].size()) / 2)};
  Drawing drawing(sheet);
  for (const json& pool : state["pools"]) drawing.polygon(pool, "fc rgb '#cfe2f3' fillstyle solid noborder");
  for (const json& block : data["blocks"]) {
    drawing.polygon(block["outline"], fmt::format("fc rgb '{}' fillstyle solid border lc rgb '#303030' lw 1",
                                                  block["fixed"].get<bool>() ? "#8d7f6d" : "#c9c9c4"));
  }
  draw_loads(state["acting"], drawing);
  draw_joints(data["joints"], drawing);
  draw_bolts(state["bolts"], size_m, drawing);
  draw_nappe(data, state, drawing);
  write_labels(data, state, drawing);
  const std::string later =
      state.contains("fails_later_s")
          ? fmt::format(", the last frame before the failure at {:.4g} s", state["fails_later_s"].get<double>())
          : "";
  const std::string title = fmt::format("{}: section at {:.4g} s{}{}", scene.title, state["time_s"].get<double>(),
                                        later, over_the_crest_m(data, state["upstream"]) > 0 ? ", overtopped" : "");
  return {
      run / ("section" + ending), Sheet::width, sheet.height(),
      frame_of(sheet, gnuplot_title(shortened(title, 200), Sheet::width)) + drawing.script + legend(state["legend"])};
}

}  // namespace blockweir::picture
