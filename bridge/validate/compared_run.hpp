// SPDX-License-Identifier: GPL-3.0-or-later
// What the tables of blockweir compare have in common: a run, its figures, the command that repeats it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "bridge/process/run.hpp"

namespace blockweir::study {

/// Throws Interrupted where somebody has stopped it.
process::RunResult uninterrupted(const process::RunOptions& options);

/// What makes the run again, on a command line.
std::string command_of(const process::RunOptions& options);

/// What a run is compared by, each with name, expected, got and relative_error: the figures that the scene states, or
/// where it states none how the run ends.
nlohmann::json figures(const nlohmann::json& summary);

void print_figure(const std::string& name, const std::string& got, const std::string& error);

}  // namespace blockweir::study
