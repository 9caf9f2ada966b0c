// SPDX-License-Identifier: GPL-3.0-or-later
// Work in the queue of a cluster: an array of tasks, each of which does a batch of items.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bridge/engine/engine.hpp"

namespace blockweir::engine {

struct SlurmOptions {
  std::filesystem::path folder;     ///< absolute, seen by all machines: items, answers and logs of tasks
  int batch = 0;                    ///< items a task; 0: as many as take some ten minutes, see batch_size()
  std::vector<std::string> sbatch;  ///< passed on
};

/// Brief work is done by this machine, by `make`. Throws std::runtime_error where the machine has no sbatch.
std::unique_ptr<Engine> slurm_engine(SlurmOptions options, MakeWorker make);

/// One task of the array that slurm_engine() has submitted: does the batch of `folder` that is called `task`, but for
/// what is done. Its answers go to files that are whole or not there. Returns 0; throws what stops it.
int work_on_batch(const std::filesystem::path& folder, int task, const MakeWorker& make);

}  // namespace blockweir::engine
