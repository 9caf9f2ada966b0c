// SPDX-License-Identifier: GPL-3.0-or-later
// Of all that processes say when a run breaks off: what the user is to read.
#pragma once

#include <filesystem>
#include <string>

#include "bridge/process/supervisor.hpp"

namespace blockweir::process {

/// One line; empty where all went well. The first failure in time is the cause; what the others say of it is its echo,
/// and what we have ended ourselves is its consequence. `folder`: of the results.
[[nodiscard]] std::string failure_cause(const Supervised& supervised, const std::filesystem::path& folder);

}  // namespace blockweir::process
