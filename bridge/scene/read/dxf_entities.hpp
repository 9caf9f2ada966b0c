// SPDX-License-Identifier: GPL-3.0-or-later
// What a DXF drawing draws, each by kind and layer: also what dxflib does not show.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::scene {

struct DxfEntity {
  std::string kind;      ///< as in the file; with a reason after it where it is a polyline that is not read
  std::string layer;     ///< in lower case
  int line = 0;          ///< in the drawing, from 1
  std::string block;     ///< in lower case: the BLOCK that it is part of, which draws nothing by itself; else empty
  std::string inserted;  ///< in lower case: the BLOCK that an INSERT places
};

/// Of the sections ENTITIES and BLOCKS, without paper space. The file has no fault (first_fault_of_dxf).
std::vector<DxfEntity> entities_of_dxf(const std::filesystem::path& file);

}  // namespace blockweir::scene
