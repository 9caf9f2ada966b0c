// SPDX-License-Identifier: GPL-3.0-or-later
// What a shell needs to complete commands and options, made from the commands themselves.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace blockweir::launch {

/// A script for bash. What is no command and no option is completed as a file's name.
std::string bash_completion(const CLI::App& app);

/// The same for zsh, with the help texts; to be sourced, or as the file _blockweir in a folder of fpath.
std::string zsh_completion(const CLI::App& app);

}  // namespace blockweir::launch
