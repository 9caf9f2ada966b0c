// SPDX-License-Identifier: GPL-3.0-or-later
// Folders and files of results: made, or refused before anything is written.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::results {

/// Makes `folder` and its missing parents. Throws std::invalid_argument with one line for the user if it cannot be made
/// or written, and leaves nothing behind then.
void make_folder(const std::filesystem::path& folder);

/// Throws std::invalid_argument with one line for the user if `file`, given as `option`, cannot be written, or if its
/// name has none of these endings: it may be a scene, which would be overwritten. A device or a pipe may have any name.
void require_writable_file(const char* option, const std::filesystem::path& file,
                           const std::vector<std::string>& endings);

/// Throws std::runtime_error with one line for the user if less than `mb` are free on the disk that holds `place`, or
/// will hold it. To be asked before work whose result is to be kept there.
void require_room(const std::filesystem::path& place, double mb);

}  // namespace blockweir::results
