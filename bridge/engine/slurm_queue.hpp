// SPDX-License-Identifier: GPL-3.0-or-later
// Calls Slurm's commands sbatch, squeue and scancel. Signals of the terminal do not reach them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::engine {

/// Throws std::runtime_error with a remedy if the machine has no sbatch.
void require_slurm();

/// Submits `script` as an array of `tasks` tasks; returns the job's number. Throws std::runtime_error with the queue's
/// message if it refuses.
std::string submit(const std::filesystem::path& script, const std::string& name, std::size_t tasks,
                   const std::filesystem::path& logs, const std::vector<std::string>& options);

/// The unfinished tasks of a job.
struct QueueState {
  std::size_t running = 0;
  std::size_t waiting = 0;
  std::string reason;   ///< why a task waits
  std::string trouble;  ///< the queue does not answer; then the other members are unknown
  [[nodiscard]] bool over() const { return trouble.empty() && running + waiting == 0; }
};
QueueState state_of(const std::string& job);

/// Removes the job from the queue and ends its tasks; a job that is already gone is fine. Returns why it may still be
/// there; empty if it was removed.
std::string cancel(const std::string& job);

}  // namespace blockweir::engine
