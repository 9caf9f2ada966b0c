// SPDX-License-Identifier: GPL-3.0-or-later
// Shared libraries of blockweir that a program opens only when it needs them.
#pragma once

#include <string>

namespace blockweir::results {

/// A function with C linkage in `library`, which is opened and stays so. Throws std::runtime_error if it cannot be.
[[nodiscard]] void* function_in(const std::string& library, const std::string& name);

}  // namespace blockweir::results
