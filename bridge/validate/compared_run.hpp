// SPDX-License-Identifier: GPL-3.0-or-later
// Common parts of the tables of blockweir compare: a run, its figures, the command that repeats it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "bridge/process/run.hpp"

namespace blockweir::study {

/// Says on stderr what runs, and how far it is. Throws Interrupted if it is stopped.
process::RunResult uninterrupted(const std::string& what, process::RunOptions options);

/// The command line that repeats the run.
std::string command_of(const process::RunOptions& options);

/// Figures to compare, each with name, expected, got and relative_error: those that the scene states, or, if it states
/// none, the outcome of the run.
nlohmann::json figures(const nlohmann::json& summary);

void print_figure(const std::string& name, const std::string& got, const std::string& error);

}  // namespace blockweir::study
