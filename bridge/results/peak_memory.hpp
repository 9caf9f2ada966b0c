// SPDX-License-Identifier: GPL-3.0-or-later
// The largest memory use so far of this process, or of the largest child process that has ended.
#pragma once

#include <sys/resource.h>

#include <algorithm>

namespace blockweir::results {

/// [MB]
inline double peak_memory_mb() {
  rusage own = {};
  rusage children = {};
  ::getrusage(RUSAGE_SELF, &own);
  ::getrusage(RUSAGE_CHILDREN, &children);
  return static_cast<double>(std::max(own.ru_maxrss, children.ru_maxrss)) / 1024;
}

}  // namespace blockweir::results
