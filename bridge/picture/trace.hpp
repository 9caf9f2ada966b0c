// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a trace file of both sides' activities, for Perfetto (ui.perfetto.dev) and Chrome
// (chrome://tracing).
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace blockweir::picture {

/// The trace of all files SIDE.csv in a folder, with lines "what,window,from_ns,to_ns". Each side is a process with one
/// span for each coupling window, divided into "compute", "send" and "wait"; each message is an arrow. Times in
/// microseconds since the first event. Throws std::invalid_argument if there are no files, or one cannot be read.
[[nodiscard]] nlohmann::json trace_of_sides(const std::filesystem::path& folder);

/// Writes RUN/trace.json from RUN/trace, and returns its name.
std::filesystem::path trace(const std::filesystem::path& run);

}  // namespace blockweir::picture
