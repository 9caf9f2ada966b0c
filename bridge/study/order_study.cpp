// SPDX-License-Identifier: GPL-3.0-or-later
// [[order]]: the power of a key with which the error of a quantity vanishes.
#include <fmt/format.h>

#include <cmath>

#include "bridge/picture/gnuplot.hpp"
#include "bridge/study/key_label.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {
namespace {

using picture::gnuplot_text;

using nlohmann::json;

/// The line log(error) = constant + slope log(value) with the least sum of squares.
struct Line {
  double slope;
  double constant;
};

Line least_squares(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  double mean_x = 0;
  double mean_y = 0;
  for (std::size_t i = 0; i < x.size(); ++i) mean_x += x[i] / n, mean_y += y[i] / n;
  double xy = 0;
  double xx = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    xx += (x[i] - mean_x) * (x[i] - mean_x);
  }
  if (xx == 0) throw std::runtime_error("no order: all values are the same; expected two or more that differ");
  return {xy / xx, mean_y - xy / xx * mean_x};
}

StudyResult find_order(const scene::OrderStudy& study, StudyRuns& runs) {
  StudyResult result{.key = study.key};
  std::vector<double> log_value;
  std::vector<double> log_error;
  std::string points;
  for (const double value : study.values) {
    const json summary = runs.run({setting(study.key, value)}, study.expected);
    const json& check = summary["checks"][0];
    if (!check["got"].is_number())
      throw std::runtime_error(
          fmt::format("no order: the run gave no number for {} at {} = {}{}; "
                      "state another quantity, or values with which it has one",
                      study.expected.quantity, study.key, value,
                      check.contains("why_none") ? ", " + check["why_none"].get<std::string>() : ""));
    const double error = check["relative_error"].get<double>();
    if (error <= 0)
      throw std::runtime_error(
          fmt::format("no order: {} is exact at {} = {}; expected an error above 0; leave that value out",
                      study.expected.quantity, study.key, value));
    log_value.push_back(std::log(value));
    log_error.push_back(std::log(error));
    result.runs.push_back({{"value", value}, {"got", check["got"]}, {"expected", check["expected"]}, {"error", error}});
    result.text += fmt::format("  {:<12.9g} {:<18.12g} error {:.6e}\n", value, check["got"].get<double>(), error);
    points += fmt::format("{} {}\n", value, error);
  }
  const Line line = least_squares(log_value, log_error);
  const double scale = study.order == 0 ? 1 : std::abs(study.order);
  const double error = std::abs(line.slope - study.order) / scale;
  result.check = {{"name", fmt::format("order of {} in {}", study.expected.quantity, study.key)},
                  {"expected", study.order},
                  {"got", line.slope},
                  {"relative_error", error},
                  {"tolerance", study.order_tolerance / scale},
                  {"passed", error <= study.order_tolerance / scale},
                  {"formula", study.expected.formula},
                  {"source", study.expected.source}};
  result.figure = fmt::format(
      "set logscale xy\nset format y '%.0e'\nset xlabel {}\nset ylabel 'relative error'\nset key top left\nset grid\n"
      "$d << EOD\n{}EOD\nplot exp({})*x**({}) with lines lc rgb '#808080' title 'slope {:.3f}', $d pt 7 lc rgb "
      "'#204a87' notitle\n",
      gnuplot_text(key_label(study.key)), points, line.constant, line.slope, line.slope);
  return result;
}

}  // namespace

std::string orders_figure(const std::vector<std::pair<std::string, StudyResult>>& orders) {
  std::string figure = fmt::format(
      "set logscale xy\nset format y '%.0e'\nset xlabel {}\nset ylabel 'relative error'\n"
      "set key above vertical maxcols 1\nset grid\n",
      gnuplot_text(key_label(orders.front().second.key)));
  std::string curves;
  for (std::size_t i = 0; i < orders.size(); ++i) {
    const auto& [name, result] = orders[i];
    figure += fmt::format("$d{} << EOD\n", i);
    for (const json& run : result.runs) {
      figure += fmt::format("{} {}\n", run["value"].get<double>(), run["error"].get<double>());
    }
    figure += "EOD\n";
    curves += fmt::format("{}$d{} with linespoints pt {} title {}", i == 0 ? "" : ", ", i, i + 5,
                          gnuplot_text(fmt::format("{}: slope {:.3f}", name, result.check["got"].get<double>())));
  }
  return figure + "plot " + curves + "\n";
}

StudyTask order_task(const scene::OrderStudy& study) {
  StudyTask task{.name = study.name, .kind = "[[order]]", .line = study.line, .set = study.set};
  for (const double value : study.values) task.extremes.push_back({setting(study.key, value)});
  task.go = [study](StudyRuns& runs) { return find_order(study, runs); };
  return task;
}

}  // namespace blockweir::study
