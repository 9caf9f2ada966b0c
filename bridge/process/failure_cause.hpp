// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the cause of a failed run among the messages of its processes.
#pragma once

#include <filesystem>
#include <string>

#include "bridge/process/supervisor.hpp"

namespace blockweir::process {

/// One line; empty if nothing failed. The first failure in time is the cause; messages of the others about it, and
/// processes that we ended, are its consequences. `folder`: of the results. `patience_s`: [coupling] timeout_s, for a
/// partner that is stopped.
[[nodiscard]] std::string failure_cause(const Supervised& supervised, const std::filesystem::path& folder,
                                        double patience_s = 0);

}  // namespace blockweir::process
