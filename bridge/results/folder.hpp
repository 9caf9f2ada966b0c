// SPDX-License-Identifier: GPL-3.0-or-later
// Where results go: places that are made, or refused before anything is written.
#pragma once

#include <filesystem>

namespace blockweir::results {

/// Makes `folder` and what is missing above it. Throws std::invalid_argument with one line for the user when it
/// cannot be made or written, and leaves nothing behind then.
void make_folder(const std::filesystem::path& folder);

/// Throws std::invalid_argument with one line for the user when `file`, given as `option`, could not be written.
void require_writable_file(const char* option, const std::filesystem::path& file);

}  // namespace blockweir::results
