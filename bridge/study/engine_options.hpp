// SPDX-License-Identifier: GPL-3.0-or-later
// Where the runs of a study are computed: --engine and related options.
#pragma once

#include <string>
#include <vector>

namespace blockweir::study {

struct EngineOptions {
  std::string name = "local";       ///< or "slurm"
  int jobs = 0;                     ///< local: processes at once; 0: one for each processor
  int batch = 0;                    ///< slurm: items for each task; 0: as many as take about ten minutes
  std::vector<std::string> sbatch;  ///< slurm: options passed on to sbatch
};

}  // namespace blockweir::study
