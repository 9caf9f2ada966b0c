// SPDX-License-Identifier: GPL-3.0-or-later
// A DXF file is pairs of lines, a group code and a value. dxflib reads what is no number as 0 and a drawing that is cut
// off as one that ends, so that both are looked for before it reads.
#pragma once

#include <filesystem>
#include <string>

namespace blockweir::scene {

struct DxfFault {
  int line;              ///< in the drawing, from 1
  std::string found;     ///< empty where the pairs are sound
  std::string expected;  ///< instead
};

/// The first of: a group code or a number that is none, a point without all its coordinates, a polyline whose points
/// are not as many as it says, an end without ENDSEC and EOF. Throws std::runtime_error when the file cannot be read.
DxfFault first_fault_of_dxf(const std::filesystem::path& file);

}  // namespace blockweir::scene
