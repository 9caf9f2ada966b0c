// SPDX-License-Identifier: GPL-3.0-or-later
// What blockweir --version prints.
#pragma once

#include <string>

namespace blockweir::launch {

/// Version, commit, compiler, and the OpenFOAM that blockweir-openfoam finds: a line each. Throws process::Stopped.
std::string version();

}  // namespace blockweir::launch
