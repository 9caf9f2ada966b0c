// SPDX-License-Identifier: GPL-3.0-or-later
// Places and figures in texts: what is round-off is 0.
#pragma once

#include <string>

#include "bridge/geometry/point.hpp"

namespace blockweir::geometry {

/// "(x, y)" in four digits; a coordinate below 1e-5 of `size_m` is 0, as strain and round-off move blocks by as much.
std::string place_text(const Point& place, double size_m);

/// A number as it is printed, without the sign of a zero: "-0.0" is "0.0".
std::string without_signed_zero(std::string number);

}  // namespace blockweir::geometry
