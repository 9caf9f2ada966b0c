// SPDX-License-Identifier: GPL-3.0-or-later
// The text of a scene, run with its still water by a process of its own that is ended once it has taken too much of the
// processor.
#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "bridge/process/sides.hpp"

namespace blockweir::test {

/// What a run's summary says of its end; NaN where it has no such figure.
struct Verdict {
  std::string outcome;  ///< as in the summary; or "crashed", "took too long", "refused"
  std::string mode;
  std::string joint;
  double level_m = std::numeric_limits<double>::quiet_NaN();
  double head_m = std::numeric_limits<double>::quiet_NaN();
  double time_s = std::numeric_limits<double>::quiet_NaN();
  double uncertainty_m = std::numeric_limits<double>::quiet_NaN();
  std::string trouble;  ///< what it said where it did not end well
};

inline Verdict verdict_of(const std::filesystem::path& folder) {
  Verdict verdict;
  std::ifstream stream(folder / "summary.json");
  const auto summary = nlohmann::json::parse(stream, nullptr, /*allow_exceptions=*/false);
  if (!summary.is_object()) return verdict;
  verdict.outcome = summary.value("outcome", "");
  verdict.trouble = summary.value("stopped", "");
  if (!summary.contains("failure") || !summary["failure"].is_object()) return verdict;
  const auto& failure = summary["failure"];
  const auto number = [&](const char* key, double& value) {
    if (failure.contains(key) && failure[key].is_number()) value = failure[key];
  };
  number("level_m", verdict.level_m);
  number("head_m", verdict.head_m);
  number("time_s", verdict.time_s);
  number("level_uncertainty_m", verdict.uncertainty_m);
  verdict.mode = failure.value("mode", "");
  verdict.joint = failure.value("joint", "");
  return verdict;
}

/// In `folder`, which must exist, in `longest_s` seconds of the processor. Nothing that the child does ends the test.
inline Verdict run_scene(const std::string& scene, const std::filesystem::path& folder, rlim_t longest_s) {
  std::filesystem::remove(folder / "summary.json");
  std::ofstream(folder / "scene.toml") << scene;
  const pid_t child = fork();
  if (child == 0) {
    const int log = ::open((folder / "log").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(log, STDERR_FILENO);
    ::dup2(log, STDOUT_FILENO);
    const rlimit processor{longest_s, longest_s + 1};
    ::setrlimit(RLIMIT_CPU, &processor);
    int status = 0;
    try {
      process::run_process(
          {.scene = (folder / "scene.toml").string(), .folder = folder.string(), .make_fluid = hydrostatic::make});
    } catch (const std::exception& error) {
      const std::string text = error.what();
      status = ::write(log, text.data(), text.size()) < 0 ? 3 : 2;
    }
    ::_exit(status);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  Verdict verdict = verdict_of(folder);
  const bool ended = WIFEXITED(status);
  if (ended && WEXITSTATUS(status) == 0) return verdict;
  std::ostringstream log;
  log << std::ifstream(folder / "log").rdbuf();
  if (verdict.trouble.empty()) verdict.trouble = log.str().substr(0, 600);
  if (!ended) verdict.outcome = WTERMSIG(status) == SIGXCPU ? "took too long" : "crashed";
  if (ended && verdict.outcome.empty()) verdict.outcome = "refused";
  return verdict;
}

}  // namespace blockweir::test
