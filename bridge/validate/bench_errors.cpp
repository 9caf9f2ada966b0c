// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/validate/bench_errors.hpp"

#include <fmt/format.h>

#include "bridge/results/counted.hpp"
#include "bridge/study/check_work.hpp"
#include "bridge/study/motion_error.hpp"
#include "bridge/validate/cases_folder.hpp"

namespace blockweir::study {
namespace {

using nlohmann::json;

/// Answers to the runs of one case: first the run with finer steps, if it has one, then its settings.
using Answers = std::vector<json>;

std::vector<json> items_of(const BenchCase& bench) {
  std::vector<json> items;
  const auto add = [&](const BenchSetting& one) {
    items.push_back(bench_item(bench.scene, one.all, one.inproc, bench.finer_steps.has_value()));
  };
  if (bench.finer_steps) add(*bench.finer_steps);
  for (const BenchSetting& setting : bench.settings) add(setting);
  return items;
}

std::string trouble_of(const json& answer) {
  return answer.is_object() ? answer["trouble"].get<std::string>()
                            : "its process was killed; see whether memory is short";
}

BenchError error_of(const json& answer, const Ways& finer, std::string& figure) {
  BenchError found{.trouble = trouble_of(answer)};
  if (!found.trouble.empty()) return found;
  found.energy_gain = answer["energy_gain"];
  if (!finer.empty()) {
    found.error = motion_error(answer["ways"].get<Ways>(), finer);
    return found;
  }
  const json& check = answer["checks"].at(0);
  figure = check["name"];
  if (check["relative_error"].is_number()) {
    found.error = check["relative_error"];
  } else {
    found.trouble = fmt::format("the run has no {}", figure);
  }
  return found;
}

BenchErrors errors_of(const BenchCase& bench, const Answers& answers) {
  BenchErrors errors{.figure = "", .of_motion = bench.finer_steps.has_value(), .settings = {}};
  Ways finer;
  std::size_t at = 0;
  if (bench.finer_steps) {
    const json& answer = answers[at++];
    if (const std::string trouble = trouble_of(answer); !trouble.empty()) throw std::runtime_error(trouble);
    finer = answer["ways"].get<Ways>();
    errors.figure =
        fmt::format("motion until {:.4g} s, by {}", answer["simulated_s"].get<double>(), bench.finer_steps->curve);
  }
  for (; at < answers.size(); ++at) errors.settings.push_back(error_of(answers[at], finer, errors.figure));
  return errors;
}

}  // namespace

std::vector<BenchErrors> errors_of(const std::vector<BenchCase>& cases, engine::Engine& engine) {
  engine::Work work{.name = "bench", .common = {{"by", "check"}}, .items = {}};
  std::vector<Answers> answers(cases.size());
  std::vector<std::size_t> case_of_item;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    for (json& item : items_of(cases[c])) {
      work.items.push_back(std::move(item));
      case_of_item.push_back(c);
    }
  }
  perform_in_order(engine, work, [&](std::size_t i, const json& answer) {
    const std::size_t c = case_of_item[i];
    answers[c].push_back(answer);
    if (i + 1 < case_of_item.size() && case_of_item[i + 1] == c) return;
    fmt::print(stderr, "{}: {}\n", case_name(cases[c].scene), results::counted(answers[c].size(), "run"));
  });
  std::vector<BenchErrors> all;
  for (std::size_t c = 0; c < cases.size(); ++c) all.push_back(errors_of(cases[c], answers[c]));
  return all;
}

}  // namespace blockweir::study
