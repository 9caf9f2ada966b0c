// SPDX-License-Identifier: GPL-3.0-or-later
// Where the runs of a study are made: what a command's --engine and its like say.
#pragma once

#include <string>
#include <vector>

namespace blockweir::study {

struct EngineOptions {
  std::string name = "local";       ///< or "slurm"
  int jobs = 0;                     ///< local: processes at once; 0: one a processor
  int batch = 0;                    ///< slurm: items a task; 0: as many as take some ten minutes
  std::vector<std::string> sbatch;  ///< slurm: options passed on to sbatch
};

}  // namespace blockweir::study
