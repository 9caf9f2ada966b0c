// SPDX-License-Identifier: GPL-3.0-or-later
// Command-line options for the engine of a study: the same for all commands.
#pragma once

#include <CLI/CLI.hpp>

#include "bridge/study/engine_options.hpp"

namespace blockweir::launch {

inline void add_engine_options(CLI::App& app, study::EngineOptions& options) {
  app.add_option("--engine", options.name,
                 "local: processes of this machine (default); slurm: tasks in the queue of a cluster")
      ->check(CLI::IsMember({"local", "slurm"}));
  app.add_option("--jobs", options.jobs, "local: number of runs at the same time (default: one per processor)")
      ->check(CLI::Range(1, 10000));
  app.add_option("--batch", options.batch,
                 "slurm: number of runs in a task (default: as many as take some ten minutes)")
      ->check(CLI::Range(1, 1000000));
  app.add_option("--sbatch", options.sbatch,
                 "slurm: an option of sbatch, passed on, as --sbatch=--partition=long; may be repeated");
}

}  // namespace blockweir::launch
