// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir bench: wall time against error, over the settings that a case's [[bench]] names.
#pragma once

#include <filesystem>
#include <vector>

namespace blockweir::launch {

struct BenchOptions {
  std::vector<std::filesystem::path> cases;  ///< empty: all that have a [[bench]]
  std::filesystem::path out = "runs/bench";  ///< folder for the table and a picture a case
  bool brief = false;                        ///< two values a curve, each run once
};

/// Prints a row a run, draws each case, writes bench.json, and says which scenes as they stand are bettered by another
/// setting. Returns 1 when a run failed, else 0.
int bench(const BenchOptions& options);

}  // namespace blockweir::launch
