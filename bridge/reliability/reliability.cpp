// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/reliability/reliability.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/process/programs.hpp"
#include "bridge/reliability/refused_draws.hpp"
#include "bridge/reliability/reliability_answer.hpp"
#include "bridge/reliability/reliability_output.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/folder_lock.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/results/wrapped.hpp"

namespace blockweir::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

bool all_answered(const json& answer) {
  if (answer["samples"]["without_answer"] != 0) return false;
  return std::none_of(answer.begin(), answer.end(),
                      [](const json& part) { return part.is_object() && part.contains("trouble"); });
}

}  // namespace

int print_reliability(const ReliabilityOptions& options) {
  if (!options.json.empty()) results::require_writable_file("--json", options.json, {".json"});
  const scene::ReadScene read = scene::read(options.scene, options.overrides);
  for (const auto& warning : read.warnings) fmt::print(stderr, "{}", results::for_stderr(warning.text() + "\n"));
  if (read.randomness.variables.empty()) {
    throw std::invalid_argument(fmt::format(
        "{}: found no [[random]]; expected one for each number that is uncertain; add [[random]] with key = "
        "\"joint.friction_angle_deg\", distribution = \"normal\", mean = 30 and deviation = 2, say",
        options.scene.string()));
  }
  refuse_overridden_draws(read, options.overrides);
  for (const auto& warning : refused_draws(options.scene, read, options.overrides)) {
    fmt::print(stderr, "{}", results::for_stderr(warning.text() + "\n"));
  }
  const fs::path folder =
      options.out.empty() ? fs::path("runs") / (process::case_name(options.scene) + "-reliability") : options.out;
  results::make_folder(folder);
  const results::FolderLock lock(folder);
  try {
    const auto [answer, samples] = find_reliability(options, read, folder);
    results::replace_file(folder / "samples.csv", samples);
    fmt::print("{}", results::for_stdout(reliability_text(answer)));
    draw_reliability(answer, folder);
    results::replace_file(folder / "reliability.json", answer.dump(2) + "\n");
    if (!options.json.empty()) results::replace_file(options.json, answer.dump(2) + "\n");
    fmt::print("{0}/samples.csv\n{0}/reliability.json\n", folder.string());
    return all_answered(answer) ? 0 : 1;
  } catch (const Interrupted&) {
    fmt::print(stderr, "stopped on request; the same command continues\n");
    return 130;
  }
}

}  // namespace blockweir::study
