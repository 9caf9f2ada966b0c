// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and points of a DXF drawing.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

struct DxfDrawing {
  struct Line {
    std::string layer;          ///< in small letters
    std::vector<Point> points;  ///< in drawing units; the first again at the end of a closed one
  };
  struct Mark {
    std::string layer;
    Point point;
  };
  std::vector<Line> lines;
  std::vector<Mark> marks;
  int curves = 0;  ///< arcs, circles, ellipses and bulges on any layer, which were not taken
};

/// Throws std::runtime_error when the file cannot be read.
DxfDrawing read_dxf(const std::filesystem::path& file);

}  // namespace blockweir::scene
