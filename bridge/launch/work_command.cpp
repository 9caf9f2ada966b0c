// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "bridge/engine/slurm_engine.hpp"
#include "bridge/launch/commands.hpp"
#include "bridge/study/outcome_work.hpp"

namespace blockweir::launch {

Work work_command(CLI::App& app) {
  const auto folder = std::make_shared<std::string>();
  const auto task = std::make_shared<int>(0);
  app.add_option("folder", *folder, "folder of the batch")->required();
  app.add_option("task", *task, "number of the task")->required();
  return [folder, task] { return engine::work_on_batch(*folder, *task, study::study_worker); };
}

}  // namespace blockweir::launch
