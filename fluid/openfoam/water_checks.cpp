// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/water_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

namespace blockweir::openfoam {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
using Column = std::vector<double>;

std::map<std::string, Column> read_columns(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::vector<std::string> names;
  std::map<std::string, Column> columns;
  std::string line;
  std::getline(stream, line);
  std::istringstream heading(line);
  for (std::string name; std::getline(heading, name, ',');) names.push_back(name);
  while (std::getline(stream, line)) {
    std::istringstream row(line);
    std::string value;
    for (const std::string& name : names) {
      if (std::getline(row, value, ',')) columns[name].push_back(std::stod(value));
    }
  }
  return columns;
}

/// Time at which the front passes x, linear between rows; NaN where it never does.
double arrival(const Column& time, const Column& front, double x) {
  for (std::size_t i = 1; i < front.size(); ++i) {
    if (front[i - 1] >= x || front[i] < x) continue;
    return time[i - 1] + (x - front[i - 1]) / (front[i] - front[i - 1]) * (time[i] - time[i - 1]);
  }
  return nan;
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

double water_quantity(std::map<std::string, Column>& columns, const scene::Expectation& e) {
  const Column& time = columns["time_s"];
  const auto of_block = [&](const char* what) -> const Column& { return columns[e.of + "." + what]; };
  if (time.empty()) return nan;
  if (e.quantity == "water_area_error") {
    const Column& area = columns["water_area_m2"];
    double largest = 0;
    for (const double a : area) largest = std::max(largest, std::abs(a / area.front() - 1));
    return largest;
  }
  if (e.quantity == "front_arrival_s" && e.at_m) return arrival(time, columns["front_m"], e.at_m->x());
  if (e.quantity == "fastest_m_per_s") return columns["fastest_m_per_s"].back();
  if (e.quantity == "added_mass_kg_per_m") {
    return added_mass(of_block("force_x_n_per_m"), rate(time, of_block("velocity_x_m_per_s")));
  }
  if (e.quantity == "ground_added_mass_kg_per_m") {
    return added_mass(of_block("force_x_n_per_m"), columns["ground_acceleration_x_m_per_s2"]);
  }
  for (const char* force : {"force_x_n_per_m", "force_y_n_per_m"}) {
    if (e.quantity == force) return mean_of_second_half(of_block(force));
  }
  throw std::runtime_error(
      fmt::format("[[expect_water]] names no quantity: \"{}\"; there are water_area_error, "
                  "front_arrival_s (with at_m), fastest_m_per_s, added_mass_kg_per_m, "
                  "force_x_n_per_m, force_y_n_per_m",
                  e.quantity));
}

}  // namespace

nlohmann::json water_checks(const scene::Scene& scene, const std::filesystem::path& water_csv) {
  auto columns = read_columns(water_csv);
  auto list = nlohmann::json::array();
  for (const scene::Expectation& e : scene.water_expectations) {
    const double got = water_quantity(columns, e);
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
