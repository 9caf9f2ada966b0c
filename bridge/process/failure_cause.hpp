// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the cause of a failed run among the messages of its processes.
#pragma once

#include <filesystem>
#include <string>

#include "bridge/process/supervisor.hpp"

namespace blockweir::process {

/// One line; empty if nothing failed. The first failure in time is the cause; messages of the others about it, and
/// processes that we ended, are its consequences. `folder`: of the results.
[[nodiscard]] std::string failure_cause(const Supervised& supervised, const std::filesystem::path& folder);

}  // namespace blockweir::process
