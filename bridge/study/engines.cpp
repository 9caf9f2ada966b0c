// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/engines.hpp"

#include "bridge/engine/slurm_engine.hpp"
#include "bridge/study/outcome_work.hpp"

namespace blockweir::study {

int jobs_of(const EngineOptions& options) {
  return options.jobs > 0 ? options.jobs : engine::processors();
}

std::unique_ptr<engine::Engine> make_engine(const EngineOptions& options, const std::filesystem::path& folder) {
  if (options.name != "slurm" && (options.batch > 0 || !options.sbatch.empty())) {
    throw std::invalid_argument("--batch and --sbatch are of --engine slurm; add it, or leave them out");
  }
  if (options.name == "local") return engine::local_engine(jobs_of(options), study_worker);
  if (options.jobs > 0) {
    throw std::invalid_argument(
        "--jobs is of --engine local; leave it out: Slurm decides how many tasks run at once "
        "(--sbatch --array is set by blockweir; --sbatch --cpus-per-task=N lets a task use N processors)");
  }
  return engine::slurm_engine(
      {.folder = std::filesystem::absolute(folder), .batch = options.batch, .sbatch = options.sbatch}, study_worker);
}

}  // namespace blockweir::study
