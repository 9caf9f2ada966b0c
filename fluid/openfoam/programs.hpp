// SPDX-License-Identifier: GPL-3.0-or-later
// OpenFOAM's programs, and what they say when they fail.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace blockweir::openfoam {

/// Throws std::runtime_error when interFoam is not on the PATH. Debian's OpenFOAM has no environment to source: its
/// programs are told where their settings are.
void find_openfoam();

/// The version that interFoam states, "1912", or "none: " and why: one line.
std::string openfoam_version();

/// The library that interFoam loads: beside this program in a build tree, in ../lib of an installation. Throws
/// std::runtime_error where it is in neither.
std::filesystem::path find_plugin();

/// Runs a program whose messages go to log.NAME in the case's folder. Throws std::runtime_error with one line when it
/// fails.
void run_program(const std::string& name, std::vector<std::string> words, const std::filesystem::path& folder);

/// Value of a dictionary's entry, macros expanded, as OpenFOAM prints it; none where the file lacks it.
std::optional<std::string> entry(const std::filesystem::path& folder, const std::string& file, const std::string& name);

/// Sets an entry, or adds it; what else stands in the dictionary stays.
void set_entry(const std::filesystem::path& folder, const std::string& file, const std::string& name,
               const std::string& value);

}  // namespace blockweir::openfoam
