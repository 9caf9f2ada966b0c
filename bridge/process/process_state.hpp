// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel's information on a process and its descendants.
#pragma once

#include <sys/types.h>

#include <vector>

namespace blockweir::process {

/// `pid` and all its descendants that still run.
[[nodiscard]] std::vector<pid_t> family_of(pid_t pid);

/// Whether one of them is stopped (SIGSTOP) and so can neither continue nor end.
[[nodiscard]] bool is_stopped(const std::vector<pid_t>& family);

}  // namespace blockweir::process
