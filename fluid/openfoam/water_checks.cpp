// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/water_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include "bridge/results/csv.hpp"
#include "fluid/openfoam/site.hpp"

namespace blockweir::openfoam {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
using Column = std::vector<double>;

using Columns = std::map<std::string, Column>;

Columns read_columns(const std::filesystem::path& file) {
  std::ifstream stream(file);
  Columns columns;
  std::string line;
  std::getline(stream, line);
  const std::vector<std::string> names = results::csv_cells(line);
  while (std::getline(stream, line)) {
    std::istringstream row(line);
    std::string value;
    for (const std::string& name : names) {
      if (std::getline(row, value, ',')) columns[name].push_back(std::stod(value));
    }
  }
  return columns;
}

/// Time at which a value first rises past `mark`, linear between rows; NaN where it never does.
double arrival(const Column& time, const Column& value, double mark) {
  for (std::size_t i = 1; i < value.size(); ++i) {
    if (value[i - 1] >= mark || value[i] < mark) continue;
    return time[i - 1] + (mark - value[i - 1]) / (value[i] - value[i - 1]) * (time[i] - time[i - 1]);
  }
  return nan;
}

/// Of the oscillation with the given period, over as many of its last whole periods as fit into half of the run.
double amplitude(const Column& time, const Column& value, double period_s) {
  const double periods = std::floor((time.back() - time.front()) / 2 / period_s);
  if (periods < 1) return nan;
  const double from = time.back() - periods * period_s;
  double cosine = 0;
  double sine = 0;
  double rows = 0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (time[i] < from + 1e-9 * period_s) continue;
    const double phase = 2 * M_PI * time[i] / period_s;
    cosine += value[i] * std::cos(phase);
    sine += value[i] * std::sin(phase);
    rows += 1;
  }
  return 2 / rows * std::hypot(cosine, sine);
}

/// Half of the range in the second half of the run.
double swing(const Column& value) {
  const auto [low, high] =
      std::minmax_element(value.begin() + static_cast<std::ptrdiff_t>(value.size() / 2), value.end());
  return (*high - *low) / 2;
}

Column rate(const Column& time, const Column& value) {
  Column rate(value.size(), nan);
  for (std::size_t i = 1; i + 1 < value.size(); ++i) {
    rate[i] = (value[i + 1] - value[i - 1]) / (time[i + 1] - time[i - 1]);
  }
  return rate;
}

/// m in F = F0 - m a: least squares over all rows but the first tenth, in which the water sets out, and the last.
double added_mass(const Column& force, const Column& acceleration) {
  double n = 0;
  double sum_a = 0;
  double sum_f = 0;
  double sum_aa = 0;
  double sum_af = 0;
  for (std::size_t i = force.size() / 10 + 1; i + 1 < force.size(); ++i) {
    const double a = acceleration[i];
    n += 1;
    sum_a += a;
    sum_f += force[i];
    sum_aa += a * a;
    sum_af += a * force[i];
  }
  return -(n * sum_af - sum_a * sum_f) / (n * sum_aa - sum_a * sum_a);
}

double mean_of_second_half(const Column& column) {
  double sum = 0;
  for (std::size_t i = column.size() / 2; i < column.size(); ++i) sum += column[i];
  return sum / static_cast<double>(column.size() - column.size() / 2);
}

double water_quantity(const Columns& columns, const scene::Scene& scene, const scene::Expectation& e) {
  const auto column = [&](const std::string& name) -> const Column& {
    const auto found = columns.find(name);
    if (found != columns.end()) return found->second;
    throw std::runtime_error(fmt::format(
        "[[expect_water]] {}: water.csv has no column \"{}\"; run the scene anew, the file is of another version",
        e.quantity, name));
  };
  const auto of_block = [&](const char* what) -> const Column& { return column(e.of + "." + what); };
  if (columns.empty()) return nan;  // not a row
  const Column& time = column("time_s");
  if (e.quantity == "water_area_error") {
    const Column& area = column("water_area_m2");
    double largest = 0;
    for (const double a : area) largest = std::max(largest, std::abs(a / area.front() - 1));
    return largest;
  }
  if (e.quantity == "front_arrival_s" && e.at_m) return arrival(time, column("front_m"), e.at_m->x());
  const Column& level = column("upstream_level_m");
  if (e.quantity == "level_arrival_s" && e.at_m) return arrival(time, level, e.at_m->y());
  if (e.quantity == "upstream_level_m") return mean_of_second_half(level);
  if (e.quantity == "level_swing_m") return swing(level);
  if (comes_in(scene.openfoam)) {
    const double period = scene.openfoam.wave->period_s;
    if (e.quantity == "level_amplitude_m") return amplitude(time, level, period);
    if (e.quantity == "force_x_amplitude_n_per_m") return amplitude(time, of_block("force_x_n_per_m"), period);
  }
  if (e.quantity == "fastest_m_per_s") return column("fastest_m_per_s").back();
  if (e.quantity == "added_mass_kg_per_m") {
    return added_mass(of_block("force_x_n_per_m"), rate(time, of_block("velocity_x_m_per_s")));
  }
  if (e.quantity == "ground_added_mass_kg_per_m") {
    return added_mass(of_block("force_x_n_per_m"), column("ground_acceleration_x_m_per_s2"));
  }
  for (const char* force : {"force_x_n_per_m", "force_y_n_per_m"}) {
    if (e.quantity == force) return mean_of_second_half(of_block(force));
  }
  throw std::runtime_error(fmt::format("[[expect_water]] names no quantity: \"{}\"", e.quantity));
}

}  // namespace

void require_water_columns(const scene::Scene& scene) {
  const Site site = find_site(scene);
  for (const scene::Expectation& e : scene.water_expectations) {
    for (const int ground : site.ground) {
      if (scene.blocks[static_cast<std::size_t>(ground)].name != e.of) continue;
      throw std::invalid_argument(fmt::format(
          "[[expect_water]] {} of \"{}\": this is ground, which is extended to the mesh's end, and water.csv has "
          "no force on it; name a block that stands in the water",
          e.quantity, e.of));
    }
  }
}

nlohmann::json water_checks(const scene::Scene& scene, const std::filesystem::path& water_csv) {
  const Columns columns = read_columns(water_csv);
  auto list = nlohmann::json::array();
  for (const scene::Expectation& e : scene.water_expectations) {
    const double got = water_quantity(columns, scene, e);
    const double error = *e.value == 0 ? std::abs(got) : std::abs(got / *e.value - 1);
    std::string name = e.quantity;
    if (!e.of.empty()) name += " of " + e.of;
    if (e.at_m) name += fmt::format(" at ({:.4g}, {:.4g})", e.at_m->x(), e.at_m->y());
    list.push_back({{"name", name},
                    {"expected", *e.value},
                    {"got", got},
                    {"relative_error", error},
                    {"tolerance", e.tolerance},
                    {"passed", error <= e.tolerance},
                    {"formula", ""},
                    {"source", e.source}});
  }
  return list;
}

}  // namespace blockweir::openfoam
