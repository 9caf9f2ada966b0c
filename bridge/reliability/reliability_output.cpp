// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/reliability/reliability_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "bridge/picture/gnuplot.hpp"
#include "bridge/reliability/method_text.hpp"
#include "bridge/results/csv.hpp"
#include "bridge/study/study_files.hpp"

namespace blockweir::study {
namespace {

using nlohmann::json;

std::string way_of(const std::string& by) {
  if (by == "limit") return "limit analysis";
  return by == "statics" ? "static analysis of the blocks" : "whole runs";
}

std::string samples_text(const json& answer) {
  const json& samples = answer["samples"];
  std::string text =
      fmt::format("SAMPLES {} by {}, {}\n        P {} at a level of {:.6g} m, {} to {} (95 %); index {}\n",
                  samples["count"].get<int>(), way_of(answer["by"]), answer["sampling"].get<std::string>(),
                  digits_of(samples["probability"]), answer["level_m"].get<double>(), digits_of(samples["interval"][0]),
                  digits_of(samples["interval"][1]), digits_of(samples["index"]));
  if (const int stand = samples["that_stand"]; stand > 0) {
    text += fmt::format("        {} stand at the highest level\n", stand);
  }
  if (const int never = samples["that_never_stand"]; never > 0) {
    text += fmt::format("        {} do not even stand with an empty reservoir\n", never);
  }
  if (const int none = samples["without_answer"]; none > 0) {
    text += fmt::format("        {} have no answer, which widens the interval: as if all of them failed, or none; {}\n",
                        none, samples.value("trouble", "a run ended while blocks still moved: lengthen duration_s"));
  }
  if (const int made = samples["made"]; made > 0) {
    text += fmt::format("        {} made in {:.3g} s, {:.2g} % of the processes' time was not spent on them\n", made,
                        samples["wall_time_s"].get<double>(), 100 * samples["lost_to_the_engine"].get<double>());
  }
  return text;
}

/// A distribution fits levels that scatter: a joint of certain strength gives many samples one level.
std::string shape_text(const json& fit) {
  if (!fit.contains("commonest")) return fit["distribution"].get<std::string>() + " fits them best";
  return fmt::format("{} of the {} are {:.6g} m: no common distribution fits them",
                     fit["commonest"]["samples"].get<int>(), fit["samples"].get<int>(),
                     fit["commonest"]["level_m"].get<double>());
}

std::string fit_text(const json& answer) {
  if (!answer.contains("fit")) return "";
  const json& fit = answer["fit"];
  const json& samples = answer["samples"];
  const bool cut_off = fit.contains("cut_off_m");
  std::string text =
      fmt::format("LEVELS  of failure{}: mean {:.5g} m, deviation {:.3g} m; {}\n",
                  fit["samples"] == samples["count"]
                      ? ""
                      : fmt::format(" of the {} of {} samples that {}", fit["samples"].get<int>(),
                                    samples["count"].get<int>(), cut_off ? "fail below the highest level" : "have one"),
                  fit["mean"].get<double>(), fit["deviation"].get<double>(), shape_text(fit));
  if (!cut_off) return text;
  text += fmt::format(
      "        WARNING they are cut off{}: with the {} samples that stand there the mean is higher, and the\n"
      "        deviation another; {}\n",
      fit["cut_off_m"].is_number() ? fmt::format(" at {:.6g} m", fit["cut_off_m"].get<double>()) : "",
      samples["that_stand"].get<int>(),
      answer["by"] == "run" ? "let the filling end at a higher level"
                            : "may_overtop = true in [water] looks for higher levels");
  return text;
}

/// Do both ways come to the same, at all points?
bool ways_agree(const json& comparison) {
  constexpr double near = 1e-3;
  return std::all_of(comparison.begin(), comparison.end(), [](const json& row) {
    std::vector<json> found;
    for (const auto& [by, one] : row.items()) {
      if (by != "where") found.push_back(one);
    }
    const json& one = found.front();
    const json& other = found.back();
    if (!one["level_m"].is_number() || !other["level_m"].is_number()) {
      return one["trouble"] == "" && other["trouble"] == "" && one["outcome"] == other["outcome"];
    }
    const double level_m = one["level_m"];
    return std::abs(other["level_m"].get<double>() - level_m) <= near * std::abs(level_m);
  });
}

std::string found_text(const json& found) {
  if (found["level_m"].is_number()) return fmt::format("{:.6g} m", found["level_m"].get<double>());
  return found["trouble"] == "" ? found["outcome"].get<std::string>() : "none: " + found["trouble"].get<std::string>();
}

std::string comparison_text(const json& answer) {
  std::string text =
      answer.contains("contradiction") ? fmt::format("DIFFER  {}\n", answer["contradiction"].get<std::string>()) : "";
  for (const json& row : answer.value("comparison", json::array())) {
    text += fmt::format("{:<8}", !text.empty() ? "" : ways_agree(answer["comparison"]) ? "AGREE" : "DIFFER");
    std::string words = row["where"];
    for (const auto& [by, found] : row.items()) {
      if (by != "where") words += fmt::format("; {}: {}", way_of(by), found_text(found));
    }
    text += words + "\n";
  }
  if (answer.value("upper_bound", false)) {
    text +=
        "        limit analysis is an upper bound here: the true level is this or lower, and the true probability this "
        "or higher\n";
  }
  if (answer.contains("limit_analysis_note")) {
    text += "        " + answer["limit_analysis_note"].get<std::string>() + "\n";
  }
  return text;
}

}  // namespace

std::string sample_table(const scene::Randomness& randomness, const std::vector<RandomPoint>& points,
                         const std::vector<Outcome>& rows) {
  std::string text = "sample";
  for (const auto& variable : randomness.variables) text += "," + results::csv_cell(variable.name);
  text += ",outcome,level_m,head_m,mode,joint,trouble\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += fmt::format("{},{}", i + 1, fmt::join(points[i], ","));
    for (const char* column : {"outcome", "level_m", "head_m", "mode", "joint", "trouble"}) {
      const json cell = rows[i].value(column, json());
      text += "," + (cell.is_null() ? "" : cell.is_string() ? results::csv_cell(cell) : cell.dump());
    }
    text += "\n";
  }
  return text;
}

std::string distribution_text(const scene::Distribution& d) {
  std::string text = d.kind;
  if (d.kind == "normal" || d.kind == "lognormal") {
    text += fmt::format(", mean {:.6g}, deviation {:.6g}", d.mean, d.deviation);
  } else if (d.kind == "uniform") {
    text += fmt::format(" from {:.6g} to {:.6g}", d.from, d.to);
  } else if (d.kind == "triangular") {
    text += fmt::format(" from {:.6g} over {:.6g} to {:.6g}", d.from, d.peak, d.to);
  } else {
    text +=
        d.kind == "table" ? fmt::format(" of {} rows", d.table.size()) : fmt::format(" to {} values", d.values.size());
  }
  if (d.least) text += fmt::format(", at least {:.6g}", *d.least);
  if (d.most) text += fmt::format(", at most {:.6g}", *d.most);
  return text;
}

std::string reliability_text(const json& answer) {
  std::string text = samples_text(answer) + fit_text(answer);
  for (const char* method : {"form", "sorm", "importance", "subset", "sobol"}) text += method_text(answer, method);
  return text + comparison_text(answer);
}

/// Names stand one above the other: side by side they would overlap.
std::string sobol_figure(const json& answer) {
  const json& sobol = answer["sobol"];
  const std::size_t count = answer["variables"].size();
  std::string bars;
  std::string names;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t row = count - 1 - i;
    bars += fmt::format("{} {} {}\n", row, sobol["first"][i].get<double>(), sobol["total"][i].get<double>());
    names += fmt::format("{}{} {}", i == 0 ? "" : ", ", picture::gnuplot_tic(answer["variables"][i]), row);
  }
  return fmt::format(
      "set style fill solid 0.8\nset xlabel 'Sobol''s index'\nset xrange [0:*]\nset yrange [-0.5:{}]\nset key outside "
      "top horizontal\nset grid x\nset ytics ({})\n$bars << EOD\n{}EOD\n"
      "plot $bars using 2:1:(0):2:1:($1+0.35) with boxxyerror lc rgb '#204a87' title 'alone', "
      "'' using 3:1:(0):3:($1-0.35):1 with boxxyerror lc rgb '#8fb0d9' title 'in all'\n",
      static_cast<double>(count) - 0.5, names, bars);
}

void draw_reliability(const json& answer, const std::filesystem::path& folder) {
  std::string rows;
  for (const json& point : answer["curve"]) {
    rows += fmt::format("{} {} {} {}\n", point["level_m"].get<double>(), point["probability"].get<double>(),
                        point["from"].get<double>(), point["to"].get<double>());
  }
  if (!rows.empty()) {
    draw_study(folder / "fragility.png", "Fragility curve",
               fmt::format("set xlabel 'level of the reservoir (m)'\nset ylabel 'probability of failure'\nset yrange "
                           "[0:1]\nset key outside top horizontal\nset grid\nset arrow from {0},0 to {0},1 nohead lc "
                           "rgb '#c00000'\n$curve << EOD\n{1}EOD\nplot $curve using 1:3:4 with filledcurves lc rgb "
                           "'#b8cce4' title '95 % interval', $curve using 1:2 with lines lw 2 lc rgb '#204a87' title "
                           "'samples', NaN lc rgb '#c00000' title 'level asked for'\n",
                           answer["level_m"].get<double>(), rows));
  }
  if (answer.value("sobol", json::object()).contains("first"))
    draw_study(folder / "sobol.png", "What the level of failure depends on", sobol_figure(answer));
}

}  // namespace blockweir::study
