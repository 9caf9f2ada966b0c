// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the engine that a command asks for.
#pragma once

#include <filesystem>
#include <memory>

#include "bridge/engine/engine.hpp"
#include "bridge/study/engine_options.hpp"

namespace blockweir::study {

/// Least number of items worked on at once; a study requests as many at a time.
[[nodiscard]] int jobs_of(const EngineOptions& options);

/// An engine for outcomes. `folder`: for files of a queue, on a disk that all machines of a cluster see; absolute or
/// not. Throws std::invalid_argument if options contradict each other, and std::runtime_error if the machine has no
/// such queue.
std::unique_ptr<engine::Engine> make_engine(const EngineOptions& options, const std::filesystem::path& folder);

}  // namespace blockweir::study
