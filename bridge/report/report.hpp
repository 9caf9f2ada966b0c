// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir report: all that is known of a scene, as one page to hand in.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::study {

struct ReportOptions {
  std::filesystem::path source;        ///< folder of a run, or a scene, which is run then
  std::filesystem::path out;           ///< HTML file; empty: report.html in the run's folder
  std::filesystem::path reliability;   ///< folder of blockweir reliability; empty: it is found here, by limit analysis
  std::filesystem::path run;           ///< folder for the run of a scene; empty: as process::run() has it, or a
                                       ///< temporary one where that cannot be written and `out` is named
  std::string variant;                 ///< of a scene
  std::vector<std::string> overrides;  ///< of a scene
  std::string program;                 ///< version, commit, compiler: a line each
};

/// Returns 0; 1 where the scene's run failed, and 130 where it was stopped: no page is written then. Throws
/// process::Stopped, scene::SceneError, and std::invalid_argument for a source or a file that will not do.
int write_report(const ReportOptions& options);

}  // namespace blockweir::study
