// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a run and prints its report.
#pragma once

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include "bridge/process/run.hpp"
#include "bridge/process/supervisor.hpp"
#include "bridge/results/wrapped.hpp"

namespace blockweir::launch {

/// Whether both streams go to the same terminal, file or pipe.
inline bool errors_go_to_the_output() {
  struct stat out = {};
  struct stat err = {};
  return ::fstat(STDOUT_FILENO, &out) == 0 && ::fstat(STDERR_FILENO, &err) == 0 && out.st_dev == err.st_dev &&
         out.st_ino == err.st_ino;
}

/// Makes a run, prints its report and returns the exit status. A run that ended by itself was not stopped, even if a
/// signal arrives before the program ends.
template <class Run>
int run_and_report(Run run) {
  const process::StopsLater until_it_has_run;
  const process::RunResult result = run();
  for (const int stop : {SIGINT, SIGTERM}) std::signal(stop, SIG_IGN);  // those that wait are dropped, too
  // The report contains it, too.
  if (!result.trouble.empty() && !errors_go_to_the_output()) {
    fmt::print(stderr, "blockweir: {}\n", process::trouble_text(result));
  }
  fmt::print("{}", results::for_stdout(process::report(result)));
  return result.exit_code;
}

}  // namespace blockweir::launch
