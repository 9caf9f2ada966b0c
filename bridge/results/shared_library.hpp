// SPDX-License-Identifier: GPL-3.0-or-later
// Shared libraries of blockweir that a program opens only when it needs them.
#pragma once

#include <string>

namespace blockweir::results {

/// A function or object with C linkage in `library`, which is opened and stays so. Throws std::runtime_error if it
/// cannot be, or has none of this name.
[[nodiscard]] void* symbol_of(const std::string& library, const std::string& name);

}  // namespace blockweir::results
