// SPDX-License-Identifier: GPL-3.0-or-later
// Runs OpenFOAM's programs and reports their errors.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace blockweir::openfoam {

/// Throws std::runtime_error if interFoam is not on the PATH. Debian's OpenFOAM has no environment to source: its
/// programs get their settings here.
void find_openfoam();

/// interFoam's version, e.g. "1912", or "none: " and the reason, in one line.
std::string openfoam_version();

/// The library for interFoam: beside this program in a build tree, in ../lib of an installation. Throws
/// std::runtime_error if it is in neither.
std::filesystem::path find_plugin();

/// Runs a program; its output goes to log.NAME in the case's folder. Throws std::runtime_error with one line if it
/// fails.
void run_program(const std::string& name, std::vector<std::string> words, const std::filesystem::path& folder);

/// Value of a dictionary entry, macros expanded, as OpenFOAM prints it; none if the file lacks it.
std::optional<std::string> entry(const std::filesystem::path& folder, const std::string& file, const std::string& name);

/// Sets or adds an entry; the rest of the dictionary stays.
void set_entry(const std::filesystem::path& folder, const std::string& file, const std::string& name,
               const std::string& value);

}  // namespace blockweir::openfoam
