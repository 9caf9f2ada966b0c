// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of blockweir.
#pragma once

namespace blockweir::launch {

/// Reads the command and its options, and executes it. Returns the exit status: 2 if CLI11 refuses the command line.
/// Throws std::invalid_argument where a command is unknown or --out impossible, and whatever the command throws.
int run_command_line(int argc, char** argv);

}  // namespace blockweir::launch
