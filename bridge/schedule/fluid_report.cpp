// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/schedule/fluid_report.hpp"

#include <nlohmann/json.hpp>

#include "bridge/results/result_file.hpp"

namespace blockweir::schedule {

void write_report(const std::filesystem::path& file, const FluidReport& report) {
  nlohmann::json text = {
      {"seconds", report.seconds}, {"counts", report.counts}, {"skips", report.skips}, {"warnings", report.warnings}};
  if (report.peak_memory_mb > 0) text["peak_memory_mb"] = report.peak_memory_mb;
  results::replace_file(file, text.dump(2) + "\n");
}

}  // namespace blockweir::schedule
