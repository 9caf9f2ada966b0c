// SPDX-License-Identifier: GPL-3.0-or-later
// The manual page, made from the help texts.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace blockweir::launch {

/// Of section 1, in roff: man -l shows it.
std::string manual(const CLI::App& app);

}  // namespace blockweir::launch
