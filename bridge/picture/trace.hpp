// SPDX-License-Identifier: GPL-3.0-or-later
// What both sides of a run did when, as a trace file that Perfetto (ui.perfetto.dev) and Chrome (chrome://tracing)
// open.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace blockweir::picture {

/// The trace of a folder's files SIDE.csv, whose lines are "what,window,from_ns,to_ns": each side a process with a span
/// a coupling window, and within it spans "compute", "send" and "wait"; an arrow a message. Times in microseconds since
/// the first of all. Throws std::invalid_argument where there are none, or one cannot be read.
[[nodiscard]] nlohmann::json trace_of_sides(const std::filesystem::path& folder);

/// Writes RUN/trace.json from RUN/trace, and returns its name.
std::filesystem::path trace(const std::filesystem::path& run);

}  // namespace blockweir::picture
