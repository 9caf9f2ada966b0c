// SPDX-License-Identifier: GPL-3.0-or-later
// Work in a cluster's Slurm queue: an array of tasks, each of which works on a batch of items.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bridge/engine/engine.hpp"

namespace blockweir::engine {

struct SlurmOptions {
  std::filesystem::path folder;     ///< absolute path that all machines see: items, answers and logs of tasks
  int batch = 0;                    ///< items for each task; 0: as many as take about ten minutes, see batch_size()
  std::vector<std::string> sbatch;  ///< further options for sbatch
};

/// Brief work is done on this machine with `make`. Throws std::runtime_error if the machine has no sbatch.
std::unique_ptr<Engine> slurm_engine(SlurmOptions options, MakeWorker make);

/// Runs one task of the array submitted by slurm_engine(): the items of batch `task` in `folder` that are not done yet.
/// Its answer files are complete or absent. Returns 0; throws the error that stops it.
int work_on_batch(const std::filesystem::path& folder, int task, const MakeWorker& make);

}  // namespace blockweir::engine
