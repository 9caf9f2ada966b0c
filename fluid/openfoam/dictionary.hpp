// SPDX-License-Identifier: GPL-3.0-or-later
// OpenFOAM's file format, as far as a case needs it.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::openfoam {

inline std::string file_header(const std::string& type, const std::string& object) {
  return fmt::format(
      "FoamFile\n{{\n    version     2.0;\n    format      ascii;\n    class       {};\n    object      {};\n}}\n\n",
      type, object);
}

inline std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

/// All digits: the two sides compare outlines bit for bit.
inline std::string exact(double value) {
  return fmt::format("{:.17g}", value);
}

inline std::string point_list(const std::vector<scene::Point>& points) {
  std::string text = "(";
  for (const scene::Point& p : points) text += fmt::format(" ({} {})", exact(p.x()), exact(p.y()));
  return text + " )";
}

}  // namespace blockweir::openfoam
