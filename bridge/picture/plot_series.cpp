// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/plot_series.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>
#include <vector>

#include "bridge/picture/gnuplot.hpp"
#include "bridge/results/csv.hpp"

namespace blockweir::picture {
namespace {

namespace fs = std::filesystem;

/// Column names of a CSV header; quoted ones may hold commas.
std::vector<std::string> columns_of(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  if (!std::getline(stream, line)) {
    throw std::invalid_argument(fmt::format("{} is missing or empty: is this the folder of a run?", file.string()));
  }
  return results::csv_cells(line);
}

/// Whether the run has no value for a column: levels of a scene without water.
bool is_empty(const fs::path& file, std::size_t column) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  std::getline(stream, line);
  std::size_t begin = 0;
  for (std::size_t i = 0; i < column && begin != std::string::npos; ++i) begin = line.find(',', begin) + 1;
  return line.compare(begin, 3, "nan") == 0;
}

/// A quantity's ending, its axis, and what of it is rest: the axis reaches as far at least.
struct Axis {
  const char* quantity;
  const char* label;
  double rest = 0;
};

/// One panel: all columns that end as asked, each under its block's name; of many the first.
std::string panel(const fs::path& file, const std::vector<std::string>& columns, const Axis& axis) {
  constexpr int most_named = 8;
  const std::string quantity = axis.quantity;
  std::string curves;
  int drawn = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string& name = columns[i];
    if (name.size() < quantity.size() || name.compare(name.size() - quantity.size(), quantity.size(), quantity) != 0)
      continue;
    if (is_empty(file, i)) continue;
    std::string title = name.substr(0, name.size() - quantity.size());
    if (!title.empty() && title.back() == '.') title.pop_back();
    curves += fmt::format("{}{} using 1:{} with lines lw 2 {}", curves.empty() ? "" : ", ", gnuplot_path(file), i + 1,
                          ++drawn > most_named ? "notitle" : "title " + gnuplot_text(title));
  }
  if (curves.empty()) return "";
  if (drawn > most_named) {
    curves += fmt::format(", NaN with lines lc rgb 'white' title \"and {} more\"", drawn - most_named);
  }
  const std::string range = axis.rest > 0 ? fmt::format("[* < -{0} : {0} < *]", axis.rest) : "[*:*]";
  return fmt::format("set ylabel \"{}\"\nset yrange {}\nplot {}\n", axis.label, range, curves);
}

}  // namespace

std::string series_script(const fs::path& run, const nlohmann::json& summary, const std::string& terminal,
                          const std::string& ending) {
  const fs::path file = run / "history.csv";
  const auto columns = columns_of(file);
  std::string script =
      "set datafile separator ','\nset datafile missing 'nan'\nset key autotitle columnhead\nset key top left\n"
      "set grid lc rgb '#dddddd'\nset xlabel 'time [s]'\n";
  if (summary.contains("failure")) {
    script += fmt::format("set arrow 1 from first {0}, graph 0 to first {0}, graph 1 nohead dt 2 lc rgb '#c00000'\n",
                          summary["failure"]["time_s"].get<double>());
  }
  const auto figure = [&](const std::string& name, const std::string& title, const std::vector<Axis>& panels) {
    std::string body;
    for (const Axis& axis : panels) body += panel(file, columns, axis);
    if (body.empty()) return;
    script += fmt::format(
        "set terminal {} size 1000,{}\nset output {}\nset multiplot layout {},1 title {}\n{}unset multiplot\n",
        terminal, 60 + 340 * panels.size(), gnuplot_path(run / (name + ending)), panels.size(), gnuplot_text(title),
        body);
  };
  constexpr double rest_m = 1e-4;
  constexpr double rest_rad = 1e-5;
  const std::string dashes = summary.contains("failure") ? " (dashes: the failure begins)" : "";
  const std::string title = summary.value("title", run.filename().string());
  figure("displacements", title + ": displacements of the centroids" + dashes,
         {{".displacement_x_m", "horizontal [m]", rest_m}, {".displacement_y_m", "vertical [m]", rest_m}});
  figure("velocities", title + ": velocities of the centroids" + dashes,
         {{".velocity_x_m_per_s", "horizontal [m/s]", rest_m}, {".velocity_y_m_per_s", "vertical [m/s]", rest_m}});
  figure("rotations", title + ": rotations" + dashes, {{".rotation_rad", "rotation [rad]", rest_rad}});
  figure("level", title + ": water level and largest displacement" + dashes,
         {{"upstream_level_m", "level [m]"}, {"largest_displacement_m", "largest displacement [m]", rest_m}});
  return script;
}

}  // namespace blockweir::picture
