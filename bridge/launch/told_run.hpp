// SPDX-License-Identifier: GPL-3.0-or-later
// A run whose end is told to people.
#pragma once

#include <fmt/format.h>

#include "bridge/process/run.hpp"
#include "bridge/process/supervisor.hpp"

namespace blockweir::launch {

/// Makes a run, says how it ended and returns the exit status. What has ended by itself was not stopped: a signal that
/// comes until the program's end is too late.
template <class Run>
int told(Run run) {
  static const process::StopsLater until_it_is_reported;
  const process::RunResult result = run();
  if (!result.trouble.empty()) fmt::print(stderr, "blockweir: {}\n", process::trouble_text(result));
  fmt::print("{}", process::report(result));
  return result.exit_code;
}

}  // namespace blockweir::launch
