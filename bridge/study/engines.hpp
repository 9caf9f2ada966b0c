// SPDX-License-Identifier: GPL-3.0-or-later
// The engine that a command asks for.
#pragma once

#include <filesystem>
#include <memory>

#include "bridge/engine/engine.hpp"
#include "bridge/study/engine_options.hpp"

namespace blockweir::study {

/// How many items are worked on at once at least: what a study asks for in one go.
[[nodiscard]] int jobs_of(const EngineOptions& options);

/// For outcomes. `folder`: absolute or not, on a disk that all machines of a cluster see; what a queue works on is
/// there. Throws std::invalid_argument where options do not go together, and std::runtime_error where the machine has
/// no such queue.
std::unique_ptr<engine::Engine> make_engine(const EngineOptions& options, const std::filesystem::path& folder);

}  // namespace blockweir::study
