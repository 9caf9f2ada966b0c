// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir run and blockweir resume: from checking the scene to the report.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace blockweir::process {

struct RunOptions {
  std::filesystem::path scene;
  std::filesystem::path out{};  ///< empty: runs/CASE or runs/CASE-VARIANT, or the first free one with -N appended
  std::string variant{};        ///< one of the scene's [[variant]]; empty: the scene itself
  std::vector<std::string> overrides{};
  bool inproc = false;  ///< still water or a reservoir within the solid's process
  bool strict = false;  ///< warnings of the reader are errors
  bool quiet = false;
  bool tells_progress = false;  ///< although it is quiet
  bool trace = false;           ///< all sides record when they wait and send, in the run's folder "trace"
  bool margin = false;          ///< adds the result of limit analysis to the summary, computed during the run
  bool keeps_others = false;    ///< refuses an `out` with results that would be lost, see refuse_to_lose()
  double longest_s = 0;         ///< limit of wall time, after which the run is ended as hanging; 0: none
};

struct ResumeOptions {
  std::filesystem::path folder;  ///< of a run that was stopped
  bool inproc = false;           ///< see RunOptions
  bool quiet = false;
  bool margin = false;  ///< see RunOptions
};

struct RunResult {
  int exit_code = 0;  ///< 0 done, 1 the run failed, 130 stopped by Ctrl-C
  std::filesystem::path folder;
  std::filesystem::path in_place_of{};  ///< the default folder, if an earlier run occupied it
  bool kept = true;                     ///< false: the folder is removed after the report, which names it nowhere then
  nlohmann::json summary{};
  std::string trouble{};       ///< one line, if it failed
  std::string advice{};        ///< how it may be continued, if it can; needs the folder to last
  bool asked_to_stop = false;  ///< by Ctrl-C, even after the run had ended
  bool refused = false;        ///< failed because all processes ended by themselves with an error message
};

/// Runs a scene's processes. Throws scene::SceneError, with `strict` also for warnings, and std::invalid_argument for a
/// folder in use; nothing has been written in these cases.
RunResult run(const RunOptions& options);

/// Continues a run from its last checkpoint. Throws std::invalid_argument if there is none.
RunResult resume(const ResumeOptions& options);

/// The error with the advice; empty if nothing failed.
std::string trouble_text(const RunResult& result);

/// The report of a finished run for the user.
std::string report(const RunResult& result);

}  // namespace blockweir::process
