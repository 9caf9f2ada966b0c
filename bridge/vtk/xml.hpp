// SPDX-License-Identifier: GPL-3.0-or-later
// What the shared library blockweir_vtk does: VTK's own writer, apart, as loading VTK takes longer than a small run.
#pragma once

#include <string>

#include "bridge/vtk/grid.hpp"

namespace blockweir::vtk {

constexpr const char* xml_library = "libblockweir_vtk.so";
constexpr const char* xml_function = "blockweir_vtk_xml";

/// Stores the text of a .vtu file in `text`; false if VTK refuses the grid.
using XmlFunction = bool(const Grid& grid, std::string& text);

}  // namespace blockweir::vtk
