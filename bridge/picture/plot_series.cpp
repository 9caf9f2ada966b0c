// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/plot_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <vector>

#include "bridge/picture/curve.hpp"
#include "bridge/picture/gnuplot.hpp"
#include "bridge/picture/history.hpp"
#include "bridge/picture/measured.hpp"
#include "bridge/scene/read/nearest.hpp"

namespace blockweir::picture {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_named = 8;
constexpr std::size_t most_letters = 20;  // of a name in a legend
constexpr std::size_t pixels = 1000;
constexpr std::size_t pixels_of_others = 150;

/// A quantity's ending, its axis, and what of it is rest: the axis reaches as far at least.
struct Axis {
  const char* quantity;
  const char* label;
  double rest = 0;
  double factor = 1;             ///< from the history's unit to the axis's
  const char* name = "";         ///< in the legend, of what is no block's
  const char* second = nullptr;  ///< a quantity beside it, of that name
  const char* second_name = "";
};

/// Curves of a plot: their data, and what plots them.
struct Curves {
  void add(const std::string& rows, const std::string& style, const std::string& name = "") {
    letters = std::max(letters, name.size());
    data += fmt::format("$curve{} << EOD\n{}EOD\n", ++count, rows);
    plots += fmt::format("{}$curve{} {}", plots.empty() ? "" : ", ", count, style);
  }
  std::string data{};
  std::string plots{};
  int count = 0;
  std::size_t letters = 0;  ///< of the longest name in the legend
};

/// What draws a panel, and the letters of the longest name in its legend.
struct DrawnPanel {
  std::string script{};
  std::size_t letters = 0;
};

bool holds(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// Throws std::invalid_argument where `word` is none of `known`.
void require_known(const std::string& option, const std::string& word, const std::vector<std::string>& known) {
  if (holds(known, word)) return;
  const std::string near = scene::did_you_mean(word, known);
  throw std::invalid_argument(fmt::format("{}: found \"{}\", which the run does not have; expected {}{}", option, word,
                                          scene::one_of(known), near.empty() ? "" : "; " + near));
}

class Series {
 public:
  explicit Series(const PlotOptions& options) : history_(options.run / "history.csv") {
    std::vector<std::string> blocks;
    constexpr const char* ending = ".displacement_x_m";
    for (const std::string& name : history_.names()) {
      if (name.ends_with(ending)) blocks.push_back(name.substr(0, name.size() - std::string_view(ending).size()));
    }
    for (const std::string& block : options.blocks) require_known("--blocks", block, blocks);
    named_ = options.blocks;
    if (named_.empty()) named_ = history_.largest_first("displacement_x_m", "displacement_y_m");
    if (named_.empty()) named_ = blocks;
    if (options.blocks.empty()) named_.resize(std::min(named_.size(), most_named));
    for (const std::string& block : blocks) {
      if (!holds(named_, block)) others_.push_back(block);
    }
    if (!options.data.empty()) take_measured(options.data);
  }

  /// All columns of the quantity, those of unnamed blocks grey behind the others; empty where the run has none.
  [[nodiscard]] DrawnPanel panel(const Axis& axis) const {
    const std::string quantity = axis.quantity;
    const bool of_blocks = quantity.starts_with('.');
    Curves curves;
    const auto add = [&](const History& history, const std::string& column, std::size_t spans, const std::string& style,
                         const std::string& name) {
      if (!history.has_values(column)) return;
      const std::string title = name.empty() ? "notitle" : "title " + gnuplot_text(name);
      curves.add(curve_rows(history.column("time_s"), history.column(column), spans, axis.factor), style + " " + title,
                 name);
    };
    if (!of_blocks) add(history_, quantity, pixels, "with lines lw 2", axis.name);
    if (axis.second != nullptr) add(history_, axis.second, pixels, "with lines lw 2", axis.second_name);
    for (const std::string& block : others_) {
      if (of_blocks) add(history_, block + quantity, pixels_of_others, "with lines lw 1 lc rgb '#b8b8b8'", "");
    }
    int colour = 0;
    for (const std::string& block : named_) {
      if (!of_blocks) break;
      ++colour;
      const std::string name = shortened(block, most_letters);
      add(history_, block + quantity, pixels, fmt::format("with lines lw 2 lt {}", colour), name);
      if (!measured_) continue;
      add(*measured_, block + quantity, measured_->rows(), fmt::format("with points pt 6 lt {}", colour),
          name + ", measured");
    }
    if (!of_blocks && measured_) add(*measured_, quantity, measured_->rows(), "with points pt 6 lt 1", "measured");
    if (curves.plots.empty()) return {};
    if (of_blocks && !others_.empty()) {
      const std::string more = fmt::format("{} more", others_.size());
      curves.plots += fmt::format(", NaN with lines lw 1 lc rgb '#b8b8b8' title '{}'", more);
      curves.letters = std::max(curves.letters, more.size());
    }
    const std::string range = axis.rest > 0 ? fmt::format("[* < -{0} : {0} < *]", axis.rest) : "[*:*]";
    return {fmt::format("{}set key outside right top samplen 2\nset offsets 0,0,graph 0.03,graph 0.03\nset ylabel "
                        "'{}'\nset yrange {}\nplot {}\n",
                        curves.data, axis.label, range, curves.plots),
            curves.letters};
  }

  [[nodiscard]] bool has_level() const {
    return history_.has_values("upstream_level_m") || history_.has_values("downstream_level_m");
  }

 private:
  void take_measured(const fs::path& file) {
    std::error_code unreadable;
    if (!fs::is_regular_file(file, unreadable) || fs::is_empty(file, unreadable)) {
      throw std::invalid_argument(
          fmt::format("--data {}: found no such file, or an empty one; expected CSV with a heading; check the path",
                      file.string()));
    }
    measured_ = read_measured(file);
    const auto& columns = measured_->names();
    if (columns.front() != "time_s") {
      throw std::invalid_argument(fmt::format("--data {}: found \"{}\" as the first column; expected time_s; rename it",
                                              file.string(), columns.front()));
    }
    for (const std::string& column : columns) require_known("--data " + file.string(), column, history_.names());
  }

  History history_;
  std::vector<std::string> named_;
  std::vector<std::string> others_;
  std::optional<History> measured_;
};

}  // namespace

std::vector<Picture> series_pictures(const PlotOptions& options, const nlohmann::json& summary,
                                     const std::string& ending) {
  const Series series(options);
  const fs::path& run = options.run;
  std::string axes = "set grid lc rgb '#dddddd'\nset xlabel 'time (s)'\n";
  if (summary.contains("failure")) {
    axes += fmt::format("set arrow 1 from first {0}, graph 0 to first {0}, graph 1 nohead dt 2 lc rgb '#c00000'\n",
                        summary["failure"]["time_s"].get<double>());
  }
  std::vector<Picture> pictures;
  const auto figure = [&](const std::string& name, const std::string& title, const std::vector<Axis>& axes_of_panels) {
    std::string body;
    int panels = 0;
    std::size_t letters = 0;
    for (const Axis& axis : axes_of_panels) {
      const DrawnPanel panel = series.panel(axis);
      if (panel.script.empty()) continue;
      body += panel.script;
      letters = std::max(letters, panel.letters);
      ++panels;
    }
    if (panels == 0) return;
    constexpr std::size_t beside = 8;  // letters' widths beside the longest name in a legend
    pictures.push_back({run / (name + ending), 1000, 60 + 340.0 * panels,
                        fmt::format("{}set lmargin 12\nset rmargin {}\nset multiplot layout {},1 title {}\n{}unset "
                                    "multiplot\n",
                                    axes, letters + beside, panels, gnuplot_title(title, 1000), body)});
  };
  constexpr double rest_m = 1e-9;  // round-off is no motion
  constexpr double rest_deg = 1e-7;
  constexpr double deg_per_rad = 57.29577951308232;
  const std::string dashes = summary.contains("failure") ? " (dashes: the failure begins)" : "";
  const std::string title = summary.value("title", run.filename().string());
  figure("displacements", title + ": displacements of the centroids" + dashes,
         {{".displacement_x_m", "horizontal (m)", rest_m}, {".displacement_y_m", "vertical (m)", rest_m}});
  figure("velocities", title + ": velocities of the centroids" + dashes,
         {{".velocity_x_m_per_s", "horizontal (m/s)", rest_m}, {".velocity_y_m_per_s", "vertical (m/s)", rest_m}});
  figure("rotations", title + ": rotations" + dashes, {{".rotation_rad", "rotation (deg)", rest_deg, deg_per_rad}});
  figure("level",
         title + (series.has_level() ? ": water level and largest displacement" : ": largest displacement") + dashes,
         {{"upstream_level_m", "level (m)", 0, 1, "upstream", "downstream_level_m", "downstream"},
          {"largest_displacement_m", "largest displacement (m)", rest_m, 1, "largest displacement"}});
  return pictures;
}

}  // namespace blockweir::picture
