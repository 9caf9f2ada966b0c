// SPDX-License-Identifier: GPL-3.0-or-later
// What a fluid process says of itself when a run has ended: where its time went, and how often it did what.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace blockweir::schedule {

struct FluidReport {
  std::map<std::string, double> seconds{};  ///< by phase: wait, pack, wire, mapping, step, output
  std::map<std::string, long> counts{};
  std::vector<std::string> skips{};     ///< what was not done, and what that has saved, in words
  std::vector<std::string> warnings{};  ///< for the run's report
  double peak_memory_mb = 0;            ///< 0: it has no process of its own
};

/// As JSON, {"seconds": {...}, "counts": {...}, "skips": [...], "warnings": [...]}. Throws std::runtime_error when
/// `file` cannot be written.
void write_report(const std::filesystem::path& file, const FluidReport& report);

}  // namespace blockweir::schedule
