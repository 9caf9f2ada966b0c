// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/validate/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "bridge/process/run.hpp"
#include "bridge/results/counted.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/study/engines.hpp"
#include "bridge/validate/bench_case.hpp"
#include "bridge/validate/bench_errors.hpp"
#include "bridge/validate/bench_figure.hpp"
#include "bridge/validate/cases_folder.hpp"

namespace blockweir::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using process::run;
using process::RunResult;
using process::TemporaryFolder;
using Clock = std::chrono::steady_clock;

std::string in_words(const std::string& curve, const std::string& setting) {
  return setting.empty() ? curve : fmt::format("{}, {}", curve, setting);
}

std::vector<BenchCase> chosen(const BenchOptions& options) {
  std::vector<BenchCase> all;
  for (const fs::path& path : options.cases.empty() ? all_cases() : options.cases) {
    BenchCase bench = bench_case(path, options.overrides, options.brief);
    if (bench.settings.size() > 1) {
      all.push_back(std::move(bench));
    } else if (!options.cases.empty()) {
      throw std::invalid_argument(fmt::format(
          "{}: found no [[bench]]; expected a scene with one; add one, or name another scene", path.string()));
    }
  }
  return all;
}

/// Runs a case's settings, as `blockweir run` does.
class Runs {
 public:
  explicit Runs(const BenchCase& bench) : bench_(bench) {}

  [[nodiscard]] RunResult of(std::size_t i) const {
    const BenchSetting& setting = bench_.settings[i];
    RunResult result = run({.scene = bench_.scene,
                            .out = scratch_.path() / "run",
                            .overrides = setting.all,
                            .inproc = setting.inproc,
                            .quiet = true});
    if (result.exit_code == 130) throw Interrupted();
    return result;
  }

  /// Median, over an odd number of pairs, of the wall time of setting i over that of the scene itself, run alternately.
  [[nodiscard]] double beside_the_scene(std::size_t i, std::size_t pairs) const {
    const auto time_s = [&](std::size_t k) {
      const RunResult result = of(k);
      if (!result.trouble.empty()) throw std::runtime_error(result.trouble);
      return result.summary.at("wall_time_s").get<double>();
    };
    std::vector<double> ratios(pairs);
    for (double& ratio : ratios) {
      const double stands_s = time_s(0);
      ratio = time_s(i) / stands_s;
    }
    std::sort(ratios.begin(), ratios.end());
    return ratios[pairs / 2];
  }

 private:
  const BenchCase& bench_;
  TemporaryFolder scratch_;
};

/// The settings of a case: errors from an engine, and times measured here in rounds, so that other load on the machine
/// affects all alike: three rounds, up to nine for short runs. Long runs are done once in each round. A setting that
/// seems better than the scene itself is run again, alternating with it.
class Measured {
 public:
  Measured(const BenchCase& bench, const BenchErrors& errors, const BenchOptions& options)
      : figure(errors.figure), of_motion(errors.of_motion), timed(!options.untimed) {
    for (std::size_t i = 0; i < bench.settings.size(); ++i) {
      const BenchSetting& setting = bench.settings[i];
      points.push_back({.curve = setting.curve,
                        .setting = setting.key_and_value,
                        .time_s = std::numeric_limits<double>::infinity(),
                        .error = errors.settings[i].error,
                        .energy_gain = errors.settings[i].energy_gain});
      troubles_.push_back(errors.settings[i].trouble);
    }
    if (timed) time(Runs(bench), options.brief);
    for (std::size_t i = points.size(); i-- > 0;) {
      if (troubles_[i].empty()) continue;
      failed.push_back({points[i].curve, points[i].setting, troubles_[i]});
      points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

  struct Failed {
    std::string curve;
    std::string setting;
    std::string trouble;
  };
  std::vector<Point> points;
  std::vector<Failed> failed;
  std::string figure;
  bool of_motion;
  bool timed;

 private:
  void time(const Runs& runs, bool brief) {
    if (!brief) (void)runs.of(0);  // the first run after others finds programs and files cold
    const auto begin = Clock::now();
    const auto is_short = [&] { return Clock::now() - begin < std::chrono::seconds(30); };
    for (int turn = 0; turn < (brief ? 1 : 3) || (!brief && turn < 9 && is_short()); ++turn) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (!troubles_[i].empty()) continue;
        const RunResult result = runs.of(i);
        troubles_[i] = result.trouble;
        if (result.trouble.empty()) {
          points[i].time_s = std::min(points[i].time_s, result.summary["wall_time_s"].get<double>());
        }
      }
    }
    for (std::size_t i = 1; i < points.size() && troubles_.front().empty(); ++i) {
      if (!troubles_[i].empty() || (points[i].setting != one_process && !betters(points[i], points.front()))) continue;
      points[i].beside = runs.beside_the_scene(i, brief ? 1 : 7);
    }
  }

  std::vector<std::string> troubles_;  ///< of each setting; empty: none
};

/// Settings better than the scene itself when run alternately: the fastest and the most accurate of them.
std::vector<Point> better_ones(const std::vector<Point>& points) {
  const auto beside = [](double ratio, double error) { return Point{.time_s = ratio, .error = error}; };
  std::vector<Point> better;
  for (const Point& p : points) {
    if (p.setting != one_process && p.beside > 0 && betters(beside(p.beside, p.error), beside(1, points.front().error)))
      better.push_back(p);
  }
  if (better.empty()) return {};
  const auto fastest = std::min_element(better.begin(), better.end(),
                                        [](const Point& a, const Point& b) { return a.beside < b.beside; });
  const auto finest =
      std::min_element(better.begin(), better.end(), [](const Point& a, const Point& b) { return a.error < b.error; });
  return fastest == finest ? std::vector{*fastest} : std::vector{*fastest, *finest};
}

json as_json(const Point& p) {
  json row = {{"curve", p.curve}, {"setting", p.setting}, {"relative_error", p.error}, {"energy_gain", p.energy_gain}};
  if (std::isfinite(p.time_s)) row["wall_time_s"] = p.time_s;
  if (p.beside > 0) row["wall_time_beside"] = p.beside;
  return row;
}

void draw(const std::string& name, const Measured& measured, const fs::path& out) {
  draw_bench(out / (name + ".png"), name, "relative error of " + measured.figure, measured.points);
  if (!measured.of_motion) return;
  std::vector<Point> energy = measured.points;
  for (Point& p : energy) p.error = p.energy_gain;
  draw_bench(out / (name + "-energy.png"), name, "energy made over what the run had", energy);
}

/// Prints the case's rows, into `row` too.
void tell_points(const Measured& measured, json& row) {
  const std::vector<std::size_t> best = measured.timed ? front(measured.points) : std::vector<std::size_t>{};
  for (std::size_t i = 0; i < measured.points.size(); ++i) {
    const Point& p = measured.points[i];
    const bool on_front = std::find(best.begin(), best.end(), i) != best.end();
    fmt::print("  {:<74} error {:>9.2e}{}{}{}\n", in_words(p.curve, p.setting), p.error,
               measured.of_motion ? fmt::format("  energy made {:>7.1e}", p.energy_gain) : "",
               measured.timed ? fmt::format("  {:>8.3f} s", p.time_s) : "", on_front ? "  *" : "");
    row["points"].push_back(as_json(p));
    if (measured.timed) row["points"].back()["on_front"] = on_front;
  }
  for (const auto& f : measured.failed) {
    fmt::print("  {}: {}\n", in_words(f.curve, f.setting), f.trouble);
    row["failed"].push_back({{"curve", f.curve}, {"setting", f.setting}, {"trouble", f.trouble}});
  }
  std::fflush(stdout);
}

/// Prints the case's rows and draws it; returns the final remark as "verdict".
json told(const BenchCase& bench, const Measured& measured, const fs::path& out) {
  const std::string name = case_name(bench.scene);
  json row = {{"case", name}, {"figure", measured.figure}, {"points", json::array()}, {"failed", json::array()}};
  fmt::print("{}: {}\n", name, measured.figure);
  tell_points(measured, row);
  if (measured.points.empty() || !measured.points.front().setting.empty()) {
    row["verdict"] = measured.failed.empty()
                         ? fmt::format("{} as it stands was not measured", name)
                         : fmt::format("{} as it stands: {}", name, measured.failed.front().trouble);
    return row;
  }
  const Point& stands = measured.points.front();
  std::string verdict = fmt::format("{} as it stands: error {:.2g}", name, stands.error);
  if (!measured.timed) {
    row["verdict"] = verdict;
    return row;
  }
  verdict += fmt::format(" in {:.3f} s, ", stands.time_s);
  row["bettered_by"] = json::array();
  for (const Point& p : better_ones(measured.points)) {
    verdict += fmt::format("{}\n    {}: error {:.2g} in {:.2g} of its time",
                           row["bettered_by"].empty() ? "NOT on the front:" : "", in_words(p.curve, p.setting), p.error,
                           p.beside);
    row["bettered_by"].push_back(as_json(p));
  }
  if (row["bettered_by"].empty()) verdict += "on the front";
  for (const Point& p : measured.points) {
    if (p.setting == one_process) verdict += fmt::format("\n    {}: {:.2g} of its time", one_process, p.beside);
  }
  row["verdict"] = verdict;
  draw(name, measured, out);
  return row;
}

}  // namespace

std::size_t bench_settings(const fs::path& scene, const Settings& overrides) {
  return bench_case(scene, overrides, false).settings.size() - 1;
}

int bench(const BenchOptions& options) {
  const std::vector<BenchCase> cases = chosen(options);
  results::make_folder(options.out);
  const auto engine = make_engine(options.engine, options.out);
  json rows = json::array();
  try {
    const std::vector<BenchErrors> errors = errors_of(cases, *engine);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      rows.push_back(told(cases[i], Measured(cases[i], errors[i], options), options.out));
    }
  } catch (const Interrupted&) {
    fmt::print(stderr, "stopped on request\n");
    return 130;
  }
  bool sound = true;
  for (json& row : rows) {
    fmt::print("{}\n", row["verdict"].get<std::string>());
    sound = sound && row["failed"].empty();
    row.erase("verdict");
  }
  const fs::path table = options.out / "bench.json";
  results::replace_file(table, rows.dump(2) + "\n");
  fmt::print("{}; {}\n", results::counted(rows.size(), "case"), table.string());
  return sound ? 0 : 1;
}

}  // namespace blockweir::study
