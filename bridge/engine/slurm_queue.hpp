// SPDX-License-Identifier: GPL-3.0-or-later
// Slurm's own commands: sbatch, squeue, scancel. No signal of a terminal ends them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::engine {

/// Throws std::runtime_error with what to do where the machine has no sbatch.
void require_slurm();

/// Puts `script` into the queue as an array of `tasks` tasks; returns the job's number. Throws std::runtime_error with
/// the queue's own words where it refuses.
std::string submit(const std::filesystem::path& script, const std::string& name, std::size_t tasks,
                   const std::filesystem::path& logs, const std::vector<std::string>& options);

/// The tasks of a job that have not ended.
struct QueueState {
  std::size_t running = 0;
  std::size_t waiting = 0;
  std::string reason;   ///< why one waits
  std::string trouble;  ///< the queue does not answer; the rest is not known then
  [[nodiscard]] bool over() const { return trouble.empty() && running + waiting == 0; }
};
QueueState state_of(const std::string& job);

/// Takes the job out of the queue and ends its tasks. That it has gone already is well. Returns why it may still be
/// there; empty where it has been taken out.
std::string cancel(const std::string& job);

}  // namespace blockweir::engine
