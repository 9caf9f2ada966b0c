// SPDX-License-Identifier: GPL-3.0-or-later
// What the kernel says of a process and of those that it has started.
#pragma once

#include <sys/types.h>

#include <vector>

namespace blockweir::process {

/// `pid`, and all that it and its children have started and that still runs.
[[nodiscard]] std::vector<pid_t> family_of(pid_t pid);

/// Has one of them been stopped, as by SIGSTOP, so that it can neither go on nor end?
[[nodiscard]] bool is_stopped(const std::vector<pid_t>& family);

}  // namespace blockweir::process
