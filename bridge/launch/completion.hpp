// SPDX-License-Identifier: GPL-3.0-or-later
// Shell completion of commands and options, made from the commands themselves.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace blockweir::launch {

/// A script for bash. Words that are neither a command nor an option are completed as file names.
std::string bash_completion(const CLI::App& app);

/// The same for zsh, with help texts; to be sourced, or as file _blockweir in a folder of fpath.
std::string zsh_completion(const CLI::App& app);

}  // namespace blockweir::launch
