// SPDX-License-Identifier: GPL-3.0-or-later
// Several runs at once.
#pragma once

#include <cstddef>
#include <functional>

namespace blockweir::process {

/// As many as the machine runs at once.
[[nodiscard]] int processors();

/// Calls work(i) for each i below `count` in a process of its own, since a run has signals and children to itself; at
/// most `jobs` of them at once. What work() leaves is in files. ended(i) is called here as each ends, however it ends.
/// SIGINT and SIGTERM to us are passed on, and nothing more is begun: false then, once all have ended. The kernel ends
/// them should we be killed. Throws std::runtime_error where no process can be made.
[[nodiscard]] bool side_by_side(std::size_t count, int jobs, const std::function<void(std::size_t)>& work,
                                const std::function<void(std::size_t)>& ended);

}  // namespace blockweir::process
