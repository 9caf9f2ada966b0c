// SPDX-License-Identifier: GPL-3.0-or-later
// The manual page, made from the help texts.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace blockweir::launch {

/// Section 1, in roff; man -l displays it.
std::string manual(const CLI::App& app);

}  // namespace blockweir::launch
