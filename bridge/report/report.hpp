// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir report: one page to hand in, with all results of a scene.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::study {

struct ReportOptions {
  std::filesystem::path source;        ///< folder of a run, or a scene, which is then run
  std::filesystem::path out;           ///< HTML file; empty: report.html in the run's folder
  std::filesystem::path reliability;   ///< folder of blockweir reliability; empty: computed here by limit analysis
  std::filesystem::path run;           ///< folder for the run of a scene; empty: as process::run() has it, or a
                                       ///< temporary one where that cannot be written and `out` is named
  std::string variant;                 ///< of a scene
  std::vector<std::string> overrides;  ///< of a scene
  std::string program;                 ///< version, commit, compiler: a line each
};

/// Returns 0; 1 if the scene's run failed: then no page is written; 130 if Ctrl-C ended a search after the run: the
/// page has what was known by then. Throws process::Stopped if the run was stopped, scene::SceneError, and
/// std::invalid_argument for an unsuitable source or file.
int write_report(const ReportOptions& options);

}  // namespace blockweir::study
