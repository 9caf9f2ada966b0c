// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a DXF file before dxflib reads it. The file is a list of pairs, a group code and a value. dxflib would read a
// wrong number as 0, and would accept a truncated drawing.
#pragma once

#include <filesystem>
#include <string>

namespace blockweir::scene {

struct DxfFault {
  int line;              ///< in the drawing, from 1
  std::string found;     ///< empty: no fault
  std::string expected;  ///< what should be there
};

/// The first fault: a wrong number, a point that lacks a coordinate, a polyline whose number of points differs from the
/// stated one, a missing ENDSEC or EOF. Throws std::runtime_error if the file cannot be read.
DxfFault first_fault_of_dxf(const std::filesystem::path& file);

}  // namespace blockweir::scene
