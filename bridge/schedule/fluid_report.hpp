// SPDX-License-Identifier: GPL-3.0-or-later
// A fluid process's report at the end of a run: times and counts.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace blockweir::schedule {

struct FluidReport {
  std::map<std::string, double> seconds{};  ///< by phase: wait, pack, wire, mapping, step, output
  std::map<std::string, long> counts{};
  std::vector<std::string> skips{};     ///< skipped work and the time saved, in words
  std::vector<std::string> warnings{};  ///< for the run's report
  double peak_memory_mb = 0;            ///< 0: no process of its own
};

/// Writes JSON, {"seconds": {...}, "counts": {...}, "skips": [...], "warnings": [...]}. Throws std::runtime_error if
/// `file` cannot be written.
void write_report(const std::filesystem::path& file, const FluidReport& report);

}  // namespace blockweir::schedule
