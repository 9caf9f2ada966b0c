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
    std::string layer;          ///< in lower case
    std::vector<Point> points;  ///< in drawing units; a closed line repeats its first point at the end
  };
  struct Mark {
    std::string layer;
    Point point;
  };
  std::vector<Line> lines;
  std::vector<Mark> marks;
};

/// Bulges are taken as straight: entities_of_dxf tells them. Throws std::runtime_error if the file cannot be read.
DxfDrawing read_dxf(const std::filesystem::path& file);

}  // namespace blockweir::scene
