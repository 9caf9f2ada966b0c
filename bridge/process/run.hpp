// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir run and blockweir resume: a scene from check to report.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace blockweir::process {

struct RunOptions {
  std::filesystem::path scene;
  std::filesystem::path out{};  ///< empty: runs/CASE, or runs/CASE-VARIANT; or the first free with -N behind it
  std::string variant{};        ///< one of the scene's [[variant]]; empty: the scene itself
  std::vector<std::string> overrides{};
  bool inproc = false;  ///< still water or a reservoir within the solid's process
  bool strict = false;  ///< what the reader warns of is refused
  bool quiet = false;
  bool trace = false;    ///< all sides say when they wait and when they send: files in the run's folder "trace"
  bool margin = false;   ///< the summary gets what limit analysis says, found while the run goes on
  double longest_s = 0;  ///< of wall time, after which it counts as hanging and is ended; 0: as long as it takes
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
  std::filesystem::path in_place_of{};  ///< the folder that would have been its own, had no earlier run been there
  nlohmann::json summary{};
  std::string trouble{};       ///< one line, when it failed
  std::string advice{};        ///< how it may go on, where it can; its folder has to last
  bool asked_to_stop = false;  ///< by Ctrl-C, be it after the run had ended
  bool refused = false;        ///< when it failed: all processes ended by themselves, and said why
};

/// Runs a scene's processes. Throws scene::SceneError, with `strict` for warnings too, and std::invalid_argument for a
/// folder that is in use; nothing has been written then.
RunResult run(const RunOptions& options);

/// Goes on with a run from its last checkpoint. Throws std::invalid_argument where there is none.
RunResult resume(const ResumeOptions& options);

/// Its trouble with the advice; empty where it went well.
std::string trouble_text(const RunResult& result);

/// What a person wants to know of a finished run.
std::string report(const RunResult& result);

}  // namespace blockweir::process
